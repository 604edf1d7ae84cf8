"""Search for the next starter from a bridge (the paper's section 3.1)."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel, wide
from surfcmp_core.interface.disc import disc_holds
from surfcmp_core.interface.events import N_TESTS, Event, Record, note
from surfcmp_core.interface.joined import TWIN, WORDS, following, preceding
from surfcmp_core.interface.smallest_circle import leads_on
from surfcmp_core.predicates import CIRCLES_FILTER, orientation, scalar_product

_CIRCLE, _WALK, _DISC = int(Event.CIRCLE), int(Event.WALK), int(Event.DISC)


@kernel
def next_starter(
    nodes: NDArray[np.float64],
    words: NDArray[np.int32],
    bridge: int,
    other_corner: int,
    record: Record,
    counters: NDArray[np.int64],
) -> tuple[int, int]:
    """Find a starter at the free node of a bridge.

    Parameters
    ----------
    nodes, words
        Of `Joined`.
    bridge : int
        Half-edge from the free node v to the other end u.
    other_corner : int
        Corner of the other triangulation at which the bridge was destroyed.
    record, counters
        The record.

    Returns
    -------
    corner, other : int
        Corners of the starter's two ends, at v and in the other triangulation, each in a triangle
        that the opposite end destroys.

    Notes
    -----
    The paper collects the nodes of all triangles whose circles hold v and takes the one with the
    smallest circle through v centred on the bridge. To meet that node none has to be collected:
    where the circle of a node d holds a node of d's grid, it holds a neighbour of d, for the
    largest empty circle inside that touches it at d passes through one. So the search steps from
    neighbour to neighbour while the circle shrinks, and ends at the smallest. It lies within the
    influence circle of the bridge (step (c)), so it is empty of both grids.
    """
    v, u = wide(words[bridge]), wide(words[following(bridge)])
    vx, vy = nodes[v, 0], nodes[v, 1]
    ux, uy = nodes[u, 0], nodes[u, 1]
    wx, wy = ux - vx, uy - vy
    h = wide(other_corner)
    while True:
        # everything relative to v; along: the ray v→u
        d = wide(words[h])
        dx, dy = nodes[d, 0], nodes[d, 1]
        ax, ay = dx - vx, dy - vy
        a_square = ax * ax + ay * ay
        a_along, a_bound = ax * wx + ay * wy, abs(ax * wx) + abs(ay * wy)
        # (a) search along the bridge: step forward from behind v ...
        ahead = scalar_product(vx, vy, dx, dy, vx, vy, ux, uy) > 0.0
        if record is not None:
            note(record, counters, _CIRCLE if ahead else _WALK, v, d)
        k, before = h, h
        facing = wide(-1)
        left = False
        found = False
        while True:
            e = wide(words[np.uintp(following(k))])
            if e >= 0:
                # ... (d) then to nodes whose circles are smaller
                if record is not None:
                    counters[N_TESTS] += 1
                ex, ey = nodes[np.uintp(e), 0], nodes[np.uintp(e), 1]
                bx, by = ex - vx, ey - vy
                b_square = bx * bx + by * by
                gain = a_square * (bx * wx + by * wy) - b_square * a_along
                bound = CIRCLES_FILTER * (
                    a_square * (abs(bx * wx) + abs(by * wy)) + b_square * a_bound
                )
                if ahead and abs(gain) > bound:
                    found = gain > 0.0
                else:
                    found = leads_on(vx, vy, ux, uy, dx, dy, ex, ey)
                if found:
                    break
                # v lies between an edge that has it to the left and the next one
                on_left = ax * by > ay * bx
                if left and not on_left:
                    facing = before
                left = on_left
            before = k
            k = wide(words[np.uintp(preceding(k) + TWIN)])
            if k == h:
                break
        if not found:
            break
        h = following(k)
    # (b) the triangle at d that faces v is destroyed by it, or where rounding misled another one
    h = before if facing < 0 else facing
    while not disc_holds(nodes, words, h, v):
        h = wide(words[preceding(h) + TWIN])
    if record is not None:
        note(record, counters, _DISC, h // WORDS, v)
    side = orientation(vx, vy, ux, uy, dx, dy)
    return (bridge if side >= 0.0 else following(wide(words[bridge + TWIN]))), h
