"""Search for the next starter from a bridge (the paper's section 3.1)."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.interface.disc import disc_holds
from surfcmp_core.interface.events import N_TESTS, Event, Events, note
from surfcmp_core.interface.joined import TWIN, first_of, following, preceding
from surfcmp_core.interface.smallest_circle import is_better
from surfcmp_core.kernel import kernel, wide
from surfcmp_core.predicates import orientation
from surfcmp_core.stack import enlarged

_CIRCLE, _WALK, _DISC = int(Event.CIRCLE), int(Event.WALK), int(Event.DISC)


@kernel
def _walk_to_disc(
    nodes: NDArray[np.float64],
    words: NDArray[np.int32],
    corner: int,
    v: int,
    events: Events,
    counters: NDArray[np.int64],
) -> int:
    """Walk from the triangle of a corner to one whose disc holds v; step (a)."""
    px, py = nodes[v, 0], nodes[v, 1]
    h = first_of(corner)
    while not disc_holds(nodes, words, h, v):
        if events is not None:
            counters[N_TESTS] += 1
            note(events, counters, _WALK, h, v)
        if words[h + 2] < 0:
            a, b = words[h], words[h + 1]
            ax, ay = nodes[a, 0], nodes[a, 1]
            bx, by = nodes[b, 0], nodes[b, 1]
            if orientation(ax, ay, bx, by, px, py) < 0.0:
                onward = words[h + TWIN]
            elif (bx - ax) * (px - bx) > 0.0 or (by - ay) * (py - by) > 0.0:
                onward = words[h + 1 + TWIN]  # collinear, beyond b: step along the hull
            else:
                onward = words[h + 2 + TWIN]
        else:
            onward = words[h + TWIN]
            for k in range(h, h + 3):
                a, b = words[k], words[following(k)]
                if orientation(nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1], px, py) < 0.0:
                    onward = words[k + TWIN]
                    break
        h = first_of(wide(onward))
    return h


@kernel
def next_starter(
    nodes: NDArray[np.float64],
    words: NDArray[np.int32],
    bridge: int,
    other_corner: int,
    events: Events,
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
    events, counters
        The record.

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
    v, u = wide(words[bridge]), wide(words[following(bridge)])
    vx, vy = nodes[v, 0], nodes[v, 1]
    ux, uy = nodes[u, 0], nodes[u, 1]
    h = _walk_to_disc(nodes, words, other_corner, v, events, counters)
    if events is not None:
        note(events, counters, _DISC, h, v)
    stack = np.empty(64, np.int32)
    depth = 0
    best = wide(-1)
    corner = wide(-1)
    for k in range(h, h + 3):
        d = wide(words[k])
        if d >= 0 and (best < 0 or is_better(nodes, vx, vy, ux, uy, best, d)):
            best = d
            corner = k
            if events is not None:
                note(events, counters, _CIRCLE, v, d)
        stack[depth] = words[k + TWIN]
        depth += 1
    while depth > 0:
        depth -= 1
        h = wide(stack[depth])
        if events is not None:
            counters[N_TESTS] += 1
        if not disc_holds(nodes, words, h, v):
            continue
        if events is not None:
            note(events, counters, _DISC, first_of(h), v)
        k = preceding(h)
        d = wide(words[k])
        if d >= 0 and is_better(nodes, vx, vy, ux, uy, best, d):
            best = d
            corner = k
            if events is not None:
                note(events, counters, _CIRCLE, v, d)
        if depth + 2 > stack.size:
            stack = enlarged(stack)
        stack[depth] = words[k + TWIN]
        stack[depth + 1] = words[following(h) + TWIN]
        depth += 2
    on_left = orientation(vx, vy, ux, uy, nodes[best, 0], nodes[best, 1]) >= 0.0
    return (bridge if on_left else following(words[bridge + TWIN])), corner
