"""The range of coordinates in which the predicates are exact."""

import math

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError

_LARGEST = 250
"""Coordinates stay below 2**250: a product of four differences does not overflow."""
_SMALLEST = -240
"""Their last set bits stay at or above 2**-240: no product of four is rounded to zero."""


def safe_scale(*nodes: NDArray[np.float64]) -> float:
    """Power of two that brings all nodes into the range where predicates are exact.

    Parameters
    ----------
    *nodes : (n, 2) float64
        Finite coordinates of one or several grids.

    Returns
    -------
    float
        1.0 for all but extreme input; multiplication by it is exact.

    Raises
    ------
    InputError
        Where the coordinates span more powers of two than any scaling could bring in, or no
        power of two that is a float64 does.
    """
    largest = -math.inf
    smallest = math.inf
    for array in nodes:
        magnitude = np.abs(array[array != 0.0])
        if magnitude.size:
            largest = max(largest, math.frexp(float(magnitude.max()))[1])
            # the last bit of a double is at most 53 places behind its first
            smallest = min(smallest, math.frexp(float(magnitude.min()))[1] - 53)
    if largest <= _LARGEST and smallest >= _SMALLEST:
        return 1.0
    shift = _LARGEST - int(largest)
    if shift > 1023:
        raise InputError(f"coordinates below 2^{int(largest)} are too small to be compared exactly")
    if smallest + shift < _SMALLEST:
        raise InputError(
            "coordinates span too many magnitudes to be compared exactly: "
            f"2^{int(smallest) + 53} to 2^{int(largest)}"
        )
    return math.ldexp(1.0, shift)
