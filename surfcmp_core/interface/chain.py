"""Tracing of one chain with bundle correction (the paper's section 3.1, steps (a) to (e)).

Each disc is tested in coordinates relative to one end of the current edge AB, so that of the
in-circle determinant |A|² (U × W) + |U|² (W × A) + |W|² (A × U) only what belongs to the new node W
is computed anew while a bundle turns.
"""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import inlined, kernel, wide
from surfcmp_core.interface.disc import disc_holds
from surfcmp_core.interface.events import N_TESTS, Event, Record, note
from surfcmp_core.interface.joined import (
    MARKS,
    TREE_BITS,
    TWIN,
    first_of,
    following,
    preceding,
)
from surfcmp_core.predicates import LENGTHS_FILTER, in_disc

N_TRIANGLES = 0
"""Place among the counters of the number of triangles emitted."""
N_BRIDGES = 1
"""Place of the number of bridges on the stack."""

_EDGE_PASSED, _TRIANGLE, _BRIDGE = (
    int(Event.EDGE_PASSED),
    int(Event.TRIANGLE),
    int(Event.BRIDGE),
)


@kernel
def _in_disc_exactly(nodes: NDArray[np.float64], a: int, b: int, c: int, p: int) -> bool:
    return in_disc(
        nodes[a, 0],
        nodes[a, 1],
        nodes[b, 0],
        nodes[b, 1],
        nodes[c, 0],
        nodes[c, 1],
        nodes[p, 0],
        nodes[p, 1],
    )


@inlined
def _pass(words: NDArray[np.int32], corner: int) -> None:
    words[first_of(corner) + MARKS] |= 1 << (corner & 3)


@inlined
def _pass_and_push(
    words: NDArray[np.int32],
    stack: NDArray[np.int32],
    top: int,
    corner: int,
    edge: int,
    free_edge: int,
    other_corner: int,
) -> int:
    """Pass a corner over an edge; where the edge is a bridge it stays on the stack."""
    marks = words[first_of(corner) + MARKS]
    words[first_of(corner) + MARKS] = marks | (1 << (corner & 3))
    stack[2 * top] = free_edge
    stack[2 * top + 1] = other_corner
    return int(top + ((marks >> (TREE_BITS + (edge & 3))) & 1))


