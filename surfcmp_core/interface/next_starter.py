"""Search for the next starter from a bridge (the paper's section 3.1)."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.interface.disc import disc_holds
from surfcmp_core.interface.smallest_circle import is_better
from surfcmp_core.kernel import kernel
from surfcmp_core.predicates import orientation
from surfcmp_core.triangulation.half_edges import following, preceding


@kernel
def _walk_to_disc(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    corner: int,
    px: float,
    py: float,
) -> int:
    """Walk from the triangle of a corner to one whose disc holds p; step (a)."""
    h = corner - corner % 3
    while not disc_holds(nodes, start, h, px, py):
        if start[h + 2] < 0:
            a, b = start[h], start[h + 1]
            ax, ay = nodes[a, 0], nodes[a, 1]
            bx, by = nodes[b, 0], nodes[b, 1]
            if orientation(ax, ay, bx, by, px, py) < 0.0:
                onward = twin[h]
            elif (bx - ax) * (px - bx) > 0.0 or (by - ay) * (py - by) > 0.0:
                onward = twin[h + 1]  # collinear, beyond b: step along the hull
            else:
                onward = twin[h + 2]
        else:
            onward = -1
            for k in range(h, h + 3):
                a, b = start[k], start[following(k)]
                if orientation(nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1], px, py) < 0.0:
                    onward = twin[k]
                    break
        h = onward - onward % 3
    return h


@kernel
def next_starter(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    bridge: int,
    other_corner: int,
) -> tuple[int, int]:
    """Find a starter at the free node of a bridge.

    Parameters
    ----------
    bridge : int
        Half-edge from the free node v to the other end u.
    other_corner : int
        Corner of the other triangulation at which the bridge was destroyed.

    Returns
    -------
    corner, other : int
        Corners of the starter's two ends, at v and in the other triangulation, each in a triangle
        that the opposite end destroys.

    Notes
    -----
    The triangles whose discs hold v (step (b)) are connected and have no node inside, so the flood
    over them meets each once. The smallest circle through v and one of their nodes (step (d)) lies
    within the influence circle of the bridge (step (c)): it is empty of both grids.
    """
    v, u = start[bridge], start[following(bridge)]
    vx, vy = nodes[v, 0], nodes[v, 1]
    ux, uy = nodes[u, 0], nodes[u, 1]
    h = _walk_to_disc(nodes, start, twin, other_corner, vx, vy)
    stack = np.empty(64, np.int32)
    depth = 0
    best = -1
    corner = -1
    for k in range(h, h + 3):
        d = start[k]
        if d >= 0 and (best < 0 or is_better(nodes, vx, vy, ux, uy, best, d)):
            best = d
            corner = k
        stack[depth] = twin[k]
        depth += 1
    while depth > 0:
        depth -= 1
        h = stack[depth]
        if not disc_holds(nodes, start, h, vx, vy):
            continue
        k = preceding(h)
        d = start[k]
        if d >= 0 and (best < 0 or is_better(nodes, vx, vy, ux, uy, best, d)):
            best = d
            corner = k
        if depth + 2 > stack.size:
            larger = np.empty(2 * stack.size, np.int32)
            larger[:depth] = stack[:depth]
            stack = larger
        stack[depth] = twin[k]
        stack[depth + 1] = twin[following(h)]
        depth += 2
    on_left = orientation(vx, vy, ux, uy, nodes[best, 0], nodes[best, 1]) >= 0.0
    return (bridge if on_left else following(twin[bridge])), corner
