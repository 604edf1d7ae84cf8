"""A record of what tracing does, for teaching."""

from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import inlined


class Event(IntEnum):
    """Kinds of events; the two numbers that go with each are named in its description."""

    CIRCLE = 0
    """The smallest circle so far that touches at a node: that node, the node it passes through."""
    STARTER = 1
    """A starter is found: its ends."""
    EDGE_PASSED = 2
    """An edge of a bundle is destroyed: the bundle's node, the edge's other end."""
    TRIANGLE = 3
    """An interface triangle is emitted: its number, the node at which the new edge ends."""
    CHAIN_CLOSED = 4
    """The chain is back at its starter: its number, 0."""
    CHAIN_ENDED = 5
    """A terminal edge on the hull: number of the chain, 0 on the first side and 1 on the other."""
    BRIDGE = 6
    """A destroyed edge is a bridge: its free node, its other end."""
    BRIDGE_TAKEN = 7
    """The next bridge is looked at: its free node, its other end."""
    BRIDGE_DONE = 8
    """The free node has been traced meanwhile: that node, the bridge's other end."""
    WALK = 9
    """The search from a bridge comes to a node behind its free node: that free node, the node."""
    DISC = 10
    """A triangle at the starter's other end is destroyed: its first word, the free node."""


Events = NDArray[np.int32] | None
"""(k, 4) int32: kind, its two numbers, discs tested so far; None records nothing at all."""

N_EVENTS = 4
"""Place of the number of events among the counters."""
N_TESTS = 5
"""Place of the number of discs and circles tested."""


@inlined
def note(events: NDArray[np.int32], counters: NDArray[np.int64], kind: int, x: int, y: int) -> None:
    """Record an event; past the end of `events` it is only counted."""
    k = counters[N_EVENTS]
    if k < events.shape[0]:
        events[k, 0] = kind
        events[k, 1] = x
        events[k, 2] = y
        events[k, 3] = counters[N_TESTS]
    counters[N_EVENTS] = k + 1
