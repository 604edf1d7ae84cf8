"""A grid of square cells over triangles, to ask which places they cover."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates import orientation


@dataclass(frozen=True, slots=True, eq=False)
class Buckets:
    """Faces sorted into cells.

    Attributes
    ----------
    nodes : (n, 2) float64
    faces : (m, 3) int32
    x0, y0, per_cell : float
        Corner of the cells and cells for each unit of length.
    columns, rows : int
    first : (columns * rows + 1,) int64
        Where each cell's faces start in `members`.
    members : int32
    """

    nodes: NDArray[np.float64]
    faces: NDArray[np.int32]
    x0: float
    y0: float
    per_cell: float
    columns: int
    rows: int
    first: NDArray[np.int64]
    members: NDArray[np.int32]


@kernel
def _sort(
    nodes: NDArray[np.float64],
    faces: NDArray[np.int32],
    x0: float,
    y0: float,
    per_cell: float,
    columns: int,
    rows: int,
    first: NDArray[np.int64],
    members: NDArray[np.int32],
) -> None:
    """Count the members of the cells into `first`; with room in `members`, fill them in too."""
    filling = members.size > 0
    for f in range(faces.shape[0]):
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        left = int((min(nodes[a, 0], nodes[b, 0], nodes[c, 0]) - x0) * per_cell)
        right = int((max(nodes[a, 0], nodes[b, 0], nodes[c, 0]) - x0) * per_cell)
        low = int((min(nodes[a, 1], nodes[b, 1], nodes[c, 1]) - y0) * per_cell)
        high = int((max(nodes[a, 1], nodes[b, 1], nodes[c, 1]) - y0) * per_cell)
        for row in range(low, min(high, rows - 1) + 1):
            for column in range(left, min(right, columns - 1) + 1):
                cell = row * columns + column
                if filling:
                    members[first[cell]] = f
                    first[cell] += 1
                else:
                    first[cell + 1] += 1


def buckets_of(nodes: NDArray[np.float64], faces: NDArray[np.int32]) -> Buckets:
    """Sort faces into about as many cells, in linear time.

    Parameters
    ----------
    nodes : (n, 2) float64
    faces : (m, 3) int32
        Any triangles, turned either way; m > 0.

    Returns
    -------
    Buckets
    """
    used = nodes[faces.reshape(-1)]
    x0, y0 = used.min(axis=0)
    width, height = used.max(axis=0) - (x0, y0)
    cells = float(max(len(faces), 16))
    side = max(float(np.sqrt(width) * np.sqrt(height) / np.sqrt(cells)), max(width, height) / cells)
    per_cell = 1.0 / side if side > 0.0 else 0.0
    columns, rows = int(width * per_cell) + 1, int(height * per_cell) + 1
    first = np.zeros(columns * rows + 1, np.int64)
    members = np.empty(0, np.int32)
    _sort(nodes, faces, x0, y0, per_cell, columns, rows, first, members)
    np.cumsum(first, out=first)
    members = np.empty(first[-1], np.int32)
    fill = first.copy()
    _sort(nodes, faces, x0, y0, per_cell, columns, rows, fill, members)
    return Buckets(nodes, faces, float(x0), float(y0), per_cell, columns, rows, first, members)


@kernel
def _covered(
    nodes: NDArray[np.float64],
    faces: NDArray[np.int32],
    x0: float,
    y0: float,
    per_cell: float,
    columns: int,
    rows: int,
    first: NDArray[np.int64],
    members: NDArray[np.int32],
    queries: NDArray[np.float64],
    covered: NDArray[np.bool_],
) -> None:
    for k in range(queries.shape[0]):
        px, py = queries[k, 0], queries[k, 1]
        covered[k] = False
        if px < x0 or py < y0:
            continue
        right, up = (px - x0) * per_cell, (py - y0) * per_cell
        if not (right < columns and up < rows):  # asked before it may be too much for an integer
            continue
        cell = int(up) * columns + int(right)
        for m in range(first[cell], first[cell + 1]):
            f = members[m]
            ax, ay = nodes[faces[f, 0], 0], nodes[faces[f, 0], 1]
            bx, by = nodes[faces[f, 1], 0], nodes[faces[f, 1], 1]
            cx, cy = nodes[faces[f, 2], 0], nodes[faces[f, 2], 1]
            ab = orientation(ax, ay, bx, by, px, py)
            bc = orientation(bx, by, cx, cy, px, py)
            ca = orientation(cx, cy, ax, ay, px, py)
            inside = (ab >= 0.0 and bc >= 0.0 and ca >= 0.0) or (
                ab <= 0.0 and bc <= 0.0 and ca <= 0.0
            )
            if inside and not (ab == 0.0 and bc == 0.0 and ca == 0.0):
                covered[k] = True
                break


def covered_by(buckets: Buckets, queries: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Tell which places lie under a face, borders included; exact.

    Parameters
    ----------
    buckets : Buckets
    queries : (k, 2) float64

    Returns
    -------
    (k,) bool
    """
    covered = np.empty(len(queries), np.bool_)
    _covered(
        buckets.nodes,
        buckets.faces,
        buckets.x0,
        buckets.y0,
        buckets.per_cell,
        buckets.columns,
        buckets.rows,
        buckets.first,
        buckets.members,
        queries,
        covered,
    )
    return covered
