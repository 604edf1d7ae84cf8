"""Half-edges of a triangulation, closed by ghost triangles.

Half-edge ``3 t + i`` leads from corner i of triangle t to the next corner counter-clockwise; it
names that corner too. `start` holds the node it leads from, `twin` the half-edge of the neighbour
along the same edge. Each hull edge carries a ghost triangle whose third node, at infinity, is -1:
half-edges ``3 g`` (the hull edge, clockwise around the hull), ``3 g + 1`` (to infinity) and
``3 g + 2`` (back). With ghosts no node has a border, and no walk needs a case for it.
"""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import inlined, kernel

INFINITY = -1
"""Number of the node at infinity."""


@inlined
def following(h: int) -> int:
    """Next half-edge of the same triangle, counter-clockwise."""
    return h - 2 if h % 3 == 2 else h + 1


@inlined
def preceding(h: int) -> int:
    """Previous half-edge of the same triangle."""
    return h + 2 if h % 3 == 0 else h - 1


@kernel
def _order_by_lowest_node(
    triangles: NDArray[np.int32], count: int, start: NDArray[np.int32]
) -> None:
    """Sort triangles by their lowest node, each starting with it."""
    place = np.zeros(count + 1, np.int32)
    for t in range(triangles.shape[0]):
        place[min(triangles[t, 0], triangles[t, 1], triangles[t, 2]) + 1] += 1
    for v in range(count):
        place[v + 1] += place[v]
    for t in range(triangles.shape[0]):
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        low = min(a, b, c)  # also where a node stands twice: each row has its place
        if a != low:
            a, b, c = (b, c, a) if b == low else (c, a, b)
        h = 3 * place[a]
        place[a] += 1
        start[h] = a
        start[h + 1] = b
        start[h + 2] = c


@kernel
def _match(start: NDArray[np.int32], real: int, count: int, twin: NDArray[np.int32]) -> int:
    """Find all twins, -1 on the border; return its length, -1 where an edge repeats.

    Half-edges that wait for their twin hang in a list at the lower of their two nodes; the links
    of the lists lie in `twin` itself.
    """
    waiting = np.full(count, -1, np.int32)
    for h in range(3 * real):
        a = start[h]
        b = start[following(h)]
        low = min(a, b)
        high = max(a, b)
        before = -1
        k = waiting[low]
        while k >= 0:
            c = start[k]
            if max(c, start[following(k)]) == high:
                break
            before = k
            k = twin[k]
        if k < 0:
            twin[h] = waiting[low]
            waiting[low] = h
            continue
        if start[k] == a:
            return -1
        if before < 0:
            waiting[low] = twin[k]
        else:
            twin[before] = twin[k]
        twin[h] = k
        twin[k] = h
    border = 0
    for v in range(count):
        k = waiting[v]
        while k >= 0:
            onward = twin[k]
            twin[k] = -1
            k = onward
            border += 1
    return border


@kernel
def _add_ghosts(start: NDArray[np.int32], twin: NDArray[np.int32], real: int, count: int) -> bool:
    """Fill the ghosts' part of both arrays; False where the border is not made of closed loops."""
    ghost_at = np.full(count, -1, np.int32)  # ghost of the hull edge that leaves a node
    h_ghost = 3 * real
    for h in range(3 * real):
        if twin[h] < 0:
            a = start[h]
            if ghost_at[a] >= 0:
                return False
            ghost_at[a] = h_ghost
            twin[h] = h_ghost
            twin[h_ghost] = h
            start[h_ghost] = start[following(h)]
            start[h_ghost + 1] = a
            start[h_ghost + 2] = INFINITY
            h_ghost += 3
    for g in range(3 * real, start.size, 3):
        onward = ghost_at[start[g]]
        if onward < 0:
            return False
        twin[g + 2] = onward + 1
        twin[onward + 1] = g + 2
    return True


def half_edges(
    triangles: NDArray[np.int32], count: int
) -> tuple[NDArray[np.int32], NDArray[np.int32]] | None:
    """Half-edges of a triangulation, in linear time.

    Parameters
    ----------
    triangles : (m, 3) int32
        Counter-clockwise, in numbers below `count`.
    count : int
        Number of nodes.

    Returns
    -------
    start, twin : (3 (m + h),) int32
        See the module; real triangles are renumbered after their lowest nodes. None where the
        triangles do not form a disc with all nodes.
    """
    real = len(triangles)
    hull = 2 * count - 2 - real  # Euler
    if hull < 3:
        return None
    start, twin = np.empty(3 * (real + hull), np.int32), np.empty(3 * (real + hull), np.int32)
    _order_by_lowest_node(triangles, count, start)
    if _match(start, real, count, twin) != hull or not _add_ghosts(start, twin, real, count):
        return None
    return start, twin


@kernel
def _leaving(start: NDArray[np.int32], leaving: NDArray[np.int32]) -> None:
    for h in range(start.size - 1, -1, -1):
        if start[h] >= 0:
            leaving[start[h]] = h


def leaving_edges(start: NDArray[np.int32], count: int) -> NDArray[np.int32]:
    """Give one half-edge that leaves each node, the first one, which belongs to a real triangle.

    Parameters
    ----------
    start : int32
        Half-edges.
    count : int
        Number of nodes.

    Returns
    -------
    (count,) int32
    """
    leaving = np.empty(count, np.int32)
    _leaving(start, leaving)
    return leaving
