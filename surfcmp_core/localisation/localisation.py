"""Localisation of the nodes of one grid in the triangulation of the other (the paper's stage 3)."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates import orientation
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import following


@kernel
def walk_to(
    triangulation: Triangulation,
    triangle: int,
    px: float,
    py: float,
) -> int:
    """Walk to the real triangle that holds p, or to the ghost of a hull edge that p is outside of.

    Each step crosses an edge that has p strictly beyond it; in a Delaunay triangulation such a walk
    ends.
    """
    nodes, start, twin, _ = triangulation
    entry = -1
    h = 3 * triangle
    if start[h + 2] < 0:
        h = int(twin[h]) - int(twin[h]) % 3
    while True:
        onward = -1
        for k in range(h, h + 3):
            if k != entry:
                a, b = start[k], start[following(k)]
                if orientation(nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1], px, py) < 0.0:
                    onward = k
                    break
        if onward < 0:
            return h // 3
        entry = int(twin[onward])
        h = entry - entry % 3
        if start[h + 2] < 0:
            return h // 3


@kernel
def _locate_along_tree(
    triangulation: Triangulation,
    queries: NDArray[np.float64],
    tree: NDArray[np.int32],
    found: NDArray[np.int32],
) -> None:
    count = queries.shape[0]
    first = np.zeros(count + 2, np.int32)
    for k in range(tree.shape[0]):
        first[tree[k, 0] + 2] += 1
        first[tree[k, 1] + 2] += 1
    for v in range(count):
        first[v + 2] += first[v + 1]
    neighbour = np.empty(2 * tree.shape[0], np.int32)
    for k in range(tree.shape[0]):
        for side in range(2):
            v = tree[k, side]
            neighbour[first[v + 1]] = tree[k, 1 - side]
            first[v + 1] += 1
    for v in range(count):
        found[v] = -1
    stack = np.empty(count, np.int32)
    stack[0] = 0
    depth = 1
    found[0] = 0
    found[0] = walk_to(triangulation, found[0], queries[0, 0], queries[0, 1])
    while depth > 0:
        depth -= 1
        v = stack[depth]
        for k in range(first[v], first[v + 1]):
            w = neighbour[k]
            if found[w] < 0:
                found[w] = walk_to(triangulation, found[v], queries[w, 0], queries[w, 1])
                stack[depth] = w
                depth += 1


@kernel
def _locate_from(
    triangulation: Triangulation,
    queries: NDArray[np.float64],
    found: NDArray[np.int32],
) -> None:
    for k in range(queries.shape[0]):
        found[k] = walk_to(triangulation, found[k], queries[k, 0], queries[k, 1])


def locate_along_tree(
    target: Triangulation, queries: NDArray[np.float64], tree: NDArray[np.int32]
) -> NDArray[np.int32]:
    """Locate the nodes of one grid in the triangulation of the other.

    Each walk starts where the node's neighbour along the spanning tree was found, so all walks are
    short: linear in the nodes as far as experiments go.

    Parameters
    ----------
    target : Triangulation
        The other grid's.
    queries : (n, 2) float64
        Nodes of the one grid.
    tree : (n - 1, 2) int32
        Its spanning tree in numbers of `queries`.

    Returns
    -------
    (n,) int32
        A triangle of `target` that holds the node (borders included), or the ghost of a hull edge
        that has the node outside.

    References
    ----------
    Stage 3 of the paper's section 3.2.
    """
    found = np.empty(len(queries), np.int32)
    _locate_along_tree(target, queries, tree, found)
    return found


def locate_from(
    target: Triangulation, queries: NDArray[np.float64], hints: NDArray[np.int32]
) -> NDArray[np.int32]:
    """Locate places in a triangulation, each walk from a triangle nearby.

    Parameters
    ----------
    target : Triangulation
    queries : (n, 2) float64
    hints : (n,) int32
        Triangle or ghost to start each walk from.

    Returns
    -------
    (n,) int32
        As in :func:`locate_along_tree`.
    """
    found = np.array(hints, np.int32)
    _locate_from(target, queries, found)
    return found
