"""A space-filling curve: neighbours in the plane become neighbours in memory."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel

_BITS = 29
"""Bits an axis; with 16 a small dense cluster falls into one cell and loses all order."""


_STEPS = (_BITS + 1) // 2
"""Two bits of either axis are looked up at once."""


def _table() -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Tabulate two levels of the curve for each of its four ways through a square.

    Returns
    -------
    digits, onward : (64,) int64
        At 16 way + 4 (two bits of x) + (two bits of y): four bits of the key, and the way through
        the small square. Bit 0 of a way exchanges x and y, bit 1 turns both round.
    """
    digits = np.empty(64, np.int64)
    onward = np.empty(64, np.int64)
    for place in range(64):
        way, digit = place >> 4, 0
        for level in (1, 0):
            right, upper = (place >> (2 + level)) & 1, (place >> level) & 1
            if way & 2:
                right, upper = 1 - right, 1 - upper
            if way & 1:
                right, upper = upper, right
            digit = 4 * digit + ((3 * right) ^ upper)
            if not upper:  # turn the square so that the curve goes on without a jump
                way ^= 3 if right else 1
        digits[place] = digit
        onward[place] = way
    return digits, onward


_DIGITS, _ONWARD = _table()


@kernel
def _hilbert_keys(
    nodes: NDArray[np.float64], x0: float, y0: float, per_cell: float, keys: NDArray[np.uint64]
) -> None:
    for i in range(nodes.shape[0]):
        x = int((nodes[i, 0] - x0) * per_cell)
        y = int((nodes[i, 1] - y0) * per_cell)
        key = 0
        way = 0
        for shift in range(2 * _STEPS - 2, -1, -2):
            place = 16 * way + 4 * ((x >> shift) & 3) + ((y >> shift) & 3)
            key = (key << 4) | _DIGITS[place]
            way = _ONWARD[place]
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
