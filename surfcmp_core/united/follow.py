"""Chains of a finished triangulation, by following interface edges.

Tracing delivers the chains of two grids without common nodes. Where nodes are shared, a chain ends
at them, and which triangles are interface ones is known only when the nodes carry both labels.
"""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import inlined, kernel
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import following, preceding


@inlined
def _is_interface(start: NDArray[np.int32], label: NDArray[np.uint8], h: int) -> bool:
    """Whether an edge joins a node of G1 alone to one of G2 alone."""
    a = label[start[h]]
    b = label[start[following(h)]]
    return bool(a != 3 and b != 3 and a != b)


@kernel
def _follow(
    triangulation: Triangulation,
    label: NDArray[np.uint8],
    order: NDArray[np.int32],
    first: NDArray[np.int32],
    closed: NDArray[np.bool_],
) -> int:
    _, start, twin, real = triangulation
    seen = np.zeros(real, np.bool_)
    end = 3 * real
    chains = 0
    count = 0
    for loops in (False, True):  # open chains from an end, then the closed ones are left
        for t in range(real):
            if seen[t]:
                continue
            edges = 0
            exits = 0
            way = -1
            for h in range(3 * t, 3 * t + 3):
                if _is_interface(start, label, h):
                    edges += 1
                    if twin[h] < end:
                        exits += 1
                        way = h
            if edges == 0 or (exits == 2 and not loops):
                continue
            first[chains] = count
            closed[chains] = loops
            chains += 1
            seen[t] = True
            order[count] = t
            count += 1
            while way >= 0:
                entry = twin[way]
                if seen[entry // 3]:
                    break
                seen[entry // 3] = True
                order[count] = entry // 3
                count += 1
                way = -1
                for h in (following(entry), preceding(entry)):
                    if _is_interface(start, label, h) and twin[h] < end:
                        way = h
    first[chains] = count
    return chains


def follow_chains(
    triangulation: Triangulation, label: NDArray[np.uint8]
) -> tuple[NDArray[np.int32], NDArray[np.int32], NDArray[np.bool_]]:
    """Follow all chains of a labelled triangulation, in linear time.

    Parameters
    ----------
    triangulation : Triangulation
        T.
    label : (N,) uint8
        1: node of G1 alone, 2: of G2 alone, 3: shared.

    Returns
    -------
    order : (k,) int32
        Interface triangles, chain after chain, in the order of each chain.
    first : (C + 1,) int32
        Where each chain starts in `order`, and the end.
    closed : (C,) bool
    """
    real = triangulation.real
    order = np.empty(real, np.int32)
    first = np.empty(real + 1, np.int32)
    closed = np.empty(real, np.bool_)
    chains = _follow(triangulation, label, order, first, closed)
    return order[: first[chains]], first[: chains + 1], closed[:chains]
