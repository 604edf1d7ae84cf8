"""On which side of a line a node lies."""

from surfcmp_core.kernel import kernel
from surfcmp_core.predicates.expansion import difference, leading, multiply, subtract

_EPSILON = 2.0**-53
_FILTER = (3.0 + 16.0 * _EPSILON) * _EPSILON


@kernel
def _orientation_exact(ax: float, ay: float, bx: float, by: float, cx: float, cy: float) -> float:
    left = multiply(difference(ax, cx), difference(by, cy))
    right = multiply(difference(ay, cy), difference(bx, cx))
    return leading(subtract(left, right))


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
