"""The disc of a triangle or ghost: what a node must lie in to destroy it."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import inlined, kernel
from surfcmp_core.predicates import in_disc, orientation


@kernel
def _in_ghost_disc(ax: float, ay: float, bx: float, by: float, px: float, py: float) -> bool:
    """Whether p lies left of a→b or on the open edge between them."""
    side = orientation(ax, ay, bx, by, px, py)
    if side != 0.0:
        return side > 0.0
    if ax != bx:
        return min(ax, bx) < px < max(ax, bx)
    return min(ay, by) < py < max(ay, by)


@inlined
def disc_holds(
    nodes: NDArray[np.float64], start: NDArray[np.int32], corner: int, px: float, py: float
) -> bool:
    """Whether the disc of the triangle of a corner holds a node of the other grid.

    The disc of a ghost is the open half-plane outside its hull edge and the open edge itself.
    """
    first = corner - corner % 3
    a = start[first]
    b = start[first + 1]
    c = start[first + 2]
    if c < 0:
        return _in_ghost_disc(nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1], px, py)
    return in_disc(
        nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1], nodes[c, 0], nodes[c, 1], px, py
    )
