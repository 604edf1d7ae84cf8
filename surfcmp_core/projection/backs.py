"""Triangles that show their other side, and may lie in front of what is looked at."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.cells.bed import extent
from surfcmp_core.cells.doubtful import Cells
from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.projection.islands import drop_islands
from surfcmp_core.projection.removed import Fate

_KEPT = int(Fate.KEPT)


def backs_that_hide(
    faces: NDArray[np.int32],
    area: NDArray[np.float64],
    fate: NDArray[np.uint8],
    island: float,
    nodes: int,
) -> NDArray[np.bool_] | None:
    """Give the triangles that show their other side and hide what lies behind them.

    Parameters
    ----------
    faces : (m, 3) int32
        Those that meet in space meet in node numbers.
    area : (m,) float64
    fate : (m,) uint8
    island : float
        Pieces with less than this share of the largest piece's area are debris and hide nothing.
    nodes : int
        How many there are.

    Returns
    -------
    (m,) bool or None
        None where there are none.
    """
    back = fate == Fate.BACK_FACING
    if not back.any():
        return None
    of_piece = np.where(back, np.uint8(Fate.KEPT), fate)
    drop_islands(faces, area, island, np.empty(nodes, np.int32), of_piece)
    return np.asarray(back & (of_piece == Fate.KEPT))


@kernel
def _mark_backs(
    nodes: NDArray[np.float64],
    z: NDArray[np.float64],
    faces: NDArray[np.int32],
    fate: NDArray[np.uint8],
    backs: NDArray[np.bool_],
    cells: Cells,
    above: NDArray[np.bool_],
) -> None:
    bed, doubtful = cells
    lowest = np.full(doubtful.shape, np.inf)
    for t in range(faces.shape[0]):
        if fate[t] == _KEPT:
            low = min(z[faces[t, 0]], z[faces[t, 1]], z[faces[t, 2]])
            r0, r1, c0, c1 = extent(bed, nodes, faces, t)
            for r in range(r0, r1 + 1):
                for c in range(c0, c1 + 1):
                    lowest[r, c] = min(lowest[r, c], low)
    for t in range(faces.shape[0]):
        if backs[t]:
            top = max(z[faces[t, 0]], z[faces[t, 1]], z[faces[t, 2]])
            r0, r1, c0, c1 = extent(bed, nodes, faces, t)
            for r in range(r0, r1 + 1):
                for c in range(c0, c1 + 1):
                    if top > lowest[r, c]:
                        doubtful[r, c] = True
                        above[t] = True


def doubt_backs(
    nodes: NDArray[np.float64],
    z: NDArray[np.float64],
    faces: NDArray[np.int32],
    fate: NDArray[np.uint8],
    backs: NDArray[np.bool_],
    cells: Cells,
) -> NDArray[np.bool_]:
    """Give the backs that reach above the lowest of what is kept, and doubt the cells where."""
    above = np.zeros(len(faces), np.bool_)
    _mark_backs(nodes, z, faces, fate, backs, cells, above)
    return above
