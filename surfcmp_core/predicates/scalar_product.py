"""Whether one edge leads along another or against it."""

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates.expansion import Expansion, add, multiply
from surfcmp_core.predicates.products import CLEAR, difference_of_products


@kernel
def exact_scalar_product(ax: Expansion, ay: Expansion, bx: Expansion, by: Expansion) -> Expansion:
    """Multiply two vectors, given by their exact components."""
    return add(multiply(ax, bx), multiply(ay, by))


@kernel
def scalar_product(
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float, dx: float, dy: float
) -> float:
    """Scalar product of ab and cd, exact in sign and right but for its last bits.

    Parameters
    ----------
    ax, ay, bx, by, cx, cy, dx, dy : float
        Ends of the two edges.

    Returns
    -------
    float
        Positive where they lead the same way, negative where against each other, 0 at right angles.
    """
    first = (bx - ax) * (dx - cx)
    second = (by - ay) * (dy - cy)
    if abs(first + second) >= CLEAR * (abs(first) + abs(second)):
        return first + second
    return difference_of_products(bx, ax, dx, cx, by, ay, cy, dy)
