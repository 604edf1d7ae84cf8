"""All chains of interface triangles in one compiled pass (the paper's section 3.1)."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.cache import is_compiled
from surfcmp_core.compiled.kernel import kernel, wide
from surfcmp_core.interface.chain import N_BRIDGES, N_TRIANGLES, trace_chain
from surfcmp_core.interface.events import N_EVENTS, Event, Record, note, unpacked
from surfcmp_core.interface.first_starter import first_starter
from surfcmp_core.interface.joined import MARKS, PASSED, WORDS, Joined, first_of, following
from surfcmp_core.interface.next_starter import next_starter

_SLICE = 1 << 18
"""Interface triangles between two looks at whether the user cancelled."""
N_CHAINS = 2
"""Place among the counters of the number of chains."""
_STARTED = 3
"""Place of whether the first starter has been found."""

_STARTER, _CLOSED, _ENDED, _TAKEN, _DONE = (
    int(Event.STARTER),
    int(Event.CHAIN_CLOSED),
    int(Event.CHAIN_ENDED),
    int(Event.BRIDGE_TAKEN),
    int(Event.BRIDGE_DONE),
)


@dataclass(frozen=True, slots=True, eq=False)
class Chains:
    """Interface triangles, chain after chain, in the order of each chain.

    Attributes
    ----------
    base : (k,) int32
        Half-edge of T1 or T2 (in the numbers of `Joined`) that is the triangle's only edge
        between two nodes of one grid; its own triangle is destroyed.
    apex : (k,) int32
        The third node, of the other grid; counter-clockwise after the base.
    first : (C + 1,) int32
        Where each chain starts in `base`, and the end.
    closed : (C,) bool
    record : (k,) int64
        What tracing did, packed; empty where nothing was recorded.
    """

    base: NDArray[np.int32]
    apex: NDArray[np.int32]
    first: NDArray[np.int32]
    closed: NDArray[np.bool_]
    record: NDArray[np.int64]

    @property
    def events(self) -> NDArray[np.int32]:
        """(e, 4) int32: what tracing did, in its order.

        An `Event`, its two numbers, discs and circles tested so far. Triangles are numbered as they
        were emitted; where a chain ends on the hull, those of its first side are turned round in
        `base` afterwards.
        """
        return unpacked(self.record)


@kernel
def _turn_round(array: NDArray[np.int32], begin: int, end: int) -> None:
    for k in range((end - begin) // 2):
        i, j = begin + k, end - 1 - k
        array[i], array[j] = array[j], array[i]


@kernel
def _extract(
    nodes: NDArray[np.float64],
    words: NDArray[np.int32],
    split: int,
    split_word: int,
    base: NDArray[np.int32],
    apex: NDArray[np.int32],
    first: NDArray[np.int32],
    closed: NDArray[np.bool_],
    stack: NDArray[np.int32],
    counters: NDArray[np.int64],
    record: Record,
    pause: int,
) -> bool:
    """Trace chains until about `pause` triangles are found; True when all chains are."""
    while counters[N_TRIANGLES] < pause:
        if counters[_STARTED] == 0:
            counters[_STARTED] = 1
            a, b = first_starter(nodes, words, split, split_word, record, counters)
        else:
            if counters[N_BRIDGES] == 0:
                return True
            counters[N_BRIDGES] -= 1
            top = 2 * counters[N_BRIDGES]
            bridge = wide(stack[top])
            done = (words[first_of(bridge) + MARKS] >> (bridge & 3)) & 1
            if record is not None:
                kind = _DONE if done else _TAKEN
                note(record, counters, kind, words[bridge], words[following(bridge)])
            if done:
                continue  # the free node has been traced meanwhile
            a, b = next_starter(nodes, words, bridge, wide(stack[top + 1]), record, counters)
        chain = counters[N_CHAINS]
        begin = counters[N_TRIANGLES]
        first[chain] = begin
        if record is not None:
            note(record, counters, _STARTER, words[a], words[b])
        is_closed = trace_chain(nodes, words, base, apex, stack, counters, record, a, b)
        if record is not None:
            note(record, counters, _CLOSED if is_closed else _ENDED, chain, 0)
        if not is_closed:  # the other side of the starter, its ends exchanged
            _turn_round(base, begin, counters[N_TRIANGLES])
            _turn_round(apex, begin, counters[N_TRIANGLES])
            trace_chain(nodes, words, base, apex, stack, counters, record, b, a)
            if record is not None:
                note(record, counters, _ENDED, chain, 1)
        closed[chain] = is_closed
        counters[N_CHAINS] = chain + 1
    return False


def kernels_are_ready() -> bool:
    """Tell whether the kernels, of which these are the slowest to compile, are in the cache."""
    return is_compiled(_extract)


def extract_chains(
    joined: Joined, progress: Callable[[float], None] | None = None, *, record: bool = False
) -> Chains:
    """Extract all chains of interface triangles, in time linear in the nodes.

    Parameters
    ----------
    joined : Joined
        Triangulations of two grids without a common node. Its marks are filled: surviving
        triangles are those without a passed corner.
    progress : callable, optional
        Called between chains with the share of the largest possible number of triangles; may raise
        to cancel.
    record : bool
        Whether to record what tracing does, for teaching.

    Returns
    -------
    Chains

    References
    ----------
    Section 3.1 of the paper; [Kirkpatrick1979]; [MestetskiyTsarik2004].
    """
    room = 8 * len(joined.nodes) if record else 0
    while True:
        chains, wanted = _run(joined, progress, np.empty(room, np.int64) if record else None)
        if wanted <= room:
            return chains
        room = wanted
        joined.words[MARKS::WORDS] &= ~PASSED


def _run(
    joined: Joined, progress: Callable[[float], None] | None, record: Record
) -> tuple[Chains, int]:
    """Trace all chains; return the number of events too, which may be more than there is room."""
    count = len(joined.nodes)
    room = 2 * count
    base = np.empty(room, np.int32)
    apex = np.empty(room, np.int32)
    first = np.empty(room + 1, np.int32)
    closed = np.empty(room, np.bool_)
    # an edge of a tree is pushed from either end, and once more where a chain closes over it
    stack = np.empty(8 * count + 2, np.int32)
    counters = np.zeros(6, np.int64)
    while not _extract(
        joined.nodes,
        joined.words,
        joined.split,
        joined.split_word,
        base,
        apex,
        first,
        closed,
        stack,
        counters,
        record,
        int(counters[N_TRIANGLES]) + _SLICE,
    ):
        if progress is not None:
            progress(float(counters[N_TRIANGLES]) / room)
    triangles, chains = int(counters[N_TRIANGLES]), int(counters[N_CHAINS])
    first[chains] = triangles
    found = np.empty(0, np.int64) if record is None else record[: counters[N_EVENTS]]
    return (
        Chains(base[:triangles], apex[:triangles], first[: chains + 1], closed[:chains], found),
        int(counters[N_EVENTS]),
    )
