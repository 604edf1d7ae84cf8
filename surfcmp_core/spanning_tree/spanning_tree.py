"""The minimum spanning tree of a Delaunay triangulation (stage 2 of the paper's section 3.2)."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import inlined, kernel, wide
from surfcmp_core.predicates import compare_lengths
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import following

_FILTER = 8.0 * 2.0**-53

_FAR = 2.0**1000
"""Longer than any square."""

_MOST_EDGES = 3
"""A planar graph without double edges has less than so many for each of its nodes."""


@kernel
def _shorter(
    triangulation: Triangulation,
    g: int,
    g_square: float,
    h: int,
    h_square: float,
) -> bool:
    """Whether the edge of half-edge g comes before that of h: exactly by length, then by number."""
    nodes, start, twin, _ = triangulation
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
    return min(g, twin[g]) < min(h, twin[h]) if order == 0.0 else order < 0.0


@kernel
def _mark_longest(
    triangulation: Triangulation,
    longest: NDArray[np.bool_],
) -> None:
    """Mark the half-edge of each triangle whose edge is its longest one."""
    nodes, start, _, real = triangulation
    for t in range(0, 3 * real, 3):
        a, b, c = start[t], start[t + 1], start[t + 2]
        abx, aby = nodes[b, 0] - nodes[a, 0], nodes[b, 1] - nodes[a, 1]
        bcx, bcy = nodes[c, 0] - nodes[b, 0], nodes[c, 1] - nodes[b, 1]
        cax, cay = nodes[a, 0] - nodes[c, 0], nodes[a, 1] - nodes[c, 1]
        first = abx * abx + aby * aby
        second = bcx * bcx + bcy * bcy
        third = cax * cax + cay * cay
        least = _FILTER * (first + second + third)
        if (
            (abs(first - second) > least)
            & (abs(second - third) > least)
            & (abs(third - first) > least)
        ):
            longest[t] = (first > second) & (first > third)
            longest[t + 1] = (second > third) & (second > first)
            longest[t + 2] = (third > first) & (third > second)
            continue
        h = t
        square = first
        if _shorter(triangulation, h, square, t + 1, second):
            h, square = t + 1, second
        if _shorter(triangulation, h, square, t + 2, third):
            h = t + 2
        for k in range(t, t + 3):
            longest[k] = k == h


@kernel
def _candidates(
    triangulation: Triangulation,
    longest: NDArray[np.bool_],
    edges: NDArray[np.int32],
    squares: NDArray[np.float64],
) -> int:
    """Collect the edges that are not the longest of a triangle, which no tree contains."""
    nodes, start, twin, real = triangulation
    count = 0
    for h in range(3 * real):  # without a branch, which nothing could foretell
        k = twin[h]
        edges[count] = h
        count += (h < k) & ~(longest[h] | longest[k])
    for place in range(count):
        a, b = start[edges[place]], start[following(edges[place])]
        dx = nodes[a, 0] - nodes[b, 0]
        dy = nodes[a, 1] - nodes[b, 1]
        squares[place] = dx * dx + dy * dy
    return count


@inlined
def _root(parent: NDArray[np.int32], v: int) -> int:
    while parent[v] != v:
        parent[v] = parent[parent[v]]
        v = parent[v]
    return v


@kernel
def _keep_shortest(
    triangulation: Triangulation,
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
            g, h = wide(edges[k]), wide(edges[b])
            if _shorter(triangulation, g, squares[k], h, squares[b]):
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
    triangulation: Triangulation,
    edges: NDArray[np.int32],
    squares: NDArray[np.float64],
    tree: NDArray[np.int32],
) -> int:
    """Run Borůvka's rounds; each joins every part to another over its shortest edge.

    After a round edges inside a part are gone, and where more are left than a planar graph of so
    many parts can have, of several between the same two parts only the shortest stays. So a round
    is linear in its parts, of which each leaves at most half: all of them are linear in the nodes.
    """
    start = triangulation.start
    parts = triangulation.nodes.shape[0]
    tail = np.empty(edges.size, np.int32)
    head = np.empty(edges.size, np.int32)
    for k in range(edges.size):
        tail[k] = start[edges[k]]
        head[k] = start[following(edges[k])]
    live = edges.size
    found = 0
    while parts > 1 and live > 0:
        best = np.full(parts, -1, np.int32)
        nearest = np.full(parts, _FAR)
        for k in range(live):
            square = squares[k]
            for v in (tail[k], head[k]):
                b, before = best[v], nearest[v]
                shorter = square < before
                if not abs(square - before) > _FILTER * (square + before):
                    g, h = wide(edges[k]), wide(edges[b])
                    shorter = _shorter(triangulation, g, square, h, before)
                best[v] = k if shorter else b
                nearest[v] = square if shorter else before
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
        live = kept
        if live > _MOST_EDGES * parts:  # several between the same two parts
            live = _keep_shortest(triangulation, edges, squares, tail, head, live, parts)
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
    [Boruvka1926]; with clean-up linear for planar graphs ([CheritonTarjan1976], the paper's [15]).
    """
    longest = np.zeros(len(triangulation.start), np.bool_)
    _mark_longest(triangulation, longest)
    edges = np.empty(len(longest) // 2 + 1, np.int32)
    squares = np.empty(len(edges))
    count = _candidates(triangulation, longest, edges, squares)
    tree = np.empty(len(triangulation.nodes) - 1, np.int32)
    found = _join(triangulation, edges[:count], squares[:count], tree)
    assert found == len(tree), "a triangulation is connected"
    return tree


@kernel
def _ends(start: NDArray[np.int32], tree: NDArray[np.int32], ends: NDArray[np.int32]) -> None:
    for k in range(tree.size):
        ends[k, 0] = start[tree[k]]
        ends[k, 1] = start[following(tree[k])]


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
    ends = np.empty((len(tree), 2), np.int32)
    _ends(triangulation.start, tree, ends)
    return ends
