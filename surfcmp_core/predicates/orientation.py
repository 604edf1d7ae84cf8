"""On which side of a line a node lies, and how large a triangle is."""

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates.products import CLEAR, difference_of_products

_EPSILON = 2.0**-53
_FILTER = (3.0 + 16.0 * _EPSILON) * _EPSILON


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
    [Shewchuk1997]; the filter is his first stage.
    """
    left = (ax - cx) * (by - cy)
    right = (ay - cy) * (bx - cx)
    determinant = left - right
    if abs(determinant) > _FILTER * (abs(left) + abs(right)):
        return determinant
    return difference_of_products(ax, cx, by, cy, ay, cy, bx, cx)


@kernel
def twice_area(ax: float, ay: float, bx: float, by: float, cx: float, cy: float) -> float:
    """Twice the signed area of the triangle a, b, c, right but for its last bits.

    Parameters
    ----------
    ax, ay, bx, by, cx, cy : float
        Coordinates.

    Returns
    -------
    float
        With the sign of :func:`orientation`; off by less than 2⁻⁴⁷ of itself, however thin the
        triangle is.
    """
    left = (ax - cx) * (by - cy)
    right = (ay - cy) * (bx - cx)
    determinant = left - right
    if abs(determinant) >= CLEAR * (abs(left) + abs(right)):
        return determinant
    return difference_of_products(ax, cx, by, cy, ay, cy, bx, cx)
