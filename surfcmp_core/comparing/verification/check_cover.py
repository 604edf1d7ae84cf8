"""Whether T covers the convex hull of both grids once: in one pass over its triangles."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparing.verification.holds import hold
from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.measures.chunks import over_chunks
from surfcmp_core.predicates import orientation
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.united import United


@kernel
def _any_place(node: int) -> tuple[int, int]:
    """Give a node a place of whole numbers modulo 2**64 that has nothing to do with its own."""
    key = np.uint64(node + 1) * np.uint64(0x9E3779B97F4A7C15)
    key ^= key >> np.uint64(29)
    x = key * np.uint64(0xBF58476D1CE4E5B9)
    y = (key ^ (x >> np.uint64(32))) * np.uint64(0x94D049BB133111EB)
    return x, y  # type: ignore[return-value]


@kernel
def _areas_anywhere(
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
def _area_of_polygon(polygon: NDArray[np.int64]) -> int:
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


def _hull(nodes: NDArray[np.float64], among: NDArray[np.int32]) -> NDArray[np.int64]:
    """Go round the convex hull counter-clockwise, nodes within its edges included; exact."""
    among = np.unique(among)
    order = among[np.lexsort((nodes[among, 1], nodes[among, 0]))].astype(np.int64)
    below, above = _half_hull(nodes, order), _half_hull(nodes, order[::-1].copy())
    return np.concatenate((below[:-1], above[:-1]))


def check_cover(
    united: United,
    first: Triangulation,
    second: Triangulation,
    areas: NDArray[np.float64],
    threads: int = 1,
) -> None:
    """Check that T has all nodes, satisfies Euler's formula and covers the convex hull once.

    Signed areas of triangles add up to that of the polygon around them wherever their nodes lie,
    if and only if every inner edge has a triangle on either side and the others are that polygon.
    So nodes are given places that have nothing to do with their own, in whole numbers modulo 2**64,
    where nothing is rounded: a missing, doubled or crossing triangle shows, but for one case in
    thousands of millions. As none is turned over, the true areas add up to the hull's too.

    Parameters
    ----------
    united : United
        T, N nodes and M triangles.
    first, second : Triangulation
        T1 and T2; their coordinates and T's are those on which predicates are exact.
    areas : (M,) float64
        Of the triangles of T, in any unit.
    threads : int
        How many may work at once.

    Raises
    ------
    Violation
    """
    count, triangles = len(united.nodes), united.triangles
    on_hulls = [
        own[t.start[3 * t.real :: 3]]
        for own, t in ((united.node_1, first), (united.node_2, second))
    ]
    hull = _hull(united.nodes, np.concatenate(on_hulls))
    hold(
        len(triangles) == 2 * count - 2 - len(hull),
        f"T has {len(triangles)} triangles, by Euler's formula {2 * count - 2 - len(hull)}",
    )
    used = np.zeros(count, np.bool_)
    parts = over_chunks(
        lambda begin, end: int(_areas_anywhere(begin, end, triangles, used)),
        len(triangles),
        threads,
    )
    hold(used.all(), f"{count - int(used.sum())} nodes are in no triangle of T")
    hold(
        (sum(parts) - int(_area_of_polygon(hull))) % 2**64 == 0,
        "the triangles of T do not cover the convex hull once",
    )
    hold(
        areas.min() > 0.0 or _all_turn_left(united.nodes, triangles),
        "a triangle of T is turned over",
    )


@kernel
def _all_turn_left(nodes: NDArray[np.float64], triangles: NDArray[np.int32]) -> bool:
    """Ask exactly, as rounding may exceed the area of a thin triangle."""
    for t in range(len(triangles)):
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        ax, ay, bx, by = nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1]
        if orientation(ax, ay, bx, by, nodes[c, 0], nodes[c, 1]) <= 0.0:
            return False
    return True
