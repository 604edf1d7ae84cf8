"""Both triangulations in one pair of arrays, so that one routine serves either side."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import kernel
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


@kernel
def _append(
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    tree: NDArray[np.int32],
    node_offset: int,
    edge_offset: int,
    joined_start: NDArray[np.int32],
    joined_twin: NDArray[np.int32],
    marks: NDArray[np.uint8],
) -> None:
    for h in range(start.size):
        joined_start[edge_offset + h] = start[h] + node_offset if start[h] >= 0 else -1
        joined_twin[edge_offset + h] = twin[h] + edge_offset
        marks[edge_offset + h] = 0
    for h in tree:
        marks[edge_offset + h] = BRIDGE
        marks[edge_offset + twin[h]] = BRIDGE


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
    size = h + len(second.start)
    start = np.empty(size, np.int32)
    twin = np.empty(size, np.int32)
    marks = np.empty(size, np.uint8)
    _append(first.start, first.twin, tree_1, 0, 0, start, twin, marks)
    _append(second.start, second.twin, tree_2, n, h, start, twin, marks)
    return Joined(np.concatenate((first.nodes, second.nodes)), start, twin, marks, n, h)
