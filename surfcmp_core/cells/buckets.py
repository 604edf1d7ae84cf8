"""Triangles sorted into cells, to ask which places they cover."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.cells.bed import Bed, bed_over, in_cells
from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates import orientation


class Buckets(NamedTuple):
    """Faces sorted into cells.

    Attributes
    ----------
    nodes : (n, 2) float64
    faces : (m, 3) int32
    bed : Bed
        Over the faces.
    start : (cells + 1,) int64
        Where each cell's faces begin in `members`.
    members : int32
    """

    nodes: NDArray[np.float64]
    faces: NDArray[np.int32]
    bed: Bed
    start: NDArray[np.int64]
    members: NDArray[np.int32]


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
    bed = bed_over(used.min(axis=0), used.max(axis=0), float(max(len(faces), 16)))
    return Buckets(nodes, faces, bed, *in_cells(bed, nodes, faces, np.arange(len(faces))))


@kernel
def _covered(buckets: Buckets, queries: NDArray[np.float64], covered: NDArray[np.bool_]) -> None:
    nodes, faces, bed, start, members = buckets
    for k in range(queries.shape[0]):
        px, py = queries[k, 0], queries[k, 1]
        covered[k] = False
        if px < bed.x0 or py < bed.y0:
            continue
        right, up = (px - bed.x0) * bed.per_cell, (py - bed.y0) * bed.per_cell
        if not (right < bed.columns and up < bed.rows):  # asked before it is too much for an int
            continue
        cell = int(up) * bed.columns + int(right)
        for m in range(start[cell], start[cell + 1]):
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
    _covered(buckets, queries, covered)
    return covered
