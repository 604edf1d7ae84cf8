"""Small pieces that hang together with nothing else."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.projection.removed import Fate

_KEPT = int(Fate.KEPT)
_ISLAND = int(Fate.ISLAND)


@kernel
def _root(parent: NDArray[np.int32], node: int) -> int:
    while parent[node] != node:
        parent[node] = parent[parent[node]]
        node = parent[node]
    return node


@kernel
def join_pieces(faces: NDArray[np.int32], fate: NDArray[np.uint8], piece: NDArray[np.int32]) -> int:
    """Find what hangs together: triangles that share a node belong to one piece.

    Parameters
    ----------
    faces : (m, 3) int32
    fate : (m,) uint8
        Only KEPT ones count.
    piece : (n,) int32
        Set to the smallest node of the piece that each node belongs to; -1 where it has no
        triangle.

    Returns
    -------
    int
        How many pieces there are.
    """
    piece[:] = -1
    pieces = 0
    for t in range(faces.shape[0]):
        if fate[t] == _KEPT:
            for i in range(3):
                node = faces[t, i]
                if piece[node] < 0:
                    piece[node] = node
                    pieces += 1
            a = piece[faces[t, 0]]
            if a == piece[faces[t, 1]] and a == piece[faces[t, 2]]:
                continue
            a = _root(piece, a)
            for i in range(1, 3):
                b = _root(piece, faces[t, i])
                if a != b:
                    piece[max(a, b)] = min(a, b)
                    a = min(a, b)
                    pieces -= 1
    for node in range(piece.size):  # a parent's number is below its child's
        if piece[node] >= 0:
            piece[node] = piece[piece[node]]
    return pieces


@kernel
def drop_islands(
    faces: NDArray[np.int32],
    area: NDArray[np.float64],
    share: float,
    piece: NDArray[np.int32],
    fate: NDArray[np.uint8],
) -> None:
    """Mark the pieces that are small beside the largest one.

    Parameters
    ----------
    faces : (m, 3) int32
    area : (m,) float64
    share : float
        Pieces below this share of the largest one's area go.
    piece : (n,) int32
        Room to work in.
    fate : (m,) uint8
        Only KEPT ones count; set to ISLAND.
    """
    if join_pieces(faces, fate, piece) < 2:
        return
    total = np.zeros(piece.size)
    for t in range(faces.shape[0]):
        if fate[t] == _KEPT:
            total[piece[faces[t, 0]]] += area[t]
    limit = share * total.max()
    for t in range(faces.shape[0]):
        if fate[t] == _KEPT and total[piece[faces[t, 0]]] < limit:
            fate[t] = _ISLAND
