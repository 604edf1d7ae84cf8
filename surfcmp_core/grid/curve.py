"""A space-filling curve: neighbours in the plane become neighbours in memory."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import kernel

_BITS = 29
"""Bits an axis; with 16 a small dense cluster falls into one cell and loses all order."""


@kernel
def _hilbert_keys(
    nodes: NDArray[np.float64], x0: float, y0: float, per_cell: float, keys: NDArray[np.uint64]
) -> None:
    top = 1 << (_BITS - 1)
    for i in range(nodes.shape[0]):
        x = int((nodes[i, 0] - x0) * per_cell)
        y = int((nodes[i, 1] - y0) * per_cell)
        key = 0
        side = top
        while side > 0:
            right = 1 if x & side else 0
            upper = 1 if y & side else 0
            key = (key << 2) | ((3 * right) ^ upper)
            if upper == 0:  # turn the quadrant so that the curve goes on without a jump
                if right == 1:
                    x = ~x
                    y = ~y
                x, y = y, x
            side >>= 1
        keys[i] = key


def curve_keys(
    nodes: NDArray[np.float64], box: tuple[float, float, float, float]
) -> NDArray[np.uint64]:
    """Place of each node along a Hilbert curve through a box.

    Parameters
    ----------
    nodes : (n, 2) float64
    box : tuple of float
        Smallest x and y, largest x and y; holds all nodes.

    Returns
    -------
    (n,) uint64

    References
    ----------
    Hilbert 1891; `_BITS` bits an axis.
    """
    x0, y0, x1, y1 = box
    extent = max(x1 - x0, y1 - y0)
    per_cell = (2.0**_BITS - 1.0) / extent if extent > 0.0 else 0.0
    keys = np.empty(len(nodes), np.uint64)
    _hilbert_keys(nodes, x0, y0, per_cell, keys)
    return keys
