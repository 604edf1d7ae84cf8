"""Square cells over a projected mesh, and in which of them it may lie in several layers."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.cells.bed import Bed, bed_over, extent, in_cells
from surfcmp_core.compiled.kernel import kernel

_IN_EACH = 4
"""Triangles in a cell, on average."""


class Cells(NamedTuple):
    """Cells over a mesh.

    Attributes
    ----------
    bed : Bed
    doubtful : (rows, columns) bool
        False where triangles lie in one layer at most, for certain.
    """

    bed: Bed
    doubtful: NDArray[np.bool_]


@kernel
def _mark(
    bed: Bed,
    nodes: NDArray[np.float64],
    border: NDArray[np.int64],
    doubtful: NDArray[np.bool_],
    layers: NDArray[np.int32],
) -> None:
    """Mark cells near the border; count layers at the middle of each cell, from left to right."""
    x0, y0, per_cell, rows, columns = bed
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
    low, high = outermost.min(axis=(0, 1)), outermost.max(axis=(0, 1))
    bed = bed_over(low, high, triangles / _IN_EACH + 1.0)
    doubtful = np.zeros((bed.rows, bed.columns), bool)
    _mark(bed, nodes, border, doubtful, np.zeros(doubtful.shape, np.int32))
    return Cells(bed, doubtful)


@kernel
def _touching(
    cells: Cells,
    nodes: NDArray[np.float64],
    faces: NDArray[np.int32],
    counts: NDArray[np.bool_],
    candidates: NDArray[np.bool_],
) -> None:
    """Mark the triangles, of those that count, that may touch a doubtful cell."""
    bed, doubtful = cells
    for t in range(faces.shape[0]):
        if counts[t]:
            r0, r1, c0, c1 = extent(bed, nodes, faces, t)
            for r in range(r0, r1 + 1):
                for c in range(c0, c1 + 1):
                    candidates[t] = candidates[t] or doubtful[r, c]


def crowded(
    nodes: NDArray[np.float64],
    faces: NDArray[np.int32],
    counts: NDArray[np.bool_],
    cells: Cells,
) -> tuple[NDArray[np.int64], NDArray[np.int32]]:
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
    start, members
        Triangles of each cell, as :func:`surfcmp_core.cells.bed.in_cells` gives them.
    """
    candidates = np.zeros(len(faces), bool)
    _touching(cells, nodes, faces, counts, candidates)
    return in_cells(cells.bed, nodes, faces, np.flatnonzero(candidates))
