"""Unstructured, even scatters of nodes of a wanted density, and meshes over them."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter
from scipy.spatial import Delaunay, cKDTree

Array = NDArray[np.float64]
Height = Callable[[Array, Array], Array]
Inside = Callable[[Array, Array], NDArray[np.bool_]]
Box = tuple[float, float, float, float]
"""x from, x to, y from, y to."""


def roughness(height: Height, box: Box, cell: float, contrast: float) -> Height:
    """How densely to sample a height field: by its curvature, from 1 to `contrast`."""
    x, y = np.arange(box[0], box[1] + cell, cell), np.arange(box[2], box[3] + cell, cell)
    z = height(*np.meshgrid(x, y))
    gy, gx = np.gradient(z, cell)
    bend = sum(np.gradient(g, cell)[k] ** 2 for g in (gx, gy) for k in (0, 1))
    smooth = gaussian_filter(np.minimum(np.sqrt(bend), 1.0), 2)
    density = np.clip(smooth / np.percentile(smooth, 30), 1, contrast)

    def at(px: Array, py: Array) -> Array:
        i = np.clip(np.rint((py - box[2]) / cell).astype(int), 0, len(y) - 1)
        j = np.clip(np.rint((px - box[0]) / cell).astype(int), 0, len(x) - 1)
        return np.asarray(density[i, j])

    return at


def scatter(
    count: int, box: Box, inside: Inside, density: Height, rng: np.random.Generator, rounds: int
) -> Array:
    """(count, 2) nodes inside, as dense as `density` asks, evened by Lloyd's relaxation."""
    found: list[Array] = []
    while sum(map(len, found)) < 30 * count:
        xy = rng.uniform((box[0], box[2]), (box[1], box[3]), (60 * count, 2))
        xy = xy[inside(xy[:, 0], xy[:, 1])]
        weight = density(xy[:, 0], xy[:, 1])
        found.append(xy[rng.random(len(xy)) < weight / weight.max()])
    cloud = np.concatenate(found)[: 30 * count]
    nodes = cloud[:count]
    for _ in range(rounds):
        owner = cKDTree(nodes).query(cloud)[1]
        share = np.maximum(np.bincount(owner, minlength=count), 1)
        nodes = np.stack([np.bincount(owner, c, count) / share for c in cloud.T], axis=1)
    return nodes[inside(nodes[:, 0], nodes[:, 1])]


def rounded(values: Array, quantum: float) -> Array:
    """Values on a coarse binary lattice: the same on every machine, and exact in float32."""
    return np.rint(values / quantum) * quantum


def mesh(nodes: Array, inside: Inside) -> tuple[Array, NDArray[np.int32]]:
    """Delaunay triangles of the nodes cut to the outline; nodes without a triangle are left out."""
    centre = nodes.mean(axis=0)
    faces = Delaunay(nodes - centre).simplices.astype(np.int32)
    a, b, c = (nodes[faces[:, k]] for k in range(3))
    turn = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    faces = np.where(turn[:, None] < 0, faces[:, ::-1], faces)
    middle = (a + b + c) / 3
    edges = np.stack([np.hypot(*(p - q).T) for p, q in ((a, b), (b, c), (c, a))])
    spacing = cKDTree(nodes).query(nodes, 4)[0][:, 1:].mean(axis=1)
    near = spacing[faces].max(axis=1)
    circumradius = edges.prod(axis=0) / (2 * np.abs(turn))
    faces = faces[inside(middle[:, 0], middle[:, 1]) & (circumradius < 1.5 * near)]
    used, faces = np.unique(faces, return_inverse=True)
    faces = faces.reshape(-1, 3)
    first = faces.argmin(axis=1)[:, None]
    faces = np.take_along_axis(faces, (first + np.arange(3)) % 3, axis=1)
    return nodes[used], faces[np.lexsort(faces.T[::-1])].astype(np.int32)
