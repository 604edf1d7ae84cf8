"""Two products of differences, one minus the other: what areas and scalar products come down to."""

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates.expansion import (
    difference,
    multiply,
    rounded,
    subtract,
    two_product,
    two_sum,
)

CLEAR = 2.0**-4
"""Share of the two products above which their plain difference is right but for its last bits."""
_TAILS_DO = 2.0**-50
"""Share of them above which all terms of first order do: what they leave out is below 9 · 2⁻¹⁰⁶ of
the products (the third stage of the orientation of [Shewchuk1997])."""


@kernel
def difference_of_products(
    p0: float, p1: float, q0: float, q1: float, r0: float, r1: float, s0: float, s1: float
) -> float:
    """(p0 − p1) (q0 − q1) − (r0 − r1) (s0 − s1), right but for its last bits.

    Parameters
    ----------
    p0, p1, q0, q1, r0, r1, s0, s1 : float
        Coordinates.

    Returns
    -------
    float
        Exact in sign, off by less than 2⁻⁴⁷ of itself however much of the products cancels.

    References
    ----------
    [Shewchuk1997].
    """
    p, p_tail = two_sum(p0, -p1)
    q, q_tail = two_sum(q0, -q1)
    r, r_tail = two_sum(r0, -r1)
    s, s_tail = two_sum(s0, -s1)
    left, left_tail = two_product(p, q)
    right, right_tail = two_product(r, s)
    tails = left_tail - right_tail
    if p_tail == 0.0 and q_tail == 0.0 and r_tail == 0.0 and s_tail == 0.0:
        # lattices and rounded coordinates end here: two products of two doubles are compared
        if left == right and left_tail == right_tail:
            return 0.0
    else:
        tails += (p * q_tail + q * p_tail) - (r * s_tail + s * r_tail)
    result = (left - right) + tails
    if abs(result) > _TAILS_DO * (abs(left) + abs(right)):
        return result
    exact_left = multiply(difference(p0, p1), difference(q0, q1))
    exact_right = multiply(difference(r0, r1), difference(s0, s1))
    return rounded(subtract(exact_left, exact_right))
