"""Which of two circles that touch each other at a node is smaller."""

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates.expansion import difference, leading, multiply, subtract
from surfcmp_core.predicates.scalar_product import exact_scalar_product

CIRCLES_FILTER = 16.0 * 2.0**-53
"""Bound on the rounding error of the comparison, in units of its terms' magnitudes."""


@kernel
def _compare_exact(
    vx: float, vy: float, ux: float, uy: float, ax: float, ay: float, bx: float, by: float
) -> float:
    wx = difference(ux, vx)
    wy = difference(uy, vy)
    adx = difference(ax, vx)
    ady = difference(ay, vy)
    bdx = difference(bx, vx)
    bdy = difference(by, vy)
    first = multiply(
        exact_scalar_product(adx, ady, adx, ady), exact_scalar_product(bdx, bdy, wx, wy)
    )
    second = multiply(
        exact_scalar_product(bdx, bdy, bdx, bdy), exact_scalar_product(adx, ady, wx, wy)
    )
    return leading(subtract(first, second))


@kernel
def compare_tangent_circles(
    vx: float, vy: float, ux: float, uy: float, ax: float, ay: float, bx: float, by: float
) -> float:
    """Compare the circles through v centred on the ray v→u, one through a, one through b.

    Parameters
    ----------
    vx, vy : float
        The node both circles touch.
    ux, uy : float
        A place on the ray of their centres.
    ax, ay, bx, by : float
        Nodes strictly on the ray's side of the common tangent: (a - v)·(u - v) > 0.

    Returns
    -------
    float
        Negative where the circle through a is the smaller, positive where that through b is, 0
        where both are the same circle.

    Notes
    -----
    The radius through a is |a - v|² |u - v| / (2 (a - v)·(u - v)); comparing two of them
    is the sign of a polynomial of degree four in the coordinates.
    """
    wx = ux - vx
    wy = uy - vy
    adx = ax - vx
    ady = ay - vy
    bdx = bx - vx
    bdy = by - vy
    a_square = adx * adx + ady * ady
    b_square = bdx * bdx + bdy * bdy
    first = a_square * (bdx * wx + bdy * wy)
    second = b_square * (adx * wx + ady * wy)
    bound = a_square * (abs(bdx * wx) + abs(bdy * wy)) + b_square * (abs(adx * wx) + abs(ady * wy))
    if abs(first - second) > CIRCLES_FILTER * bound:
        return first - second
    return _compare_exact(vx, vy, ux, uy, ax, ay, bx, by)
