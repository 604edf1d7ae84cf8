"""Which triangles of T1 (or T2) a triangle of T overlaps, found exactly.

A triangle t of T has no node of either grid inside, so the triangles of T1 that its interior meets
hang together through edges that run through t, and form a tree: a flood from any of them finds
each once.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates import orientation
from surfcmp_core.triangulation.half_edges import following, preceding


@kernel
def _turn(ax: float, ay: float, bx: float, by: float, cx: float, cy: float) -> float:
    """Orientation; common nodes are the rule here and need no exact arithmetic."""
    if (cx == ax and cy == ay) or (cx == bx and cy == by):
        return 0.0
    return orientation(ax, ay, bx, by, cx, cy)


class _Places(NamedTuple):
    """Where the corners of a triangle of T lie, counter-clockwise."""

    ax: float
    ay: float
    bx: float
    by: float
    cx: float
    cy: float


@kernel
def _runs_through(nodes: NDArray[np.float64], p: int, q: int, abc: _Places) -> bool:
    """Whether the edge pq meets the interior of the counter-clockwise triangle abc."""
    ax, ay, bx, by, cx, cy = abc
    px, py, qx, qy = nodes[p, 0], nodes[p, 1], nodes[q, 0], nodes[q, 1]
    # Apart if a line along one of the four edges has them on its two sides.
    if _turn(ax, ay, bx, by, px, py) <= 0.0 and _turn(ax, ay, bx, by, qx, qy) <= 0.0:
        return False
    if _turn(bx, by, cx, cy, px, py) <= 0.0 and _turn(bx, by, cx, cy, qx, qy) <= 0.0:
        return False
    if _turn(cx, cy, ax, ay, px, py) <= 0.0 and _turn(cx, cy, ax, ay, qx, qy) <= 0.0:
        return False
    a = _turn(px, py, qx, qy, ax, ay)
    b = _turn(px, py, qx, qy, bx, by)
    c = _turn(px, py, qx, qy, cx, cy)
    return (a > 0.0 or b > 0.0 or c > 0.0) and (a < 0.0 or b < 0.0 or c < 0.0)


@kernel
def _seed_at_own_node(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    leaving: int,
    abc: _Places,
) -> int:
    """Among the triangles around node a of T1, one that overlaps the triangle abc; -1 for none.

    Going counter-clockwise around a, it is the one in which b lies or, where b lies outside the
    hull, the first of the hull if it comes before c.
    """
    ax, ay, bx, by, cx, cy = abc
    first = -1
    h = leaving
    while True:
        p, q = start[following(h)], start[preceding(h)]
        onward = twin[preceding(h)]
        if p < 0:
            first = onward
        elif (
            q >= 0
            and _turn(ax, ay, nodes[p, 0], nodes[p, 1], bx, by) >= 0.0
            and _turn(ax, ay, bx, by, nodes[q, 0], nodes[q, 1]) > 0.0
        ):
            return h // 3
        h = onward
        if h == leaving:
            break
    if first >= 0:
        p = start[following(first)]
        px, py = nodes[p, 0], nodes[p, 1]
        if _turn(ax, ay, bx, by, px, py) >= 0.0 and _turn(ax, ay, px, py, cx, cy) > 0.0:
            return first // 3
    return -1


@kernel
def _seed_at_place(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    real: int,
    found: int,
    abc: _Places,
) -> int:
    """Like `_seed_at_own_node` where a is no node of T1 but was found in the triangle `found`."""
    ax, ay, bx, by, cx, cy = abc
    on_border = -1
    for h in range(3 * found, 3 * found + 3):
        p, q = start[h], start[following(h)]
        px, py, qx, qy = nodes[p, 0], nodes[p, 1], nodes[q, 0], nodes[q, 1]
        if _turn(px, py, qx, qy, ax, ay) == 0.0:
            on_border = h
            b, c = _turn(px, py, qx, qy, bx, by), _turn(px, py, qx, qy, cx, cy)
            if b > 0.0 or c > 0.0:
                on_border = -1
    if on_border < 0:
        return found
    beyond = int(twin[on_border]) // 3
    return beyond if beyond < real else -1


@kernel
def _seed_on_hull(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    real: int,
    ghosts: tuple[int, int, int],
    abc: _Places,
) -> int:
    """Like `_seed_at_own_node` where all of a, b, c are outside the hull, beyond these ghosts."""
    ax, ay, bx, by, cx, cy = abc
    for g in ghosts:
        p, q = start[3 * g], start[3 * g + 1]
        px, py, qx, qy = nodes[p, 0], nodes[p, 1], nodes[q, 0], nodes[q, 1]
        if (
            _turn(px, py, qx, qy, ax, ay) >= 0.0
            and _turn(px, py, qx, qy, bx, by) >= 0.0
            and _turn(px, py, qx, qy, cx, cy) >= 0.0
        ):
            return -1
    # Rare: the hull has no edge with abc beyond it that we know of, so ask all.
    for g in range(real, start.size // 3):
        if _runs_through(nodes, start[3 * g], start[3 * g + 1], abc):
            return int(twin[3 * g]) // 3
    return -1


@kernel
def overlapped(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    real: int,
    leaving: NDArray[np.int32],
    own: NDArray[np.int32],
    found: NDArray[np.int32],
    places: NDArray[np.float64],
    a: int,
    b: int,
    c: int,
    found_triangles: NDArray[np.int32],
    found_edges: NDArray[np.int32],
) -> tuple[int, bool]:
    """List the triangles of T1 whose interior meets that of a triangle of T.

    Parameters
    ----------
    nodes, start, twin, real
        T1, see `Triangulation`.
    leaving : (n1,) int32
        A half-edge of T1 that leaves each of its nodes.
    own : (N,) int32
        Number in T1 of each node of T, -1 where it is none.
    found : (N,) int32
        Triangle or ghost of T1 in which each other node of T lies.
    places : (N, 2) float64
        Nodes of T.
    a, b, c : int
        The triangle of T, counter-clockwise.
    found_triangles : (m1,) int32
        Filled in: the triangles.
    found_edges : (m1,) int32
        Filled in: bit k where the k-th edge of the triangle runs through that of T.

    Returns
    -------
    count : int
        How many were found.
    inside : bool
        Whether they cover the triangle of T: no edge of the hull runs through it.
    """
    if own[a] < 0:  # bring a node of T1 to a, where there is one
        if own[b] >= 0:
            a, b, c = b, c, a
        elif own[c] >= 0:
            a, b, c = c, a, b
        elif found[a] >= real:  # or else one inside the hull
            if found[b] < real:
                a, b, c = b, c, a
            elif found[c] < real:
                a, b, c = c, a, b
    abc = _Places(
        places[a, 0], places[a, 1], places[b, 0], places[b, 1], places[c, 0], places[c, 1]
    )
    if own[a] >= 0:
        seed = _seed_at_own_node(nodes, start, twin, leaving[own[a]], abc)
    elif found[a] < real:
        seed = _seed_at_place(nodes, start, twin, real, found[a], abc)
    else:
        ghosts = (found[a], found[b], found[c])
        seed = _seed_on_hull(nodes, start, twin, real, ghosts, abc)
    if seed < 0:
        return 0, False
    inside = True
    found_triangles[0] = seed
    found_edges[0] = 0
    count = 1
    visited = 0
    while visited < count:
        t = found_triangles[visited]
        for k in range(3):
            h = 3 * t + k
            # The edge through which t was entered is known already.
            if found_edges[visited] >> k & 1 == 0 and _runs_through(
                nodes, start[h], start[following(h)], abc
            ):
                found_edges[visited] |= 1 << k
                beyond = twin[h]
                if beyond // 3 >= real:
                    inside = False
                elif count < found_triangles.size:
                    found_triangles[count] = beyond // 3
                    found_edges[count] = 1 << (beyond % 3)
                    count += 1
        visited += 1
    return count, inside


@kernel
def sort_found(
    start: NDArray[np.int32],
    found_triangles: NDArray[np.int32],
    found_edges: NDArray[np.int32],
    count: int,
) -> None:
    """Sort what `overlapped` found by the triangles' nodes, whatever their own numbers are."""
    gap = 1
    while 3 * gap + 1 < count:
        gap = 3 * gap + 1
    while gap > 0:  # Shell's sort; most often two or three are to be sorted
        for i in range(gap, count):
            t, edges = found_triangles[i], found_edges[i]
            low, onward = lowest_edge(start, t)
            j = i
            while j >= gap:
                other_low, other_onward = lowest_edge(start, found_triangles[j - gap])
                if other_low < low or (other_low == low and other_onward < onward):
                    break
                found_triangles[j] = found_triangles[j - gap]
                found_edges[j] = found_edges[j - gap]
                j -= gap
            found_triangles[j] = t
            found_edges[j] = edges
        gap //= 3


@kernel
def lowest_edge(start: NDArray[np.int32], t: int) -> tuple[int, int]:
    """Lowest node of a triangle and the next one: no other triangle has the same two."""
    a, b, c = start[3 * t], start[3 * t + 1], start[3 * t + 2]
    if a < b and a < c:
        return a, b
    if b < c:
        return b, c
    return c, a


@kernel
def _fill_lowest_edges(
    start: NDArray[np.int32], triangles: NDArray[np.int64], codes: NDArray[np.int64]
) -> None:
    for i in range(triangles.size):
        low, onward = lowest_edge(start, triangles[i])
        codes[i] = (np.int64(low) << 32) + onward


def lowest_edges(start: NDArray[np.int32], triangles: NDArray[np.int64]) -> NDArray[np.int64]:
    """Give each of some triangles one number made of its nodes'."""
    codes = np.empty(len(triangles), np.int64)
    _fill_lowest_edges(start, triangles, codes)
    return codes
