"""Search for the first starter (the paper's section 3.1)."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.interface.disc import disc_holds
from surfcmp_core.interface.smallest_circle import is_better
from surfcmp_core.kernel import kernel
from surfcmp_core.triangulation.half_edges import preceding


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
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    begin: int,
    node: int,
    other: int,
) -> int:
    """Turn around a node to a corner whose triangle the other node destroys."""
    h = begin
    while start[h] != node:
        h += 1
    while not disc_holds(nodes, start, h, nodes[other, 0], nodes[other, 1]):
        h = twin[preceding(h)]
    return h


@kernel
def first_starter(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    split_nodes: int,
    split_edges: int,
) -> tuple[int, int]:
    """Find the first starter: the corners of its two ends, each destroyed by the other end.

    The circle that touches the later of the two leftmost nodes and has its centre on the ray to the
    left is empty of that node's grid; the smallest one through a node of the other grid is empty of
    both. Where both leftmost nodes share their x there is no such circle, and the starter is the
    pair of neighbours on that vertical line.
    """
    v = _leftmost(nodes, 0, split_nodes)
    other = _leftmost(nodes, split_nodes, nodes.shape[0])
    begin, end = split_nodes, nodes.shape[0]
    v_edges, d_edges = 0, split_edges
    if nodes[v, 0] < nodes[other, 0] or (
        nodes[v, 0] == nodes[other, 0] and nodes[v, 1] < nodes[other, 1]
    ):
        v, other = other, v
        begin, end = 0, split_nodes
        v_edges, d_edges = split_edges, 0
    vx, vy = nodes[v, 0], nodes[v, 1]
    d = other
    ux = nodes[other, 0]
    if ux < vx:
        for k in range(begin, end):
            if nodes[k, 0] < vx and k != d and is_better(nodes, vx, vy, ux, vy, d, k):
                d = k
    else:
        for k in range(begin, end):
            if nodes[k, 0] == vx and nodes[d, 1] < nodes[k, 1] < vy:
                d = k
    return (
        _corner_towards(nodes, start, twin, v_edges, v, d),
        _corner_towards(nodes, start, twin, d_edges, d, v),
    )
