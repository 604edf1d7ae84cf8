"""Convex polygons cut by triangles, and the values of linear functions on them."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import kernel

MOST_CORNERS = 32
"""Room for a triangle cut six times, even where rounding makes a cut polygon not quite convex."""


@kernel
def _cut(
    polygons: NDArray[np.float64],
    source: int,
    count: int,
    px: float,
    py: float,
    qx: float,
    qy: float,
    side: float,
    target: int,
) -> int:
    """Keep what lies left (side 1) or right (-1) of the line pq.

    Two triangles on the two sides of an edge pass it in the same direction, so that what one of
    them keeps is what the other drops, rounding included.
    """
    kept = 0
    x, y = polygons[source, count - 1, 0], polygons[source, count - 1, 1]
    at = side * ((qx - px) * (y - py) - (qy - py) * (x - px))
    for k in range(count):
        x_k, y_k = polygons[source, k, 0], polygons[source, k, 1]
        at_k = side * ((qx - px) * (y_k - py) - (qy - py) * (x_k - px))
        if (at > 0.0 and at_k < 0.0) or (at < 0.0 and at_k > 0.0):
            share = at / (at - at_k)
            polygons[target, kept, 0] = x + share * (x_k - x)
            polygons[target, kept, 1] = y + share * (y_k - y)
            kept += 1
        if at_k >= 0.0:
            polygons[target, kept, 0] = x_k
            polygons[target, kept, 1] = y_k
            kept += 1
        x, y, at = x_k, y_k, at_k
    return kept


@kernel
def cut_by_triangle(
    polygons: NDArray[np.float64],
    source: int,
    count: int,
    triangle: NDArray[np.float64],
    numbers: NDArray[np.int32],
    edges: int,
    spare: int,
    other_spare: int,
) -> tuple[int, int]:
    """Intersect a convex polygon with a triangle.

    Parameters
    ----------
    polygons : (k, MOST_CORNERS, 2) float64
        Polygons, counter-clockwise; two of the k are spare and get overwritten.
    source, count : int
        Which polygon, and its corners: at least 3.
    triangle : (3, 2) float64
        Counter-clockwise, in the same coordinates.
    numbers : (3,) int32
        Of its nodes, all different: they say in which direction an edge is passed.
    edges : int
        Bit k: its k-th edge may run through the polygon; others are left out.
    spare, other_spare : int
        The spare polygons.

    Returns
    -------
    result, corners : int
        Which polygon is the result, and its corners: less than 3 where it is empty.
    """
    for k in range(3):
        if edges >> k & 1 and count >= 3:
            p, q = k, (k + 1) % 3
            side = 1.0
            if numbers[p] > numbers[q]:
                p, q = q, p
                side = -1.0
            px, py, qx, qy = triangle[p, 0], triangle[p, 1], triangle[q, 0], triangle[q, 1]
            count = _cut(polygons, source, count, px, py, qx, qy, side, spare)
            source, spare, other_spare = spare, other_spare, spare
    return source, count


@kernel
def value_at(
    x: float, y: float, triangle: NDArray[np.float64], z: NDArray[np.float64]
) -> tuple[float, float]:
    """Value at a place in a triangle of the function that is linear on it.

    Returns
    -------
    base, rise : float
        Value at the first node, and what is to be added: kept apart so that the difference of two
        surfaces far from 0 keeps its digits. The value lies between the nodes' even where the
        triangle is so thin that rounding puts the place outside.
    """
    ax, ay = triangle[0, 0] - x, triangle[0, 1] - y
    bx, by = triangle[1, 0] - x, triangle[1, 1] - y
    cx, cy = triangle[2, 0] - x, triangle[2, 1] - y
    a = max(bx * cy - by * cx, 0.0)
    b = max(cx * ay - cy * ax, 0.0)
    c = max(ax * by - ay * bx, 0.0)
    whole = a + (b + c)
    if not whole > 0.0:
        return z[0], 0.0
    return z[0], (b * (z[1] - z[0]) + c * (z[2] - z[0])) / whole
