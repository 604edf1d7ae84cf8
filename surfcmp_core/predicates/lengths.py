"""Which of two edges is longer."""

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates.expansion import (
    Expansion,
    add,
    difference,
    leading,
    multiply,
    subtract,
)

_FILTER = 8.0 * 2.0**-53


@kernel
def _square_exact(ax: float, ay: float, bx: float, by: float) -> Expansion:
    dx = difference(ax, bx)
    dy = difference(ay, by)
    return add(multiply(dx, dx), multiply(dy, dy))


@kernel
def _compare_lengths_exact(
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float, dx: float, dy: float
) -> float:
    return leading(subtract(_square_exact(ax, ay, bx, by), _square_exact(cx, cy, dx, dy)))


@kernel
def compare_lengths(
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float, dx: float, dy: float
) -> float:
    """Square of ab minus square of cd, exact in sign.

    Parameters
    ----------
    ax, ay, bx, by, cx, cy, dx, dy : float
        Ends of the two edges.

    Returns
    -------
    float
        Positive where ab is longer, negative where cd is, 0 where they are equal.
    """
    first = (ax - bx) * (ax - bx) + (ay - by) * (ay - by)
    second = (cx - dx) * (cx - dx) + (cy - dy) * (cy - dy)
    if abs(first - second) > _FILTER * (first + second):
        return first - second
    return _compare_lengths_exact(ax, ay, bx, by, cx, cy, dx, dy)
