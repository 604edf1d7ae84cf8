"""Search for the first starter (the paper's section 3.1)."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel, wide
from surfcmp_core.interface.disc import disc_holds
from surfcmp_core.interface.events import Event, Record, note
from surfcmp_core.interface.joined import TWIN, WORDS, preceding
from surfcmp_core.interface.smallest_circle import is_better

_CIRCLE = int(Event.CIRCLE)


@kernel
def _leftmost(nodes: NDArray[np.float64], begin: int, end: int) -> int:
    """Find the lexicographically first node."""
    best = begin
    for k in range(begin + 1, end):
        if nodes[k, 0] < nodes[best, 0] or (
            nodes[k, 0] == nodes[best, 0] and nodes[k, 1] < nodes[best, 1]
        ):
            best = k
    return best


@kernel
def _corner_towards(
    nodes: NDArray[np.float64], words: NDArray[np.int32], begin: int, node: int, other: int
) -> int:
    """Turn around a node to a corner whose triangle the other node destroys."""
    h = begin
    while words[h] != node:
        h += 1 if h % WORDS < 2 else WORDS - 2
    while not disc_holds(nodes, words, h, other):
        h = wide(words[preceding(h) + TWIN])
    return h


@kernel
def first_starter(
    nodes: NDArray[np.float64],
    words: NDArray[np.int32],
    split: int,
    split_word: int,
    record: Record,
    counters: NDArray[np.int64],
) -> tuple[int, int]:
    """Find the first starter: the corners of its two ends, each destroyed by the other end.

    The circle that touches the later of the two leftmost nodes and has its centre on the ray to the
    left is empty of that node's grid; the smallest one through a node of the other grid is empty of
    both. Where both leftmost nodes share their x there is no such circle, and the starter is the
    pair of neighbours on that vertical line.
    """
    v = _leftmost(nodes, wide(0), split)
    d = _leftmost(nodes, split, nodes.shape[0])
    begin, end = split, nodes.shape[0]
    v_word, d_word = 0, split_word
    if nodes[v, 0] < nodes[d, 0] or (nodes[v, 0] == nodes[d, 0] and nodes[v, 1] < nodes[d, 1]):
        v, d = d, v
        begin, end = 0, split
        v_word, d_word = split_word, 0
    vx, vy = nodes[v, 0], nodes[v, 1]
    ux = nodes[d, 0]
    if record is not None:
        note(record, counters, _CIRCLE, v, d)
    for k in range(begin, end):
        if ux < vx:
            better = (
                nodes[k, 0] < vx
                and k != d
                and is_better(vx, vy, ux, vy, nodes[d, 0], nodes[d, 1], nodes[k, 0], nodes[k, 1])
            )
        else:
            better = nodes[k, 0] == vx and nodes[d, 1] < nodes[k, 1] < vy
        if better:
            d = k
            if record is not None:
                note(record, counters, _CIRCLE, v, d)
    return (
        _corner_towards(nodes, words, v_word, v, d),
        _corner_towards(nodes, words, d_word, d, v),
    )
