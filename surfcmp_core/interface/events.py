"""A record of what tracing does, for teaching."""

from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import inlined, kernel


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
    """A triangle at the starter's other end is destroyed: its number, the free node."""


Record = NDArray[np.int64] | None
"""(k,) events, each packed into eight bytes, see `unpacked`; None records nothing at all."""

_TESTS = 15
"""Not an event: so many discs were tested meanwhile, more than fit into one."""
_SMALL = 4
"""Bits for the kind, and for the number of discs tested since the event before."""
_LARGE = 28
"""Bits for each of the two numbers: `Joined` has less nodes and triangles."""

N_EVENTS = 4
"""Place of the number of events among the counters."""
N_TESTS = 5
"""Place of the number of discs and circles tested since the last event."""


@kernel
def _note_tests(record: NDArray[np.int64], k: int, tests: int) -> int:
    if k < record.size:
        record[k] = (tests << (_LARGE + 2 * _SMALL)) | (_TESTS << _SMALL)
    return k + 1


@inlined
def note(record: NDArray[np.int64], counters: NDArray[np.int64], kind: int, x: int, y: int) -> None:
    """Record an event; past the end of `record` it is only counted."""
    k = counters[N_EVENTS]
    tests = counters[N_TESTS]
    if tests >> _SMALL:
        k = _note_tests(record, k, tests)
        tests = 0
    if k < record.size:
        numbers = (np.int64(x) << _LARGE) | (y + 1)
        record[k] = (numbers << (2 * _SMALL)) | (kind << _SMALL) | tests
    counters[N_EVENTS] = k + 1
    counters[N_TESTS] = 0


def unpacked(record: NDArray[np.int64]) -> NDArray[np.int32]:
    """List events.

    Parameters
    ----------
    record : (k,) int64
        As `note` packs them.

    Returns
    -------
    (e, 4) int32
        Kind, its two numbers, discs and circles tested so far.
    """
    kind = (record >> _SMALL) & (2**_SMALL - 1)
    x = record >> (_LARGE + 2 * _SMALL)
    y = ((record >> (2 * _SMALL)) & (2**_LARGE - 1)) - 1
    tests = np.where(kind == _TESTS, x, record & (2**_SMALL - 1)).cumsum()
    events = np.stack((kind, x, y, tests), axis=1)[kind != _TESTS]
    return np.asarray(events, np.int32)
