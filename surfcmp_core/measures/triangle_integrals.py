"""Closed forms over one triangle on which the difference d is linear.

Every value here is a mean over the triangle T: times its area it is the integral. Of products of
barycentric coordinates it is [EisenbergMalvern1973]

    1/|T| ∫ λ₁^i λ₂^j λ₃^k dA = 2 i! j! k! / (i + j + k + 2)!

A triangle where d changes sign is split along d = 0 into a small triangle at the node that stands
alone with its sign and a quadrangle; each is summed from terms of one sign, so nothing cancels. All
results depend neither on which node comes first nor, but for the sign of `mean`, on the sign of d,
bit for bit.
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
    """1/|T| ∫ d dA = (lo + mid + hi) / 3; exactly c where d = c."""
    return mid + ((lo - mid) + (hi - mid)) / 3.0


@kernel
def _parts(lonely: float, m: float, h: float) -> tuple[float, float]:
    """Integrals of |d| over |T| on the side of the lonely node and on the other.

    With ℓ, m ≤ h for |d| at the nodes, d = 0 at the shares u = ℓ / (ℓ + m), v = ℓ / (ℓ + h) of the
    edges from the lonely one, and the integrals are

        u v ℓ / 3   and   ((1 − v) (m + h) + v (1 − u) m) / 3
    """
    v = lonely / (lonely + h)
    alone = lonely * (lonely / (lonely + m)) * v
    rest = (h / (lonely + h)) * (m + h) + v * (m / (lonely + m)) * m
    return alone / 3.0, rest / 3.0


@kernel
def mean_parts(lo: float, mid: float, hi: float) -> tuple[float, float]:
    """1/|T| ∫ max(d, 0) dA and 1/|T| ∫ max(−d, 0) dA (see `_parts`).

    Parameters
    ----------
    lo, mid, hi : float
        d at the nodes, sorted.

    Returns
    -------
    above, below : float
        Their sum is the mean of |d|.
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
    """1/|T| ∫ d² dA = m² + ((lo − m)² + (mid − m)² + (hi − m)²) / 12 with m the mean of d.

    Exactly c² where d = c.
    """
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
    F(s), the share over which d < s, has as its slope a linear B-spline [CurrySchoenberg1966]:

        F′(s) = 2 (s − lo) / ((hi − lo) (mid − lo))    lo ≤ s ≤ mid
        F′(s) = 2 (hi − s) / ((hi − lo) (hi − mid))    mid ≤ s ≤ hi

    and the result is F(tolerance) − F(−tolerance).
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
    """1/|T| ∫ |d| µ dA where µ is linear too.

    Parameters
    ----------
    a, b, c : float
        d at the nodes, in any order.
    p, q, r : float
        µ at the same nodes.

    Notes
    -----
    Where d has one sign,

        |a p + b q + c r + (a + b + c) (p + q + r)| / 12

    Else, with ℓ, m, h, u, v as in `_parts`, a the lonely one, and µ = µᵤ = (1 − u) p + u q and
    µ = µᵥ = (1 − v) p + v r where d = 0,

        ( u v ℓ (2 p + µᵤ + µᵥ)
          + (1 − v) (m q + h r + (m + h) (q + r + µᵥ))
          + v (1 − u) m (2 q + µᵤ + µᵥ) ) / 12
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
