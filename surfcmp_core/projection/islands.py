"""Small pieces that hang together with nothing else."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import kernel
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
def drop_islands(
    faces: NDArray[np.int32],
    area: NDArray[np.float64],
    share: float,
    parent: NDArray[np.int32],
    fate: NDArray[np.uint8],
) -> None:
    """Mark the pieces that are small beside the largest one.

    Parameters
    ----------
    faces : (m, 3) int32
        Triangles that share a node belong to one piece.
    area : (m,) float64
    share : float
        Pieces below this share of the largest one's area go.
    parent : (n,) int32
        Room to work in.
    fate : (m,) uint8
        Only KEPT ones count; set to ISLAND.
    """
    for node in range(parent.size):
        parent[node] = node
    for t in range(faces.shape[0]):
        if fate[t] == _KEPT:
            a = parent[faces[t, 0]]
            if a == parent[faces[t, 1]] and a == parent[faces[t, 2]]:
                continue
            a = _root(parent, a)
            for i in range(1, 3):
                b = _root(parent, faces[t, i])
                parent[max(a, b)] = min(a, b)
                a = min(a, b)
    total = np.zeros(parent.size)
    for node in range(parent.size):  # a parent's number is below its child's
        parent[node] = parent[parent[node]]
    for t in range(faces.shape[0]):
        if fate[t] == _KEPT:
            total[parent[faces[t, 0]]] += area[t]
    limit = share * total.max()
    for t in range(faces.shape[0]):
        if fate[t] == _KEPT and total[parent[faces[t, 0]]] < limit:
            fate[t] = _ISLAND
