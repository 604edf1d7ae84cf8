"""A triangle of T cut along edges of T1 and T2, in shares of that triangle.

A corner of a polygon is held by its shares of the three nodes of the triangle of T (barycentric
coordinates, shape 3, at least 0, sum 1), and a line by the areas that its two nodes span with each
of the three. Those areas are right but for their last bits, however thin a triangle is, so a
polygon's share of the triangle is right even where the coordinates of its corners run together.
"""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel

MOST_CORNERS = 32
"""Room for a triangle cut six times, even where rounding makes a cut polygon not quite convex."""


@kernel
def _cut(
    polygons: NDArray[np.float64],
    source: int,
    count: int,
    at_a: float,
    at_b: float,
    at_c: float,
    target: int,
) -> int:
    """Keep where a linear function, given at the nodes of the triangle, is at least 0.

    Two triangles on the two sides of an edge pass the same numbers with opposite signs, so that
    what one of them keeps is what the other drops, rounding included.
    """
    kept = 0
    a, b, c = (
        polygons[source, count - 1, 0],
        polygons[source, count - 1, 1],
        polygons[source, count - 1, 2],
    )
    at = a * at_a + (b * at_b + c * at_c)
    for k in range(count):
        a_k, b_k, c_k = polygons[source, k, 0], polygons[source, k, 1], polygons[source, k, 2]
        at_k = a_k * at_a + (b_k * at_b + c_k * at_c)
        if (at > 0.0 and at_k < 0.0) or (at < 0.0 and at_k > 0.0):
            share = at / (at - at_k)
            polygons[target, kept, 0] = a + share * (a_k - a)
            polygons[target, kept, 1] = b + share * (b_k - b)
            polygons[target, kept, 2] = c + share * (c_k - c)
            kept += 1
        if at_k >= 0.0:
            polygons[target, kept, 0] = a_k
            polygons[target, kept, 1] = b_k
            polygons[target, kept, 2] = c_k
            kept += 1
        a, b, c, at = a_k, b_k, c_k, at_k
    return kept


@kernel
def cut_by_triangle(
    polygons: NDArray[np.float64],
    source: int,
    count: int,
    lines: NDArray[np.float64],
    which: int,
    edges: int,
    spare: int,
    other_spare: int,
) -> tuple[int, int]:
    """Intersect a convex polygon with a triangle.

    Parameters
    ----------
    polygons : (k, MOST_CORNERS, 3) float64
        Polygons, counter-clockwise, in shares; two of the k are spare and get overwritten.
    source, count : int
        Which polygon, and its corners: at least 3.
    lines : (k, 3, 3) float64
        In its row `which`, of each edge of the cutting triangle the area it spans with each node of
        the triangle of T, positive on the inside.
    edges : int
        Bit k: the k-th edge may run through the polygon; others are left out.
    spare, other_spare : int
        The spare polygons.

    Returns
    -------
    result, corners : int
        Which polygon is the result, and its corners: less than 3 where it is empty.
    """
    for k in range(3):
        if edges >> k & 1 and count >= 3:
            count = _cut(
                polygons,
                source,
                count,
                lines[which, k, 0],
                lines[which, k, 1],
                lines[which, k, 2],
                spare,
            )
            source, spare, other_spare = spare, other_spare, spare
    return source, count


@kernel
def small_shares(polygons: NDArray[np.float64], which: int, count: int) -> tuple[int, int]:
    """Choose the two nodes whose shares to take areas from, in order.

    They are small where the polygon is, and keep their digits: the third node is the one that all
    corners are nearest to.
    """
    best = 0
    largest = -1.0
    for node in range(3):
        least = polygons[which, 0, node]
        for k in range(1, count):
            least = min(least, polygons[which, k, node])
        if least > largest:
            best = node
            largest = least
    if best == 0:
        return 1, 2
    if best == 1:
        return 2, 0
    return 0, 1


@kernel
def fan_share(polygons: NDArray[np.float64], which: int, k: int, i: int, j: int) -> float:
    """Share of the triangle of T that the corners 0, k - 1 and k of a polygon span.

    Parameters
    ----------
    polygons, which
        The polygon.
    k : int
        From 2 on.
    i, j : int
        The nodes that `small_shares` chose.
    """
    pi, pj = polygons[which, 0, i], polygons[which, 0, j]
    ui, uj = polygons[which, k - 1, i] - pi, polygons[which, k - 1, j] - pj
    vi, vj = polygons[which, k, i] - pi, polygons[which, k, j] - pj
    return float(ui * vj - vi * uj)
