"""Localisation in a triangulation that is not Delaunay: along straight lines."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates import orientation
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import following, leaving_edges, preceding


@kernel
def _turn(nodes: NDArray[np.float64], a: int, b: int, px: float, py: float) -> float:
    return orientation(nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1], px, py)


@kernel
def _towards(
    triangulation: Triangulation,
    begin: int,
    px: float,
    py: float,
) -> int:
    """Among the half-edges that leave a node, that of the real triangle which opens towards p."""
    nodes, start, twin, _ = triangulation
    v = start[begin]
    h = begin
    while True:
        w, x = start[following(h)], start[preceding(h)]
        if (
            w >= 0
            and x >= 0
            and _turn(nodes, v, w, px, py) >= 0.0
            and _turn(nodes, v, x, px, py) <= 0.0
        ):
            return h
        h = int(twin[preceding(h)])
        if h == begin:
            return -1


@kernel
def _walk_straight(
    triangulation: Triangulation,
    leaving: NDArray[np.int32],
    v: int,
    px: float,
    py: float,
) -> int:
    """Walk from node v straight to p, inside the hull; return a triangle that holds p."""
    nodes, start, twin, _ = triangulation
    while True:
        h = _towards(triangulation, int(leaving[v]), px, py)
        g = following(h)
        while True:
            if _turn(nodes, start[g], start[following(g)], px, py) >= 0.0:
                return g // 3
            k = int(twin[g])
            y = int(start[preceding(k)])
            turn = _turn(nodes, v, y, px, py)
            if turn == 0.0:  # the way leads through a node: go on from there
                v = y
                break
            g = preceding(k) if turn > 0.0 else following(k)


@kernel
def _relocate(
    target: Triangulation,
    before: NDArray[np.int32],
    leaving: NDArray[np.int32],
    queries: NDArray[np.float64],
    found: NDArray[np.int32],
) -> None:
    for k in range(len(queries)):
        if found[k] >= target.real:
            continue
        unchanged = True
        for h in range(3 * found[k], 3 * found[k] + 3):
            unchanged = unchanged and target.start[h] == before[h]
        if not unchanged:
            x, y = queries[k, 0], queries[k, 1]
            v = before[3 * found[k]]
            found[k] = _walk_straight(target, leaving, v, x, y)


def relocate(
    target: Triangulation,
    before: Triangulation,
    queries: NDArray[np.float64],
    found: NDArray[np.int32],
) -> NDArray[np.int32]:
    """Locate places anew after edges of a triangulation have been turned.

    A walk that crosses any edge with the place beyond it may go in circles where the triangulation
    is not Delaunay; one along a straight line ends in any.

    Parameters
    ----------
    target, before : Triangulation
        Of the same nodes, ghosts in the same places.
    queries : (k, 2) float64
        Places.
    found : (k,) int32
        Where they lie in `before`.

    Returns
    -------
    (k,) int32
        Where they lie in `target`.
    """
    found = found.copy()
    leaving = leaving_edges(target.start, len(target.nodes))
    _relocate(target, before.start, leaving, queries, found)
    return found
