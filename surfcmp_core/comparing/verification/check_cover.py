"""Whether T covers the convex hull of both grids once: in one pass over its triangles."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparing.verification.holds import hold
from surfcmp_core.measures.chunks import over_chunks
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.united import United
from surfcmp_core.united.cover import all_turn_left, area_of_polygon, areas_anywhere, hull_of


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
    hull = hull_of(united.nodes, np.concatenate(on_hulls))
    hold(
        len(triangles) == 2 * count - 2 - len(hull),
        f"T has {len(triangles)} triangles, by Euler's formula {2 * count - 2 - len(hull)}",
    )
    used = np.zeros(count, np.bool_)
    parts = over_chunks(
        lambda begin, end: int(areas_anywhere(begin, end, triangles, used)),
        len(triangles),
        threads,
    )
    hold(used.all(), f"{count - int(used.sum())} nodes are in no triangle of T")
    hold(
        (sum(parts) - int(area_of_polygon(hull))) % 2**64 == 0,
        "the triangles of T do not cover the convex hull once",
    )
    hold(
        areas.min() > 0.0 or all_turn_left(united.nodes, triangles),
        "a triangle of T is turned over",
    )
