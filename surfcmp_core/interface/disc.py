"""The disc of a triangle or ghost: what a node must lie in to destroy it."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates import in_disc, orientation


@kernel
def disc_holds(nodes: NDArray[np.float64], words: NDArray[np.int32], h: int, node: int) -> bool:
    """Whether the disc of the triangle of a corner holds a node of the other grid.

    The disc of a ghost is the open half-plane outside its hull edge and the open edge itself.
    """
    first = h & -8
    px, py = nodes[node, 0], nodes[node, 1]
    a, b, c = words[first], words[first + 1], words[first + 2]
    ax, ay = nodes[a, 0], nodes[a, 1]
    bx, by = nodes[b, 0], nodes[b, 1]
    if c >= 0:
        return in_disc(ax, ay, bx, by, nodes[c, 0], nodes[c, 1], px, py)
    side = orientation(ax, ay, bx, by, px, py)
    if side != 0.0:
        return side > 0.0
    if ax != bx:
        return bool(min(ax, bx) < px < max(ax, bx))
    return bool(min(ay, by) < py < max(ay, by))
