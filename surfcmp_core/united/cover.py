"""Sums that tell whether triangles cover a convex hull once, and the hull."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates import orientation


@kernel
def _any_place(node: int) -> tuple[int, int]:
    """Give a node a place of whole numbers modulo 2**64 that has nothing to do with its own."""
    key = np.uint64(node + 1) * np.uint64(0x9E3779B97F4A7C15)
    key ^= key >> np.uint64(29)
    x = key * np.uint64(0xBF58476D1CE4E5B9)
    y = (key ^ (x >> np.uint64(32))) * np.uint64(0x94D049BB133111EB)
    return x, y  # type: ignore[return-value]


@kernel
def areas_anywhere(
    begin: int, end: int, triangles: NDArray[np.int32], used: NDArray[np.bool_]
) -> int:
    """Sum up twice the areas of triangles begin..end-1, their nodes at any places; mark nodes."""
    total = np.uint64(0)
    for t in range(begin, end):
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        ax, ay = _any_place(a)
        bx, by = _any_place(b)
        cx, cy = _any_place(c)
        total += (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        used[a] = True
        used[b] = True
        used[c] = True
    return total  # type: ignore[return-value]


@kernel
def area_of_polygon(polygon: NDArray[np.int64]) -> int:
    """Twice the area of a polygon whose nodes lie at the same places."""
    total = np.uint64(0)
    ax, ay = _any_place(polygon[0])
    for k in range(1, polygon.size - 1):
        bx, by = _any_place(polygon[k])
        cx, cy = _any_place(polygon[k + 1])
        total += (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
    return total  # type: ignore[return-value]


@kernel
def _half_hull(nodes: NDArray[np.float64], order: NDArray[np.int64]) -> NDArray[np.int64]:
    """Of nodes in lexicographic order, or the reverse, keep the hull to the right of the way."""
    kept = np.empty(order.size, np.int64)
    count = 0
    for v in order:
        while count > 1:
            a, b = kept[count - 2], kept[count - 1]
            ax, ay, bx, by = nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1]
            if orientation(ax, ay, bx, by, nodes[v, 0], nodes[v, 1]) >= 0.0:
                break
            count -= 1
        kept[count] = v
        count += 1
    return kept[:count]


def hull_of(nodes: NDArray[np.float64], among: NDArray[np.int32]) -> NDArray[np.int64]:
    """Go round the convex hull counter-clockwise, nodes within its edges included; exact."""
    among = np.unique(among)
    order = among[np.lexsort((nodes[among, 1], nodes[among, 0]))].astype(np.int64)
    below, above = _half_hull(nodes, order), _half_hull(nodes, order[::-1].copy())
    return np.concatenate((below[:-1], above[:-1]))


@kernel
def all_turn_left(nodes: NDArray[np.float64], triangles: NDArray[np.int32]) -> bool:
    """Ask exactly, as rounding may exceed the area of a thin triangle."""
    for t in range(len(triangles)):
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        ax, ay, bx, by = nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1]
        if orientation(ax, ay, bx, by, nodes[c, 0], nodes[c, 1]) <= 0.0:
            return False
    return True
