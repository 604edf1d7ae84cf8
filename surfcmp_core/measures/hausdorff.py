"""The measure of [5] of the paper, for comparison: distances in space between the nodes."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel, wide
from surfcmp_core.compiled.stack import enlarged
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import following, leaving_edges, preceding

_BATCH = 4096
"""Nodes looked up at once, those with the largest bounds first."""

_WORTH_A_TREE = 8
"""Nodes met for each node there is, from which on a k-d tree is cheaper."""

_FIRST_BATCH = 64
"""Nodes looked up at once in the k-d tree, twice as many each time: of surfaces far apart the first
few spare nearly all others."""

_SLACK = 1.0 + 2.0**-40
"""Rounding must not hide a node on the border of a disc."""


@kernel
def _distance(
    nodes_1: NDArray[np.float64],
    z_1: NDArray[np.float64],
    i: int,
    nodes_2: NDArray[np.float64],
    z_2: NDArray[np.float64],
    j: int,
) -> float:
    dx = nodes_1[i, 0] - nodes_2[j, 0]
    dy = nodes_1[i, 1] - nodes_2[j, 1]
    dz = z_1[i] - z_2[j]
    return float(np.sqrt(dx * dx + dy * dy + dz * dz))


@kernel
def _bounds(
    nodes_1: NDArray[np.float64],
    z_1: NDArray[np.float64],
    nodes_2: NDArray[np.float64],
    z_2: NDArray[np.float64],
    start: NDArray[np.int32],
    found: NDArray[np.int32],
    bound: NDArray[np.float64],
    nearest: NDArray[np.int32],
) -> None:
    """Of the corners of the triangle in which each node of 1 lies, find the nearest."""
    for i in range(found.size):
        bound[i] = np.inf
        nearest[i] = start[3 * found[i]]  # of a ghost too a node
        for h in range(3 * found[i], 3 * found[i] + 3):
            j = start[h]
            if j >= 0:
                distance = _distance(nodes_1, z_1, i, nodes_2, z_2, j)
                if distance < bound[i]:
                    bound[i] = distance
                    nearest[i] = j


@kernel
def _look_up(
    nodes_1: NDArray[np.float64],
    z_1: NDArray[np.float64],
    nodes_2: NDArray[np.float64],
    z_2: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    leaving: NDArray[np.int32],
    batch: NDArray[np.int64],
    nearest: NDArray[np.int32],
    bound: NDArray[np.float64],
    met: NDArray[np.int32],
    largest: float,
    most: int,
) -> tuple[float, int]:
    """Replace the bounds of a batch by the distances, until about `most` nodes have been met.

    The nodes of 2 within a disc in the plane are connected by edges of their Delaunay triangulation
    (any disc, [DobkinFriedmanSupowit1990]), so a flood from the nearest node known so far
    meets all that can be nearer.

    Returns
    -------
    largest : float
        Distance so far.
    count : int
        Nodes met.
    """
    stack = np.empty(64, np.int32)
    count = 0
    for i in batch:
        if bound[i] <= largest:
            continue
        if count > most:
            break
        x, y = nodes_1[i, 0], nodes_1[i, 1]
        least = bound[i]
        stack[0] = nearest[i]
        met[nearest[i]] = i
        depth = 1
        while depth > 0 and least > largest:
            depth -= 1
            begin = wide(leaving[stack[depth]])
            h = begin
            while True:
                j = start[following(h)]
                if j >= 0 and met[j] != i:
                    met[j] = i
                    count += 1
                    dx, dy = nodes_2[j, 0] - x, nodes_2[j, 1] - y
                    if dx * dx + dy * dy <= _SLACK * least * least:
                        least = min(least, _distance(nodes_1, z_1, i, nodes_2, z_2, j))
                        if depth == stack.size:
                            stack = enlarged(stack)
                        stack[depth] = j
                        depth += 1
                h = wide(twin[preceding(h)])
                if h == begin:
                    break
        bound[i] = least
        largest = max(largest, least)
    return largest, count


@kernel
def _spare(
    nodes_1: NDArray[np.float64],
    z_1: NDArray[np.float64],
    nodes_2: NDArray[np.float64],
    z_2: NDArray[np.float64],
    batch: NDArray[np.int64],
    nearest: NDArray[np.int32],
    rows: NDArray[np.int64],
    bound: NDArray[np.float64],
) -> None:
    """Lower the bounds of nodes by what is nearest to those looked up before and after them.

    Both `batch`, the nodes looked up, and `rows` ascend, and nodes run along a curve: where the
    surfaces are far apart, what is nearest to a node is nearest, or nearly so, to many around it.
    """
    after = 0
    for i in rows:
        while after < batch.size and batch[after] < i:
            after += 1
        for k in range(max(after - 1, 0), min(after + 1, batch.size)):
            distance = _distance(nodes_1, z_1, i, nodes_2, z_2, nearest[batch[k]])
            bound[i] = min(bound[i], distance)


@kernel
def _measure(
    nodes_1: NDArray[np.float64],
    z_1: NDArray[np.float64],
    nodes_2: NDArray[np.float64],
    z_2: NDArray[np.float64],
    batch: NDArray[np.int64],
    nearest: NDArray[np.int32],
    bound: NDArray[np.float64],
) -> None:
    """Replace the bounds of nodes by the distances to those nearest."""
    for i in batch:
        bound[i] = _distance(nodes_1, z_1, i, nodes_2, z_2, nearest[i])


def hausdorff(
    nodes_1: NDArray[np.float64],
    z_1: NDArray[np.float64],
    nodes_2: NDArray[np.float64],
    z_2: NDArray[np.float64],
    other: Triangulation,
    found: NDArray[np.int32],
) -> float:
    """Largest distance from a node of surface 1 to the nearest node of surface 2.

    The corners of the triangle in which a node lies bound its distance from above. The nodes with
    the largest bounds are looked up first; those whose bound is below the largest distance found
    need none. They are looked up in the triangulation around them while that is cheap, that is
    where the surfaces are not much farther from each other than their nodes, then in a k-d tree;
    what is nearest to them bounds the distance of the nodes around (early break of
    [TahaHanbury2015]).

    Parameters
    ----------
    nodes_1, z_1 : (n1, 2), (n1,) float64
        Nodes of surface 1 and the values there.
    nodes_2, z_2 : (n2, 2), (n2,) float64
        The same of surface 2, in the same unit.
    other : Triangulation
        Of surface 2, Delaunay; its own coordinates may be scaled.
    found : (n1,) int32
        Triangle or ghost of the other in which each node lies; one near it would do.

    Returns
    -------
    float
        In the nodes' unit.
    """
    bound = np.empty(len(nodes_1))
    nearest = np.empty(len(nodes_1), np.int32)
    _bounds(nodes_1, z_1, nodes_2, z_2, other.start, found, bound, nearest)
    leaving = leaving_edges(other.start, len(nodes_2))
    met = np.full(len(nodes_2), -1, np.int32)
    left = _WORTH_A_TREE * (len(nodes_1) + len(nodes_2))
    rows = np.arange(len(nodes_1))
    largest = 0.0
    tree = None
    at_once = _BATCH if left > 0 else _FIRST_BATCH
    while rows.size:
        batch = rows
        if rows.size > at_once:
            batch = rows[np.argpartition(bound[rows], -at_once)[-at_once:]]
        if left > 0:
            largest, count = _look_up(
                nodes_1,
                z_1,
                nodes_2,
                z_2,
                other.start,
                other.twin,
                leaving,
                batch,
                nearest,
                bound,
                met,
                largest,
                left,
            )
            left -= count
            at_once = _BATCH if left > 0 else _FIRST_BATCH
            rows = rows[bound[rows] > largest]
        else:
            if tree is None:
                from scipy.spatial import cKDTree

                points_2 = np.column_stack((nodes_2, z_2))
                tree = cKDTree(points_2, balanced_tree=False, compact_nodes=False)
            batch.sort()
            _, found_2 = tree.query(np.column_stack((nodes_1[batch], z_1[batch])))
            nearest[batch] = np.minimum(found_2, len(nodes_2) - 1)  # beyond where all is too far
            _measure(nodes_1, z_1, nodes_2, z_2, batch, nearest, bound)
            largest = max(largest, float(bound[batch].max()))
            rows = rows[bound[rows] > largest]
            _spare(nodes_1, z_1, nodes_2, z_2, batch, nearest, rows, bound)
            rows = rows[bound[rows] > largest]
            at_once = min(2 * at_once, _BATCH)
    return largest
