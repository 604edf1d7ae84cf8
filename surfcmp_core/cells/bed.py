"""Square cells of one size over a part of the plane, and triangles sorted into them."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel


class Bed(NamedTuple):
    """Where cells lie; that in a row and a column is number ``row * columns + column``.

    Attributes
    ----------
    x0, y0 : float
        Lower left corner of all.
    per_cell : float
        Cells in a unit of length.
    rows, columns : int
    """

    x0: float
    y0: float
    per_cell: float
    rows: int
    columns: int


def laid_over(low: NDArray[np.float64], high: NDArray[np.float64], per_cell: float) -> Bed:
    """Lay cells of a given size over a box.

    Parameters
    ----------
    low, high : (2,) float64
        Its corners.
    per_cell : float
        Cells in a unit of length.

    Returns
    -------
    Bed
    """
    width, height = (high - low).tolist()
    rows, columns = int(height * per_cell) + 1, int(width * per_cell) + 1
    return Bed(float(low[0]), float(low[1]), per_cell, rows, columns)


def bed_over(low: NDArray[np.float64], high: NDArray[np.float64], wanted: float) -> Bed:
    """Lay about as many cells as wanted over a box (see :func:`laid_over`)."""
    width, height = (high - low).tolist()
    # square cells, but along a thin strip no more than wanted
    side = max(math.sqrt(width * height / wanted), max(width, height) / wanted)
    return laid_over(low, high, 1.0 / side if side > 0.0 else 0.0)


@kernel
def extent(
    bed: Bed, nodes: NDArray[np.float64], faces: NDArray[np.int32], t: int
) -> tuple[int, int, int, int]:
    """First and last row and column of the cells that a triangle may touch, none outside."""
    a, b, c = faces[t, 0], faces[t, 1], faces[t, 2]
    left = min(nodes[a, 0], nodes[b, 0], nodes[c, 0])
    right = max(nodes[a, 0], nodes[b, 0], nodes[c, 0])
    low = min(nodes[a, 1], nodes[b, 1], nodes[c, 1])
    high = max(nodes[a, 1], nodes[b, 1], nodes[c, 1])
    return (
        int(min(max((low - bed.y0) * bed.per_cell, 0.0), float(bed.rows))),
        int(min(max((high - bed.y0) * bed.per_cell, -1.0), bed.rows - 1.0)),
        int(min(max((left - bed.x0) * bed.per_cell, 0.0), float(bed.columns))),
        int(min(max((right - bed.x0) * bed.per_cell, -1.0), bed.columns - 1.0)),
    )


@kernel
def in_cells(
    bed: Bed, nodes: NDArray[np.float64], faces: NDArray[np.int32], some: NDArray[np.int64]
) -> tuple[NDArray[np.int64], NDArray[np.int32]]:
    """Sort triangles into the cells that they may touch, in linear time.

    Parameters
    ----------
    bed : Bed
    nodes : (n, 2) float64
    faces : (m, 3) int32
    some : (k,) int64
        Which of them.

    Returns
    -------
    start : (cells + 1,) int64
        Where each cell's triangles begin in `members`.
    members : int32
        Triangles in the order given; one that reaches into several cells stands in each.
    """
    start = np.zeros(bed.rows * bed.columns + 1, np.int64)
    for t in some:
        r0, r1, c0, c1 = extent(bed, nodes, faces, t)
        for r in range(r0, r1 + 1):
            for c in range(c0, c1 + 1):
                start[r * bed.columns + c + 1] += 1
    for cell in range(start.size - 1):
        start[cell + 1] += start[cell]
    members = np.empty(start[-1], np.int32)
    following = start.copy()
    for t in some:
        r0, r1, c0, c1 = extent(bed, nodes, faces, t)
        for r in range(r0, r1 + 1):
            for c in range(c0, c1 + 1):
                cell = r * bed.columns + c
                members[following[cell]] = t
                following[cell] += 1
    return start, members
