"""Whether a node lies in the circumcircle of three others."""

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates.expansion import add, difference, leading, multiply, subtract
from surfcmp_core.predicates.orientation import orientation

_EPSILON = 2.0**-53
_FILTER = (10.0 + 96.0 * _EPSILON) * _EPSILON

LENGTHS_FILTER = 1.001 * _FILTER
"""The same bound on the rounding error of an in-circle determinant, for a permanent that is itself
bounded: by |u × v| ≤ |u| |v| and the inequality of the means, the permanent of three squared
lengths k, l, m is at most k l + l m + m k."""


@kernel
def _in_circle_exact(
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float, px: float, py: float
) -> float:
    adx = difference(ax, px)
    ady = difference(ay, py)
    bdx = difference(bx, px)
    bdy = difference(by, py)
    cdx = difference(cx, px)
    cdy = difference(cy, py)
    a_lift = add(multiply(adx, adx), multiply(ady, ady))
    b_lift = add(multiply(bdx, bdx), multiply(bdy, bdy))
    c_lift = add(multiply(cdx, cdx), multiply(cdy, cdy))
    bc = subtract(multiply(bdx, cdy), multiply(cdx, bdy))
    ca = subtract(multiply(cdx, ady), multiply(adx, cdy))
    ab = subtract(multiply(adx, bdy), multiply(bdx, ady))
    return leading(add(add(multiply(bc, a_lift), multiply(ca, b_lift)), multiply(ab, c_lift)))


@kernel
def in_circle(
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float, px: float, py: float
) -> float:
    """Place of p relative to the circle through a, b, c, exact in sign.

    Parameters
    ----------
    ax, ay, bx, by, cx, cy : float
        Counter-clockwise triangle.
    px, py : float
        The node asked about.

    Returns
    -------
    float
        Positive where p is strictly inside, negative where outside, 0 on the circle.

    References
    ----------
    [Shewchuk1997]; the filter is his first stage.
    """
    adx = ax - px
    ady = ay - py
    bdx = bx - px
    bdy = by - py
    cdx = cx - px
    cdy = cy - py
    bdxcdy = bdx * cdy
    cdxbdy = cdx * bdy
    a_lift = adx * adx + ady * ady
    cdxady = cdx * ady
    adxcdy = adx * cdy
    b_lift = bdx * bdx + bdy * bdy
    adxbdy = adx * bdy
    bdxady = bdx * ady
    c_lift = cdx * cdx + cdy * cdy
    determinant = (
        a_lift * (bdxcdy - cdxbdy) + b_lift * (cdxady - adxcdy) + c_lift * (adxbdy - bdxady)
    )
    permanent = (
        (abs(bdxcdy) + abs(cdxbdy)) * a_lift
        + (abs(cdxady) + abs(adxcdy)) * b_lift
        + (abs(adxbdy) + abs(bdxady)) * c_lift
    )
    if abs(determinant) > _FILTER * permanent:
        return determinant
    return _in_circle_exact(ax, ay, bx, by, cx, cy, px, py)


@kernel
def _in_disc_of_tie(
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float, px: float, py: float
) -> bool:
    # The four nodes are lifted by infinitesimals, the lexicographically last one by far the most.
    # Its coefficient in the in-circle determinant is minus or plus the orientation of the other
    # three; where that is 0 the next node decides.
    xs = (ax, bx, cx, px)
    ys = (ay, by, cy, py)
    limit = -1
    for _ in range(3):
        last = -1
        for k in range(4):
            below = limit < 0 or xs[k] < xs[limit] or (xs[k] == xs[limit] and ys[k] < ys[limit])
            if below and (last < 0 or xs[k] > xs[last] or (xs[k] == xs[last] and ys[k] > ys[last])):
                last = k
        if last == 3:
            return False
        if last == 2:
            side = orientation(ax, ay, bx, by, px, py)
        elif last == 1:
            side = orientation(ax, ay, px, py, cx, cy)
        else:
            side = orientation(px, py, bx, by, cx, cy)
        if side != 0.0:
            return side > 0.0
        limit = last
    return False


@kernel
def in_disc(
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float, px: float, py: float
) -> bool:
    """Whether p lies in the disc of the triangle a, b, c, cocircular ties broken symbolically.

    The tie-break is a perturbation of the lifting map in lexicographic order: it depends on the
    coordinates alone and is the same under translation and scaling.

    Parameters
    ----------
    ax, ay, bx, by, cx, cy : float
        Counter-clockwise triangle.
    px, py : float
        A node different from all three.

    Returns
    -------
    bool

    References
    ----------
    [DevillersTeillaud2011].
    """
    side = in_circle(ax, ay, bx, by, cx, cy, px, py)
    if side != 0.0:
        return side > 0.0
    return _in_disc_of_tie(ax, ay, bx, by, cx, cy, px, py)
