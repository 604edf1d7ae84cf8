"""The border of a set of triangles, as a chain of directed edges."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.projection.removed import Fate

_KEPT = int(Fate.KEPT)


@kernel
def _scatter(number: int) -> np.uint64:
    """Scatter node numbers over 64 bits (splitmix64)."""
    x = np.uint64(number + 1) * np.uint64(0x9E3779B97F4A7C15)
    x = (x ^ (x >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    x = (x ^ (x >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return x ^ (x >> np.uint64(31))


@kernel
def _with_ends(
    faces: NDArray[np.int32],
    fate: NDArray[np.uint8],
    ends: NDArray[np.uint64],
    found: NDArray[np.int32],
) -> int:
    """Collect triangles with two nodes or more on the border.

    For each node the edges that leave it less those that reach it are summed up: 0 inside.
    """
    for t in range(faces.shape[0]):
        if fate[t] == _KEPT:
            a, b, c = faces[t, 0], faces[t, 1], faces[t, 2]
            ka, kb, kc = _scatter(a), _scatter(b), _scatter(c)
            ends[a] += kb - kc
            ends[b] += kc - ka
            ends[c] += ka - kb
    count = 0
    for t in range(faces.shape[0]):
        if fate[t] == _KEPT:
            a, b, c = ends[faces[t, 0]] != 0, ends[faces[t, 1]] != 0, ends[faces[t, 2]] != 0
            if (a and b) or (b and c) or (c and a):
                found[count] = t
                count += 1
    return count


def border_of(faces: NDArray[np.int32], fate: NDArray[np.uint8], nodes: int) -> NDArray[np.int64]:
    """Give the edges that do not cancel against an opposite one.

    Parameters
    ----------
    faces : (m, 3) int32
    fate : (m,) uint8
        Only KEPT ones count.
    nodes : int
        How many nodes there are.

    Returns
    -------
    (e, 2) int64
        From node to node, the triangle on the left; repeated where several have it alike.
    """
    ends = np.zeros(nodes, np.uint64)
    found = np.empty(len(faces), np.int32)
    near = faces[found[: _with_ends(faces, fate, ends, found)]].astype(np.int64)
    edges = np.concatenate([near[:, [i, (i + 1) % 3]] for i in range(3)])
    edges = edges[(ends[edges] != 0).all(axis=1)]
    rising = edges[:, 0] < edges[:, 1]
    keys = np.where(rising, edges[:, 0] * nodes + edges[:, 1], edges[:, 1] * nodes + edges[:, 0])
    keys, which = np.unique(keys, return_inverse=True)
    net = np.bincount(which, np.where(rising, 1.0, -1.0), len(keys)).astype(np.int64)
    open_edges = np.column_stack((keys // nodes, keys % nodes))
    open_edges[net < 0] = open_edges[net < 0, ::-1]
    return np.repeat(open_edges, np.abs(net), axis=0)
