"""Closed forms over one triangle on which the difference d is linear.

Every value here is a mean over the triangle: times its area it is the integral. A triangle where d
changes sign is split along d = 0 into a small triangle at the node that stands alone with its sign
and a quadrangle; each is summed from terms of one sign, so nothing cancels. All results depend
neither on which node comes first nor, but for the sign of `mean`, on the sign of d, bit for bit.
"""

from surfcmp_core.compiled.kernel import kernel


@kernel
def ordered(a: float, b: float, c: float) -> tuple[float, float, float]:
    """Sort three nodal values.

    Parameters
    ----------
    a, b, c : float
        d at the three nodes, in any order.

    Returns
    -------
    lo, mid, hi : float
        As the other functions here want them.
    """
    return min(min(a, b), c), max(min(a, b), min(max(a, b), c)), max(max(a, b), c)


@kernel
def mean(lo: float, mid: float, hi: float) -> float:
    """Mean of d; exactly c where d = c."""
    return mid + ((lo - mid) + (hi - mid)) / 3.0


@kernel
def _parts(lonely: float, m: float, h: float) -> tuple[float, float]:
    """Means of |d| on the lonely node's side and on the other, from |d| at the nodes, m ≤ h."""
    v = lonely / (lonely + h)
    alone = lonely * (lonely / (lonely + m)) * v
    rest = (h / (lonely + h)) * (m + h) + v * (m / (lonely + m)) * m
    return alone / 3.0, rest / 3.0


@kernel
def mean_parts(lo: float, mid: float, hi: float) -> tuple[float, float]:
    """Means of the positive and of the negative part of d, both as numbers ≥ 0.

    Parameters
    ----------
    lo, mid, hi : float
        d at the nodes, sorted.

    Returns
    -------
    above, below : float
        Means of max(d, 0) and of max(−d, 0); their sum is the mean of |d|.
    """
    if lo >= 0.0:
        return mean(lo, mid, hi), 0.0
    if hi <= 0.0:
        return 0.0, mean(-hi, -mid, -lo)
    if mid >= 0.0:
        below, above = _parts(-lo, mid, hi)
    else:
        above, below = _parts(hi, -mid, -lo)
    return above, below


@kernel
def mean_square(lo: float, mid: float, hi: float) -> float:
    """Mean of d²: the square of the mean and the spread about it; exactly c² where d = c."""
    m = mean(lo, mid, hi)
    low = lo - m
    middle = mid - m
    high = hi - m
    return m * m + (middle * middle + (low * low + high * high)) / 12.0


@kernel
def share_within(lo: float, mid: float, hi: float, tolerance: float) -> float:
    """Share of the triangle's area with |d| ≤ tolerance.

    Parameters
    ----------
    lo, mid, hi : float
        d at the nodes, sorted.
    tolerance : float
        At least 0.

    Returns
    -------
    float
        In [0, 1]; 1 where all of the triangle is within, the border included.

    Notes
    -----
    The area over which d < s grows with a slope that rises linearly from lo to mid and falls
    linearly from mid to hi; the share is the area under these two lines within ±tolerance.
    """
    if -lo <= tolerance and hi <= tolerance:
        return 1.0
    if lo > tolerance or hi < -tolerance:
        return 0.0
    low = max(lo, -tolerance)
    high = min(hi, tolerance)
    rising = 0.0
    falling = 0.0
    top = min(high, mid)
    if top > low:
        rising = (top - low) / (hi - lo) * (((low - lo) + (top - lo)) / (mid - lo))
    bottom = max(low, mid)
    if high > bottom:
        falling = (high - bottom) / (hi - lo) * (((hi - high) + (hi - bottom)) / (hi - mid))
    return min(rising + falling, 1.0)


@kernel
def _sum(a: float, b: float, c: float) -> float:
    lo, mid, hi = ordered(a, b, c)
    return mid + (lo + hi)


@kernel
def _precedes(a: float, p: float, b: float, q: float) -> bool:
    return abs(a) < abs(b) or (abs(a) == abs(b) and p < q)


@kernel
def mean_abs_weighted(a: float, b: float, c: float, p: float, q: float, r: float) -> float:
    """Mean of |d| µ where µ is linear too.

    Parameters
    ----------
    a, b, c : float
        d at the nodes, in any order.
    p, q, r : float
        µ at the same nodes.
    """
    if (a >= 0.0 and b >= 0.0 and c >= 0.0) or (a <= 0.0 and b <= 0.0 and c <= 0.0):
        return abs(_sum(a * p, b * q, c * r) + _sum(a, b, c) * _sum(p, q, r)) / 12.0
    if a > b:
        a, p, b, q = b, q, a, p
    if b > c:
        b, q, c, r = c, r, b, q
        if a > b:
            a, p, b, q = b, q, a, p
    # Bring the node that stands alone to a; either end where the middle one is 0.
    if b < 0.0 or (b == 0.0 and _precedes(a, p, c, r)):
        a, p, c, r = c, r, a, p
    if _precedes(c, r, b, q):
        b, q, c, r = c, r, b, q
    lonely = abs(a)
    m = abs(b)
    h = abs(c)
    u = lonely / (lonely + m)
    v = lonely / (lonely + h)
    beside_u = m / (lonely + m)
    beside_v = h / (lonely + h)
    at_u = beside_u * p + u * q  # µ where d = 0 on the two edges from a
    at_v = beside_v * p + v * r
    alone = u * v * lonely * (2.0 * p + (at_u + at_v))
    far = beside_v * ((m * q + h * r) + (m + h) * ((q + r) + at_v))
    near = v * beside_u * m * (2.0 * q + (at_u + at_v))
    return (alone + (far + near)) / 12.0
