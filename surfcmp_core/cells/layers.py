"""Square cells over a projected mesh, and in which of them it may lie in several layers."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel

_IN_EACH = 4
"""Triangles in a cell, on average."""


@dataclass(frozen=True, slots=True, eq=False)
class Cells:
    """Cells of one size over the plane.

    Attributes
    ----------
    x0, y0 : float
        Lower left corner of all.
    per_cell : float
        Cells in a unit of length.
    doubtful : (rows, columns) bool
        False where triangles lie in one layer at most, for certain.
    """

    x0: float
    y0: float
    per_cell: float
    doubtful: NDArray[np.bool_]


@kernel
def _mark(
    nodes: NDArray[np.float64],
    border: NDArray[np.int64],
    x0: float,
    y0: float,
    per_cell: float,
    doubtful: NDArray[np.bool_],
    layers: NDArray[np.int32],
) -> None:
    """Mark cells near the border; count layers at the middle of each cell, from left to right."""
    rows, columns = doubtful.shape
    for e in range(border.shape[0]):
        ax = (nodes[border[e, 0], 0] - x0) * per_cell
        ay = (nodes[border[e, 0], 1] - y0) * per_cell
        bx = (nodes[border[e, 1], 0] - x0) * per_cell
        by = (nodes[border[e, 1], 1] - y0) * per_cell
        for row in range(int(min(ay, by)), min(int(max(ay, by)), rows - 1) + 1):
            if ay == by:
                left, right = min(ax, bx), max(ax, bx)
            else:
                wide, high = bx - ax, by - ay  # shares of them do not overflow as a slope may
                foot = (min(max(float(row), min(ay, by)), max(ay, by)) - ay) / high
                head = (min(max(row + 1.0, min(ay, by)), max(ay, by)) - ay) / high
                at_foot, at_head = ax + foot * wide, ax + head * wide
                left, right = min(at_foot, at_head), max(at_foot, at_head)
                middle = row + 0.5
                if (ay <= middle) != (by <= middle):
                    crossing = ax + (middle - ay) / high * wide
                    first = max(0, int(np.ceil(crossing - 0.5)))
                    if first < columns:
                        # the mesh lies on the left of an edge: to the right of one that goes down
                        layers[row, first] += 1 if by < ay else -1
            for r in range(max(row - 1, 0), min(row + 2, rows)):
                for c in range(max(int(left) - 1, 0), min(int(right) + 2, columns)):
                    doubtful[r, c] = True
    for row in range(rows):
        count = 0
        for c in range(columns):
            count += layers[row, c]
            if count > 1:
                doubtful[row, c] = True


def cells_over(nodes: NDArray[np.float64], border: NDArray[np.int64], triangles: int) -> Cells:
    """Lay cells over a mesh whose triangles all turn counter-clockwise.

    The number of its layers at a place is how often its border winds around that place. So cells
    that no border edge comes near, and around which the border winds once, need no second look.

    Parameters
    ----------
    nodes : (n, 2) float64
    border : (e, 2) int64
        Border edges in node numbers, the mesh on their left.
    triangles : int
        How many there are: it sets the cells' size.

    Returns
    -------
    Cells
    """
    outermost = nodes[border]
    x0, y0 = outermost.min(axis=(0, 1)).tolist()
    wide, high = np.ptp(outermost, axis=(0, 1)).tolist()
    wanted = triangles / _IN_EACH + 1.0
    # square cells, but along a thin strip no more than wanted
    side = max(math.sqrt(wide * high / wanted), max(wide, high) / wanted)
    per_cell = 1.0 / side if side > 0.0 else 0.0
    shape = int(high * per_cell) + 1, int(wide * per_cell) + 1
    doubtful = np.zeros(shape, bool)
    _mark(nodes, border, x0, y0, per_cell, doubtful, np.zeros(shape, np.int32))
    return Cells(x0, y0, per_cell, doubtful)


@kernel
def extent(
    nodes: NDArray[np.float64],
    faces: NDArray[np.int32],
    t: int,
    x0: float,
    y0: float,
    per_cell: float,
    shape: tuple[int, int],
) -> tuple[int, int, int, int]:
    """First and last row and column of the cells that a triangle may touch, none outside."""
    a, b, c = faces[t, 0], faces[t, 1], faces[t, 2]
    left = min(nodes[a, 0], nodes[b, 0], nodes[c, 0])
    right = max(nodes[a, 0], nodes[b, 0], nodes[c, 0])
    low = min(nodes[a, 1], nodes[b, 1], nodes[c, 1])
    high = max(nodes[a, 1], nodes[b, 1], nodes[c, 1])
    return (
        int(min(max((low - y0) * per_cell, 0.0), float(shape[0]))),
        int(min(max((high - y0) * per_cell, -1.0), shape[0] - 1.0)),
        int(min(max((left - x0) * per_cell, 0.0), float(shape[1]))),
        int(min(max((right - x0) * per_cell, -1.0), shape[1] - 1.0)),
    )


@kernel
def _count(
    nodes: NDArray[np.float64],
    faces: NDArray[np.int32],
    counts: NDArray[np.bool_],
    x0: float,
    y0: float,
    per_cell: float,
    doubtful: NDArray[np.bool_],
    start: NDArray[np.int64],
    candidates: NDArray[np.bool_],
) -> None:
    for t in range(faces.shape[0]):
        if not counts[t]:
            continue
        r0, r1, c0, c1 = extent(nodes, faces, t, x0, y0, per_cell, doubtful.shape)
        found = False
        for r in range(r0, r1 + 1):
            for c in range(c0, c1 + 1):
                found = found or doubtful[r, c]
        if found:
            candidates[t] = True
            for r in range(r0, r1 + 1):
                for c in range(c0, c1 + 1):
                    start[r * doubtful.shape[1] + c + 1] += 1


@kernel
def _fill(
    nodes: NDArray[np.float64],
    faces: NDArray[np.int32],
    candidates: NDArray[np.int64],
    x0: float,
    y0: float,
    per_cell: float,
    shape: tuple[int, int],
    following: NDArray[np.int64],
    members: NDArray[np.int64],
) -> None:
    for t in candidates:
        r0, r1, c0, c1 = extent(nodes, faces, t, x0, y0, per_cell, shape)
        for r in range(r0, r1 + 1):
            for c in range(c0, c1 + 1):
                cell = r * shape[1] + c
                members[following[cell]] = t
                following[cell] += 1


def crowded(
    nodes: NDArray[np.float64],
    faces: NDArray[np.int32],
    counts: NDArray[np.bool_],
    cells: Cells,
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Sort the triangles that may overlap others into cells.

    Parameters
    ----------
    nodes : (n, 2) float64
    faces : (m, 3) int32
    counts : (m,) bool
        Which triangles count.
    cells : Cells

    Returns
    -------
    start : (cells + 1,) int64
        Where each cell's triangles begin in `members`.
    members : (k,) int64
        Triangles; one that reaches into several cells stands in each.
    """
    shape = cells.doubtful.shape
    where = (cells.x0, cells.y0, cells.per_cell)
    start = np.zeros(cells.doubtful.size + 1, np.int64)
    candidates = np.zeros(len(faces), bool)
    _count(nodes, faces, counts, *where, cells.doubtful, start, candidates)
    np.cumsum(start, out=start)
    members = np.empty(int(start[-1]), np.int64)
    _fill(nodes, faces, np.flatnonzero(candidates), *where, shape, start[:-1].copy(), members)
    return start, members
