"""The minimum spanning tree of a Delaunay triangulation (stage 2 of the paper's section 3.2)."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import inlined, kernel, wide
from surfcmp_core.predicates import compare_lengths
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import following

_FILTER = 8.0 * 2.0**-53


@inlined
def _shorter(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    g: int,
    g_square: float,
    h: int,
    h_square: float,
) -> bool:
    """Whether edge g comes before h: exactly by length, then by number."""
    if abs(g_square - h_square) > _FILTER * (g_square + h_square):
        return g_square < h_square
    a, b, c, d = start[g], start[following(g)], start[h], start[following(h)]
    order = compare_lengths(
        nodes[a, 0],
        nodes[a, 1],
        nodes[b, 0],
        nodes[b, 1],
        nodes[c, 0],
        nodes[c, 1],
        nodes[d, 0],
        nodes[d, 1],
    )
    return g < h if order == 0.0 else order < 0.0


@kernel
def _candidates(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    real: int,
    edges: NDArray[np.int32],
    squares: NDArray[np.float64],
) -> int:
    """Collect the edges that are not the longest of a triangle, which no tree contains."""
    longest = np.zeros(3 * real, np.bool_)
    square = np.empty(3)
    edge = np.empty(3, np.int64)
    for t in range(0, 3 * real, 3):
        for i in range(3):
            h = t + i
            a, b = start[h], start[following(h)]
            dx = nodes[a, 0] - nodes[b, 0]
            dy = nodes[a, 1] - nodes[b, 1]
            square[i] = dx * dx + dy * dy
            edge[i] = min(h, twin[h])
        k = 0
        if _shorter(nodes, start, edge[0], square[0], edge[1], square[1]):
            k = 1
        if _shorter(nodes, start, edge[k], square[k], edge[2], square[2]):
            k = 2
        longest[edge[k]] = True
    count = 0
    for h in range(3 * real):
        if h < twin[h] and not longest[h]:
            a, b = start[h], start[following(h)]
            dx = nodes[a, 0] - nodes[b, 0]
            dy = nodes[a, 1] - nodes[b, 1]
            edges[count] = h
            squares[count] = dx * dx + dy * dy
            count += 1
    return count


@inlined
def _root(parent: NDArray[np.int32], v: int) -> int:
    while parent[v] != v:
        parent[v] = parent[parent[v]]
        v = parent[v]
    return v


@kernel
def _keep_shortest(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    edges: NDArray[np.int32],
    squares: NDArray[np.float64],
    tail: NDArray[np.int32],
    head: NDArray[np.int32],
    count: int,
    parts: int,
) -> int:
    """Of the edges between the same two parts keep the shortest, in place and in linear time."""
    first = np.zeros(parts + 1, np.int32)
    for k in range(count):
        first[tail[k] + 1] += 1
    for v in range(parts):
        first[v + 1] += first[v]
    grouped = np.empty(count, np.int32)
    for k in range(count):
        grouped[first[tail[k]]] = k
        first[tail[k]] += 1
    stays = np.zeros(count, np.bool_)
    seen_from = np.full(parts, -1, np.int32)
    shortest = np.empty(parts, np.int32)
    for place in range(count):
        k = int(grouped[place])
        q = head[k]
        if seen_from[q] != tail[k]:
            seen_from[q] = tail[k]
            shortest[q] = k
            stays[k] = True
        else:
            b = shortest[q]
            if _shorter(nodes, start, edges[k], squares[k], edges[b], squares[b]):
                stays[b] = False
                stays[k] = True
                shortest[q] = k
    kept = 0
    for k in range(count):
        if stays[k]:
            edges[kept] = edges[k]
            squares[kept] = squares[k]
            tail[kept] = tail[k]
            head[kept] = head[k]
            kept += 1
    return kept


@kernel
def _join(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    edges: NDArray[np.int32],
    squares: NDArray[np.float64],
    tree: NDArray[np.int32],
) -> int:
    """Run Borůvka's rounds; each joins every part to another over its shortest edge.

    After a round edges inside a part are gone, and of several between the same two parts only the
    shortest stays: for a planar graph the work of all rounds is then linear in the nodes.
    """
    parts = nodes.shape[0]
    tail = np.empty(edges.size, np.int32)
    head = np.empty(edges.size, np.int32)
    for k in range(edges.size):
        tail[k] = start[edges[k]]
        head[k] = start[following(edges[k])]
    live = edges.size
    found = 0
    while parts > 1 and live > 0:
        best = np.full(parts, -1, np.int32)
        for k in range(live):
            for v in (tail[k], head[k]):
                b = best[v]
                if b < 0 or _shorter(nodes, start, edges[k], squares[k], edges[b], squares[b]):
                    best[v] = k
        parent = np.arange(parts).astype(np.int32)
        for v in range(parts):
            k = best[v]
            if k >= 0:
                p = _root(parent, tail[k])
                q = _root(parent, head[k])
                if p != q:
                    parent[max(p, q)] = min(p, q)
                    tree[found] = edges[k]
                    found += 1
        number = np.empty(parts, np.int32)
        joined = wide(0)
        for v in range(parts):
            if parent[v] == v:
                number[v] = joined
                joined += 1
            else:  # a root has a lower number than what hangs on it
                number[v] = number[_root(parent, v)]
        kept = wide(0)
        for k in range(live):
            p = number[tail[k]]
            q = number[head[k]]
            if p != q:
                edges[kept] = edges[k]
                squares[kept] = squares[k]
                tail[kept] = min(p, q)
                head[kept] = max(p, q)
                kept += 1
        parts = joined
        live = _keep_shortest(nodes, start, edges, squares, tail, head, kept, parts)
    return found


def spanning_tree(triangulation: Triangulation) -> NDArray[np.int32]:
    """Find the minimum spanning tree of a triangulation's edges.

    Lengths are compared exactly, so the circle over each edge of the tree as diameter (the
    influence circle) holds no other node, not even on its border.

    Parameters
    ----------
    triangulation : Triangulation
        n nodes.

    Returns
    -------
    (n - 1,) int32
        Half-edges, one for each edge of the tree.

    References
    ----------
    Borůvka 1926; with clean-up linear for planar graphs (Cheriton and Tarjan 1976, the paper's
    [15]).
    """
    start, real = triangulation.start, triangulation.real
    edges = np.empty(len(start) // 2 + 1, np.int32)
    squares = np.empty(len(edges))
    count = _candidates(triangulation.nodes, start, triangulation.twin, real, edges, squares)
    tree = np.empty(len(triangulation.nodes) - 1, np.int32)
    found = _join(triangulation.nodes, start, edges[:count].copy(), squares[:count].copy(), tree)
    assert found == len(tree), "a triangulation is connected"
    return tree


def tree_ends(triangulation: Triangulation, tree: NDArray[np.int32]) -> NDArray[np.int32]:
    """Give the nodes at either end of a tree's edges.

    Parameters
    ----------
    triangulation : Triangulation
    tree : (n - 1,) int32
        Half-edges.

    Returns
    -------
    (n - 1, 2) int32
    """
    onward = np.where(tree % 3 == 2, tree - 2, tree + 1)
    return np.stack((triangulation.start[tree], triangulation.start[onward]), axis=1)
