"""All chains of interface triangles in one compiled pass (the paper's section 3.1).

The letters in the comments are those of the paper's steps.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.interface.disc import disc_holds
from surfcmp_core.interface.first_starter import first_starter
from surfcmp_core.interface.joined import BRIDGE, PASSED, PUSHED, Joined
from surfcmp_core.interface.next_starter import next_starter
from surfcmp_core.kernel import inlined, kernel
from surfcmp_core.predicates import in_disc
from surfcmp_core.triangulation.half_edges import following, preceding

_SLICE = 1 << 18
"""Interface triangles between two looks at whether the user cancelled."""

# places of the kernel's counters between two slices
_TRIANGLES, _CHAINS, _BRIDGES, _STARTED = range(4)


@dataclass(frozen=True, slots=True, eq=False)
class Chains:
    """Interface triangles, chain after chain, in the order of tracing.

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
    """

    base: NDArray[np.int32]
    apex: NDArray[np.int32]
    first: NDArray[np.int32]
    closed: NDArray[np.bool_]


@inlined
def _push(
    marks: NDArray[np.uint8],
    stack: NDArray[np.int32],
    counters: NDArray[np.int64],
    bridge: int,
    other_corner: int,
) -> None:
    if marks[bridge] & (PASSED | PUSHED) == 0:
        marks[bridge] |= PUSHED
        top = 2 * counters[_BRIDGES]
        stack[top] = bridge
        stack[top + 1] = other_corner
        counters[_BRIDGES] += 1


@kernel
def _trace(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    marks: NDArray[np.uint8],
    base: NDArray[np.int32],
    apex: NDArray[np.int32],
    stack: NDArray[np.int32],
    counters: NDArray[np.int64],
    a: int,
    b: int,
) -> bool:
    """Trace to the left of a starter until the chain closes (True) or ends on the hull (False).

    `a` and `b` are corners at the ends A and B of the current edge, the last ones passed.
    """
    A = start[a]
    B = start[b]
    # (a) the starter is the current edge
    first_A = A
    first_B = B
    marks[a] |= PASSED
    marks[b] |= PASSED
    count = counters[_TRIANGLES]
    begin = count
    closed = False
    while True:
        Ax, Ay = nodes[A, 0], nodes[A, 1]
        Bx, By = nodes[B, 0], nodes[B, 1]
        # (b) correct the bundle of A, counter-clockwise ...
        while True:
            onward = twin[preceding(a)]
            if not disc_holds(nodes, start, onward, Bx, By):
                break
            if marks[onward] & BRIDGE:
                _push(marks, stack, counters, preceding(a), b)
            a = onward
            marks[a] |= PASSED
        # ... and the bundle of B, clockwise
        while True:
            back = twin[b]
            onward = following(back)
            if not disc_holds(nodes, start, onward, Ax, Ay):
                break
            if marks[back] & BRIDGE:
                _push(marks, stack, counters, back, a)
            b = onward
            marks[b] |= PASSED
        # only now, for the edges between the last corner and the starter's own are destroyed too
        if count > begin and first_A == A and first_B == B:
            closed = True
            break
        # (c) the new edge ends at the candidate whose triangle has an empty disc
        A1 = start[preceding(a)]
        B1 = start[following(b)]
        if A1 < 0 and B1 < 0:
            break  # a terminal edge
        if B1 < 0:
            take_A = True
        elif A1 < 0:
            take_A = False
        else:
            take_A = not in_disc(
                Ax, Ay, Bx, By, nodes[A1, 0], nodes[A1, 1], nodes[B1, 0], nodes[B1, 1]
            )
        # (d), (e) the edge to it is passed at its other end too; there the new edge continues
        if take_A:
            a = preceding(a)
            base[count] = a
            apex[count] = B
            marks[a] |= PASSED
            A = A1
        else:
            base[count] = b
            apex[count] = A
            b = following(b)
            marks[b] |= PASSED
            B = B1
        count += 1
    counters[_TRIANGLES] = count
    return closed


@kernel
def _extract(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    marks: NDArray[np.uint8],
    split_nodes: int,
    split_edges: int,
    base: NDArray[np.int32],
    apex: NDArray[np.int32],
    first: NDArray[np.int32],
    closed: NDArray[np.bool_],
    stack: NDArray[np.int32],
    counters: NDArray[np.int64],
    pause: int,
) -> bool:
    """Trace chains until about `pause` triangles are found; True when all chains are."""
    while counters[_TRIANGLES] < pause:
        if counters[_STARTED] == 0:
            counters[_STARTED] = 1
            a, b = first_starter(nodes, start, twin, split_nodes, split_edges)
        else:
            if counters[_BRIDGES] == 0:
                return True
            counters[_BRIDGES] -= 1
            top = 2 * counters[_BRIDGES]
            bridge = stack[top]
            if marks[bridge] & PASSED:
                continue  # its free node has been traced meanwhile
            a, b = next_starter(nodes, start, twin, bridge, stack[top + 1])
        chain = counters[_CHAINS]
        begin = counters[_TRIANGLES]
        first[chain] = begin
        is_closed = _trace(nodes, start, twin, marks, base, apex, stack, counters, a, b)
        if not is_closed:  # the other side of the starter, its ends exchanged
            i = begin
            j = counters[_TRIANGLES] - 1
            while i < j:
                base[i], base[j] = base[j], base[i]
                apex[i], apex[j] = apex[j], apex[i]
                i += 1
                j -= 1
            _trace(nodes, start, twin, marks, base, apex, stack, counters, b, a)
        closed[chain] = is_closed
        counters[_CHAINS] = chain + 1
    return False


def extract_chains(joined: Joined, progress: Callable[[float], None] | None = None) -> Chains:
    """Extract all chains of interface triangles, in time linear in the nodes.

    Parameters
    ----------
    joined : Joined
        Triangulations of two grids without a common node, unmarked. Its `marks` are filled:
        surviving triangles are those without a passed corner.
    progress : callable, optional
        Called between chains with the share of the largest possible number of triangles; may raise
        to cancel.

    Returns
    -------
    Chains

    References
    ----------
    Section 3.1 of the paper; Kirkpatrick 1979; Mestetskiy and Tsarik 2004.
    """
    count = len(joined.nodes)
    room = 2 * count
    base = np.empty(room, np.int32)
    apex = np.empty(room, np.int32)
    first = np.empty(room + 1, np.int32)
    closed = np.empty(room, np.bool_)
    stack = np.empty(4 * count, np.int32)
    counters = np.zeros(4, np.int64)
    while not _extract(
        joined.nodes,
        joined.start,
        joined.twin,
        joined.marks,
        joined.split_nodes,
        joined.split_edges,
        base,
        apex,
        first,
        closed,
        stack,
        counters,
        int(counters[_TRIANGLES]) + _SLICE,
    ):
        if progress is not None:
            progress(float(counters[_TRIANGLES]) / room)
    triangles, chains = int(counters[_TRIANGLES]), int(counters[_CHAINS])
    first[chains] = triangles
    return Chains(base[:triangles], apex[:triangles], first[: chains + 1], closed[:chains])
