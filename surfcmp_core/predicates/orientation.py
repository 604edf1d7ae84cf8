"""On which side of a line a node lies."""

from surfcmp_core.kernel import kernel
from surfcmp_core.predicates.expansion import (
    difference,
    leading,
    multiply,
    subtract,
    two_product,
    two_sum,
)

_EPSILON = 2.0**-53
_FILTER = (3.0 + 16.0 * _EPSILON) * _EPSILON


@kernel
def _orientation_exact(ax: float, ay: float, bx: float, by: float, cx: float, cy: float) -> float:
    acx, acx_tail = two_sum(ax, -cx)
    acy, acy_tail = two_sum(ay, -cy)
    bcx, bcx_tail = two_sum(bx, -cx)
    bcy, bcy_tail = two_sum(by, -cy)
    if acx_tail == 0.0 and acy_tail == 0.0 and bcx_tail == 0.0 and bcy_tail == 0.0:
        # lattices and rounded coordinates end here: two products of two doubles are compared
        left, left_tail = two_product(acx, bcy)
        right, right_tail = two_product(acy, bcx)
        determinant = (left - right) + (left_tail - right_tail)
        if determinant != 0.0 or (left == right and left_tail == right_tail):
            return determinant
    product = multiply(difference(ax, cx), difference(by, cy))
    return leading(subtract(product, multiply(difference(ay, cy), difference(bx, cx))))


@kernel
def orientation(ax: float, ay: float, bx: float, by: float, cx: float, cy: float) -> float:
    """Twice the signed area of the triangle a, b, c, exact in sign.

    Parameters
    ----------
    ax, ay, bx, by, cx, cy : float
        Coordinates.

    Returns
    -------
    float
        Positive where a, b, c turn counter-clockwise, negative where clockwise, 0 where collinear.

    References
    ----------
    Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates,
    1997; the filter is his first stage.
    """
    left = (ax - cx) * (by - cy)
    right = (ay - cy) * (bx - cx)
    determinant = left - right
    if abs(determinant) > _FILTER * (abs(left) + abs(right)):
        return determinant
    return _orientation_exact(ax, ay, bx, by, cx, cy)
