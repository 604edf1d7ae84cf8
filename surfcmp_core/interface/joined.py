"""Both triangulations in one pair of arrays, so that one routine serves either side."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.triangulation import Triangulation

PASSED = np.uint8(1)
"""The corner lies in a triangle that the other grid destroys, and tracing has seen it."""
BRIDGE = np.uint8(2)
"""The edge belongs to a spanning tree: destroying it makes it a bridge."""
PUSHED = np.uint8(4)
"""The bridge is on the list already, with this half-edge's start as its free node."""


@dataclass(frozen=True, slots=True, eq=False)
class Joined:
    """T1 and T2 side by side; nothing in them is ever changed but the marks.

    Attributes
    ----------
    nodes : (n1 + n2, 2) float64
        Nodes of grid 1, then of grid 2.
    start, twin : (H1 + H2,) int32
        Half-edges of T1, then of T2, ghosts included, in these numbers.
    marks : (H1 + H2,) uint8
        PASSED, BRIDGE and PUSHED bits of each half-edge.
    split_nodes, split_edges : int
        n1 and H1.
    """

    nodes: NDArray[np.float64]
    start: NDArray[np.int32]
    twin: NDArray[np.int32]
    marks: NDArray[np.uint8]
    split_nodes: int
    split_edges: int


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
    tree_1, tree_2 : (n - 1,) int32
        Half-edges of the spanning trees.

    Returns
    -------
    Joined
    """
    n, h = len(first.nodes), len(first.start)
    start = np.concatenate((first.start, second.start))
    start[h:] += np.int32(n)
    start[h:][second.start < 0] = -1
    twin = np.concatenate((first.twin, second.twin))
    twin[h:] += np.int32(h)
    marks = np.zeros(len(start), np.uint8)
    marks[tree_1] = BRIDGE
    marks[first.twin[tree_1]] = BRIDGE
    marks[h:][tree_2] = BRIDGE
    marks[h:][second.twin[tree_2]] = BRIDGE
    return Joined(np.concatenate((first.nodes, second.nodes)), start, twin, marks, n, h)