@kernel
def trace_chain(
    nodes: NDArray[np.float64],
    words: NDArray[np.int32],
    base: NDArray[np.int32],
    apex: NDArray[np.int32],
    stack: NDArray[np.int32],
    counters: NDArray[np.int64],
    record: Record,
    a: int,
    b: int,
) -> bool:
    """Trace to the left of a starter until the chain closes (True) or ends on the hull (False).

    Parameters
    ----------
    nodes, words
        Of `Joined`; marks are set.
    base, apex : int32
        Triangles are appended here, see `Chains`.
    stack : int32
        Bridges are pushed here: the half-edge from the free node, and the corner of the other grid
        where tracing stood.
    counters : int64
    record
        The record.
    a, b : int
        The last corners passed at the ends A and B of the starter.

    Returns
    -------
    bool
    """
    # (a) the starter is the current edge
    A, B = wide(words[a]), wide(words[b])
    first_A, first_B = A, B
    _pass(words, a)
    _pass(words, b)
    begin = counters[N_TRIANGLES]
    count = begin
    top = counters[N_BRIDGES]
    closed = False
    while True:
        # (b) correct the bundle of A, counter-clockwise, in coordinates relative to B ...
        Ax, Ay = nodes[np.uintp(A), 0], nodes[np.uintp(A), 1]
        Bx, By = nodes[np.uintp(B), 0], nodes[np.uintp(B), 1]
        ax, ay = Ax - Bx, Ay - By
        a_square = ax * ax + ay * ay
        out = preceding(a)
        A1 = wide(words[np.uintp(out)])
        ux, uy = 0.0, 0.0
        if A1 >= 0:
            ux, uy = nodes[np.uintp(A1), 0] - Bx, nodes[np.uintp(A1), 1] - By
        u_square = ux * ux + uy * uy
        a_cross_u = ax * uy - ux * ay
        while True:
            onward = wide(words[np.uintp(out + TWIN)])
            onward_out = preceding(onward)
            W = wide(words[np.uintp(onward_out)])
            if record is not None:
                counters[N_TESTS] += 1
            wx, wy = 0.0, 0.0
            if W >= 0:
                wx, wy = nodes[np.uintp(W), 0] - Bx, nodes[np.uintp(W), 1] - By
            w_square = wx * wx + wy * wy
            w_cross_a = wx * ay - ax * wy
            if W >= 0 and A1 >= 0:
                determinant = (
                    a_square * (ux * wy - wx * uy) + u_square * w_cross_a + w_square * a_cross_u
                )
                bound = LENGTHS_FILTER * (a_square * u_square + w_square * (a_square + u_square))
                if determinant < -bound:
                    break
                if determinant <= bound and not _in_disc_exactly(nodes, A, A1, W, B):
                    break
            elif not disc_holds(nodes, words, onward, B):
                break
            if record is not None:
                note(record, counters, _EDGE_PASSED, A, A1)
                if (words[first_of(onward) + MARKS] >> (TREE_BITS + (onward & 3))) & 1:
                    note(record, counters, _BRIDGE, A1, A)
            top = _pass_and_push(words, stack, top, onward, onward, out, b)
            a, out, A1 = onward, onward_out, W
            ux, uy, u_square, a_cross_u = wx, wy, w_square, -w_cross_a
        # ... and the bundle of B, clockwise, relative to A
        B1 = wide(words[np.uintp(following(b))])
        ux, uy = 0.0, 0.0
        if B1 >= 0:
            ux, uy = nodes[np.uintp(B1), 0] - Ax, nodes[np.uintp(B1), 1] - Ay
        v_square = ux * ux + uy * uy
        u_cross_b = uy * ax - ux * ay
        while True:
            back = wide(words[np.uintp(b + TWIN)])
            onward = following(back)
            W = wide(words[np.uintp(following(onward))])
            if record is not None:
                counters[N_TESTS] += 1
            wx, wy = 0.0, 0.0
            if W >= 0:
                wx, wy = nodes[np.uintp(W), 0] - Ax, nodes[np.uintp(W), 1] - Ay
            w_square = wx * wx + wy * wy
            b_cross_w = wx * ay - ax * wy
            if W >= 0 and B1 >= 0:
                determinant = (
                    a_square * (wx * uy - ux * wy) + w_square * u_cross_b + v_square * b_cross_w
                )
                bound = LENGTHS_FILTER * (a_square * v_square + w_square * (a_square + v_square))
                if determinant < -bound:
                    break
                if determinant <= bound and not _in_disc_exactly(nodes, B, W, B1, A):
                    break
            elif not disc_holds(nodes, words, onward, A):
                break
            if record is not None:
                note(record, counters, _EDGE_PASSED, B, B1)
                if (words[first_of(onward) + MARKS] >> (TREE_BITS + (back & 3))) & 1:
                    note(record, counters, _BRIDGE, B1, B)
            top = _pass_and_push(words, stack, top, onward, back, back, a)
            b, B1 = onward, W
            ux, uy, v_square, u_cross_b = wx, wy, w_square, -b_cross_w
        # only now, for the edges between the last corner and the starter's own are destroyed too
        if count > begin and first_A == A and first_B == B:
            closed = True
            break
        # (c) the new edge ends at the candidate whose triangle has an empty disc
        if A1 < 0 and B1 < 0:
            break  # a terminal edge
        take_A = B1 < 0
        if A1 >= 0 and B1 >= 0:
            ux, uy = nodes[np.uintp(A1), 0] - Bx, nodes[np.uintp(A1), 1] - By
            wx, wy = nodes[np.uintp(B1), 0] - Bx, nodes[np.uintp(B1), 1] - By
            w_square = wx * wx + wy * wy
            determinant = (
                a_square * (wx * uy - ux * wy)
                + w_square * (ux * ay - ax * uy)
                + u_square * (ax * wy - wx * ay)
            )
            bound = LENGTHS_FILTER * (a_square * w_square + u_square * (a_square + w_square))
            if determinant > bound:
                take_A = True
            elif determinant >= -bound:
                take_A = not _in_disc_exactly(nodes, A, B, A1, B1)
            if record is not None:
                counters[N_TESTS] += 1
        # (d), (e) the edge to it is passed at its other end too; there the new edge continues
        if take_A:
            base[np.uintp(count)] = out
            apex[np.uintp(count)] = B
            a = out
            A = A1
            _pass(words, a)
        else:
            base[np.uintp(count)] = b
            apex[np.uintp(count)] = A
            b = following(b)
            B = B1
            _pass(words, b)
        if record is not None:
            note(record, counters, _TRIANGLE, count, A1 if take_A else B1)
        count += 1
    counters[N_TRIANGLES] = count
    counters[N_BRIDGES] = top
    return closed
