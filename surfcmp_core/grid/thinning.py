"""Fewer nodes of the same surface: at random, or to a spacing."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.errors import InputError
from surfcmp_core.surface import Surface
from surfcmp_core.surface.refusals import refuse_surface


def thin_random(surface: Surface, keep: float, *, seed: int = 0) -> Surface:
    """Keep a share of the nodes, each as likely as the other.

    Parameters
    ----------
    surface : Surface
    keep : float
        Share to keep, 0 < keep ≤ 1; exactly ``round(keep * n)`` nodes stay.
    seed : int
        The same seed keeps the same nodes.

    Returns
    -------
    Surface
        A cloud, for a mesh without most of its nodes has no triangles left to speak of; its nodes
        bit for bit and in their order; "thinned" counts the others in `dropped`.

    Raises
    ------
    InputError
        `keep` out of range.
    """
    if not 0.0 < keep <= 1.0:
        raise InputError(f"cannot keep a share of {keep:g} of the nodes", where=(surface.name,))
    n = len(surface.points)
    chosen = np.random.default_rng(seed).permutation(n)[: round(keep * n)]
    return _kept(surface, chosen)


def thin_to_spacing(surface: Surface, spacing: float, *, seed: int = 0) -> Surface:
    """Keep nodes of which no two are nearer to each other in space than a spacing.

    Nodes are visited in random order and kept where none kept before is too near: what stays is
    evenly spread, and every node dropped has a kept one within the spacing.

    Parameters
    ----------
    surface : Surface
    spacing : float
        In the surface's unit; positive.
    seed : int
        The same seed keeps the same nodes.

    Returns
    -------
    Surface
        As that of :func:`thin_random`.

    Raises
    ------
    InputError
        `spacing` is not positive and finite.
    """
    if not (np.isfinite(spacing) and spacing > 0.0):
        raise InputError(f"cannot thin to a spacing of {spacing:g}", where=(surface.name,))
    refuse_surface(surface)
    from_corner = surface.points - surface.points.min(axis=0)
    # cells at least a spacing wide, and no more of them along an axis than a key can count
    cell = max(spacing, float(from_corner.max(initial=0.0)) / 2.0**20)
    places = (from_corner / cell).astype(np.int64) + 1
    keys = (places[:, 0] << 42) | (places[:, 1] << 21) | places[:, 2]
    cells, cell_of = np.unique(keys, return_inverse=True)
    steps = np.arange(-1, 2)
    around = ((steps[:, None, None] << 42) + (steps[:, None] << 21) + steps).ravel()
    beside = np.searchsorted(cells, cells[:, None] + around)
    beside[cells[np.minimum(beside, len(cells) - 1)] != cells[:, None] + around] = -1
    order = np.random.default_rng(seed).permutation(len(from_corner))
    return _kept(surface, np.flatnonzero(_spread(surface.points, order, cell_of, beside, spacing)))


def _kept(surface: Surface, nodes: NDArray[np.int64]) -> Surface:
    dropped = dict(surface.dropped)
    gone = len(surface.points) - len(nodes)
    if gone:
        dropped["thinned"] = dropped.get("thinned", 0) + gone
    return replace(surface, points=surface.points[np.sort(nodes)], faces=None, dropped=dropped)


@kernel
def _spread(
    points: NDArray[np.float64],
    order: NDArray[np.int64],
    cell_of: NDArray[np.int64],
    beside: NDArray[np.int64],
    spacing: float,
) -> NDArray[np.bool_]:
    keep = np.zeros(points.shape[0], np.bool_)
    first = np.full(beside.shape[0], -1, np.int64)
    following = np.full(points.shape[0], -1, np.int64)
    for node in order:
        free = True
        for cell in beside[cell_of[node]]:
            other = first[cell] if cell >= 0 else -1
            while other >= 0 and free:
                x = points[other, 0] - points[node, 0]
                y = points[other, 1] - points[node, 1]
                z = points[other, 2] - points[node, 2]
                free = x * x + y * y + z * z >= spacing * spacing
                other = following[other]
            if not free:
                break
        if free:
            keep[node] = True
            following[node] = first[cell_of[node]]
            first[cell_of[node]] = node
    return keep
