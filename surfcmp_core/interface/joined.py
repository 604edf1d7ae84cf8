"""Both triangulations in one array, so that one routine serves either side.

Tracing is bound by memory: everything it asks of a triangle lies in eight words side by side, half
a cache line. Corner i of triangle t is number ``8 t + i`` here; the words of a triangle are

====  =========================================================
0-2   start node of each half-edge, -1 at infinity
3     marks: bits 0-2 a corner is passed, bits 3-5 an edge belongs to the spanning tree
4-6   twin of each half-edge
7     unused
====  =========================================================
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import inlined, kernel
from surfcmp_core.triangulation import Triangulation

WORDS = 8
"""Words of a triangle."""
MARKS = 3
"""Place of the marks among them."""
TWIN = 4
"""Places from a half-edge to its twin's number."""
PASSED = 0b111
"""Marks of corners in triangles that the other grid destroys."""
TREE_BITS = 3
"""The mark of a tree's edge stands this far above that of its corner."""

_LINE = 64
"""Bytes of a cache line."""


@inlined
def following(h: int) -> int:
    """Next half-edge of the same triangle, counter-clockwise; without a branch."""
    return h + 1 - 3 * ((h >> 1) & 1)


@inlined
def preceding(h: int) -> int:
    """Previous half-edge of the same triangle; without a branch."""
    return h + 2 - 3 * ((h | (h >> 1)) & 1)


@inlined
def first_of(h: int) -> int:
    """First word of a half-edge's triangle."""
    return h & -8


@dataclass(frozen=True, slots=True, eq=False)
class Joined:
    """T1 and T2 side by side; nothing in them is ever changed but the marks.

    Attributes
    ----------
    nodes : (n1 + n2, 2) float64
        Nodes of grid 1, then of grid 2.
    words : (8 (t1 + t2),) int32
        Triangles and ghosts of T1, then of T2, eight words each: see the module.
    split : int
        n1.
    split_word : int
        Where T2 begins in `words`.
    """

    nodes: NDArray[np.float64]
    words: NDArray[np.int32]
    split: int
    split_word: int


@kernel
def _append(
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    tree: NDArray[np.int32],
    node_offset: int,
    word_offset: int,
    words: NDArray[np.int32],
) -> None:
    for t in range(start.size // 3):
        place = WORDS * t + word_offset
        for i in range(3):
            node = start[3 * t + i]
            words[place + i] = node + node_offset if node >= 0 else -1
            other = twin[3 * t + i]
            words[place + TWIN + i] = WORDS * (other // 3) + other % 3 + word_offset
        words[place + MARKS] = 0
        words[place + 7] = 0
    for k in range(tree.size):
        for h in (tree[k], twin[tree[k]]):
            words[WORDS * (h // 3) + word_offset + MARKS] |= 1 << (TREE_BITS + h % 3)


def join(
    first: Triangulation,
    second: Triangulation,
    tree_1: NDArray[np.int32],
    tree_2: NDArray[np.int32],
) -> Joined:
    """Put two triangulations and their spanning trees side by side.

    Parameters
    ----------
    first, second : Triangulation
        Without a common node.
    tree_1, tree_2 : (n - 1,) int32
        Half-edges of the spanning trees.

    Returns
    -------
    Joined
    """
    split_word = WORDS * (len(first.start) // 3)
    size = split_word + WORDS * (len(second.start) // 3)
    room = np.empty(size + _LINE // 4, np.int32)
    shift = -room.ctypes.data % _LINE // 4
    words = room[shift : shift + size]
    _append(first.start, first.twin, tree_1, 0, 0, words)
    _append(second.start, second.twin, tree_2, len(first.nodes), split_word, words)
    nodes = np.concatenate((first.nodes, second.nodes))
    return Joined(nodes, words, len(first.nodes), split_word)
