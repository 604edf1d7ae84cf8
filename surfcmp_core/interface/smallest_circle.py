"""Choice of the node that gives the smallest circle touching at v: the paper's step (d)."""

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates import compare_tangent_circles, orientation, scalar_product


@kernel
def _is_outer(
    vx: float, vy: float, ux: float, uy: float, ax: float, ay: float, bx: float, by: float
) -> bool:
    """Whether b, on one circle with a, is farther out on the same side of the ray v→u."""
    side_a = orientation(vx, vy, ux, uy, ax, ay)
    side_b = orientation(vx, vy, ux, uy, bx, by)
    if side_a == 0.0:
        return side_b != 0.0
    if side_b == 0.0 or (side_a > 0.0) != (side_b > 0.0):
        return False
    turn = orientation(vx, vy, ax, ay, bx, by)
    return turn > 0.0 if side_a > 0.0 else turn < 0.0


@kernel
def is_better(
    vx: float, vy: float, ux: float, uy: float, ax: float, ay: float, bx: float, by: float
) -> bool:
    """Whether b gives a smaller circle through v, centred on the ray v→u, than a does.

    Of nodes on one circle the outermost on one side of the ray is wanted: only neighbours along
    an empty circle are sure to be joined by an edge.
    """
    order = compare_tangent_circles(vx, vy, ux, uy, ax, ay, bx, by)
    if order != 0.0:
        return order > 0.0
    return _is_outer(vx, vy, ux, uy, ax, ay, bx, by)


@kernel
def leads_on(
    vx: float, vy: float, ux: float, uy: float, ax: float, ay: float, bx: float, by: float
) -> bool:
    """Whether b is better than a; where a lies behind v, seen along v→u: whether b is farther."""
    if scalar_product(vx, vy, ax, ay, vx, vy, ux, uy) > 0.0:
        return is_better(vx, vy, ux, uy, ax, ay, bx, by)
    return scalar_product(ax, ay, bx, by, vx, vy, ux, uy) > 0.0
