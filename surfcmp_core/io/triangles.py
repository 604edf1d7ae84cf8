"""Polygons as triangles: fans where a fan covers the polygon, ears cut off where none does."""

import numpy as np
from mapbox_earcut import triangulate_float64
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.io.polygons import Polygons

_BLOCK = 1 << 17
"""Corners that are looked at at once."""
_NOTHING = 1e-12
"""Area, as a share of the square around a polygon, that is rounding: corners in one line."""
_MOST = 10_000
"""Corners of a polygon that no fan covers: the time to cut ears off grows with their square."""
_PATIENCE = 5 * 10**7
"""Squared corners of all polygons that cross themselves before the file is refused for them."""

TOO_FEW = "faces with fewer than three corners"
SPLIT = "polygons split into triangles"
TWICE = "faces that name a node twice"
CROSSING = "polygons that cross themselves, left out"


def triangulate(
    polygons: Polygons, points: NDArray[np.float64]
) -> tuple[NDArray[np.int32] | None, dict[str, int]]:
    """Split polygons into triangles that cover them once.

    A polygon is seen along the normal of its best plane (Newell's). Where the triangles from its
    first corner to all its edges lie side by side there, as those of every convex one do, they are
    taken; else ears are cut off it.

    Parameters
    ----------
    polygons : list of (k, c) int64
        Flat or nearly, of any shape, without holes.
    points : (n, 3) float64
        The nodes; those of no polygon may be anything.

    Returns
    -------
    faces : (m, 3) int32 or None
        Turned as their polygons are; None where no triangle is left.
    changed : dict of str to int
        Polygons split and faces left out, counted by reason.

    Raises
    ------
    InputError
        Where a corner names a node that is not there, or a polygon is too large to be split.
    """
    changed = dict.fromkeys((TOO_FEW, SPLIT, TWICE, CROSSING), 0)
    triangles = [np.empty((0, 3), np.int32)]
    taken = 0
    for group in polygons:
        if group.size == 0 or group.shape[1] < 3:
            changed[TOO_FEW] += len(group)
            continue
        low, high = int(group.min()), int(group.max())
        if low < 0 or high >= len(points):
            odd = low if low < 0 else high
            raise InputError(f"a face names node {odd}, but the nodes are 0 to {len(points) - 1}")
        corners = group.astype(np.int32, copy=False)
        if group.shape[1] == 3:
            triangles.append(corners)
            continue
        changed[SPLIT] += len(group)
        block = max(1, _BLOCK // group.shape[1])
        for first in range(0, len(group), block):
            split, crossing = _split(corners[first : first + block], points)
            triangles += split
            changed[CROSSING] += crossing
            taken += crossing * group.shape[1] ** 2
            if taken > _PATIENCE:
                raise InputError(f"polygons of {group.shape[1]} corners cross themselves")
    changed[SPLIT] -= changed[CROSSING]
    faces = triangles[1] if len(triangles) == 2 else np.concatenate(triangles)
    a, b, c = faces.T
    flat = (a == b) | (b == c) | (c == a)
    changed[TWICE] = int(np.count_nonzero(flat))
    if changed[TWICE]:
        faces = faces[~flat]
    return faces if len(faces) else None, {why: count for why, count in changed.items() if count}


def _split(
    group: NDArray[np.int32], points: NDArray[np.float64]
) -> tuple[list[NDArray[np.int32]], int]:
    """Triangles of some polygons of c corners each, and how many cross themselves."""
    from surfcmp_core.compiled.linear_algebra import dots, lengths

    k, c = group.shape
    places = points[group] - points[group[:, :1]]
    size = np.abs(places).max(axis=(1, 2))
    places /= np.where(size > 0, size, 1.0)[:, None, None]
    normals = np.cross(places[:, 1:-1], places[:, 2:])  # of the fan's triangles, twice their area
    axes = normals.sum(axis=1)
    length = lengths(axes)
    axes /= np.where(length > 0, length, 1.0)[:, None]
    heights = dots(normals, axes[:, None])
    # all to one side, and less than once around the first corner: they lie side by side
    fanned = (heights >= -_NOTHING).all(axis=1)
    if c > 4:
        flat = places - dots(places, axes[:, None])[:, :, None] * axes[:, None]
        along = dots(flat[:, 1:-1], flat[:, 2:])
        fanned &= np.arctan2(heights, along).sum(axis=1) <= 2.0 * np.pi + _NOTHING
    in_line = length <= _NOTHING
    fanned &= ~in_line | (lengths(normals) <= _NOTHING).all(axis=1)
    fanned |= ~np.isfinite(length)  # refused soon for its nodes
    first = np.broadcast_to(group[:, :1], (k, c - 2))
    triangles = [np.stack((first, group[:, 1:-1], group[:, 2:]), axis=2)[fanned].reshape(-1, 3)]
    crossing = 0
    for i in np.flatnonzero(~fanned).tolist():
        # of a polygon that does not cross itself no more than a few corners are at one node
        crosses = in_line[i] or 2 * len(np.unique(group[i])) < c
        ears = None if crosses else _ears(places[i], axes[i], float(length[i]))
        if ears is not None:
            triangles.append(group[i][ears])
        else:
            crossing += 1
    return triangles, crossing


def _ears(
    places: NDArray[np.float64], axis: NDArray[np.float64], area: float
) -> NDArray[np.int64] | None:
    """Triangles of one polygon seen along an axis, as corners of it; None where it crosses itself.

    [Held2001], as the library cuts them; their areas tell whether they cover it once.
    """
    from surfcmp_core.compiled.linear_algebra import dots, length

    if len(places) > _MOST:
        raise InputError(f"a polygon of {len(places)} corners that is not convex is not read")
    right = np.cross(np.eye(3)[np.argmin(np.abs(axis))], axis)
    right /= length(right)
    flat = np.column_stack((dots(places, right), dots(places, np.cross(axis, right))))
    ears = triangulate_float64(flat, np.array([len(flat)], np.uint32)).reshape(-1, 3)
    ears = ears.astype(np.int64)
    (ax, ay), (bx, by), (cx, cy) = (flat[ears[:, i]].T for i in range(3))
    twice = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    if abs(float(np.abs(twice).sum()) - area) > 1e-9 or _turns(flat) > 1.5:
        return None
    return np.where((twice < 0)[:, None], ears[:, ::-1], ears)


def _turns(flat: NDArray[np.float64]) -> float:
    """How often the border of a polygon turns round; where it turns back, less than that."""
    edges = np.roll(flat, -1, axis=0) - flat
    edges = edges[(edges != 0.0).any(axis=1)]
    onward = np.roll(edges, -1, axis=0)
    across = edges[:, 0] * onward[:, 1] - edges[:, 1] * onward[:, 0]
    along = (edges * onward).sum(axis=1)
    turn = np.arctan2(across, along)
    return float(turn[np.abs(turn) < np.pi - 1e-9].sum()) / (2.0 * np.pi)
