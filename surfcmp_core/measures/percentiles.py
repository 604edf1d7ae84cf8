"""Area-weighted percentiles, exact and independent of the order of the triangles.

The p-th percentile is the smallest of the triangles' values v such that the triangles with values
≤ v cover at least p per cent of the area. Areas are added and compared as integers, in units small
enough to keep all 53 bits of any area above 2⁻²⁵ of the largest, so that no rounding decides a tie
as between the equal triangles of a lattice.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel

_BIN_BITS = 14  # Bits by which values are told apart in one round: the bins stay in the cache.


class _Binned(NamedTuple):
    """Areas up to and including each bin; bin i holds the keys k with (k - first) >> shift = i.

    An area is high 2^bits + low, low below 2^bits.
    """

    first: int
    shift: int
    bits: int
    high: NDArray[np.int64]
    low: NDArray[np.int64]

    def area(self, i: int) -> int:
        """Area up to and including bin i."""
        return (int(self.high[i]) << self.bits) + int(self.low[i])

    def reaching(self, area: int) -> int:
        """First bin with which at least so much area is reached."""
        high, low = area >> self.bits, area & ((1 << self.bits) - 1)
        begin, end = (int(np.searchsorted(self.high, high, side)) for side in ("left", "right"))
        return begin + int(np.searchsorted(self.low[begin:end], low))


@kernel
def _fill_bins(
    keys: NDArray[np.int64],
    areas: NDArray[np.float64],
    unit: float,
    digit: float,
    first: int,
    shift: int,
    bins: NDArray[np.int64],
) -> None:
    """Add each area, as two digits of the given size, to the bin of its key."""
    for t in range(len(keys)):
        i = (keys[t] - first) >> shift
        scaled = areas[t] * unit * digit
        high = np.int64(scaled)
        bins[i, 0] += high
        bins[i, 1] += np.int64((scaled - high) * digit)


def _bin(keys: NDArray[np.int64], areas: NDArray[np.float64], unit: float, bits: int) -> _Binned:
    first = int(keys.min())
    reach = int(keys.max()) - first
    shift = max(0, reach.bit_length() - _BIN_BITS)
    bins = np.zeros(((reach >> shift) + 1, 2), dtype=np.int64)
    _fill_bins(keys, areas, unit, math.ldexp(1.0, bits), first, shift, bins)
    high, low = bins.cumsum(axis=0).T
    return _Binned(first, shift, bits, high + (low >> bits), low & ((1 << bits) - 1))


def area_percentiles(
    values: NDArray[np.float64], areas: NDArray[np.float64], percents: Sequence[int]
) -> list[float]:
    """Find area-weighted percentiles in linear time.

    Parameters
    ----------
    values : (M,) float64
        Finite, at least 0.
    areas : (M,) float64
        Finite, above 0.
    percents : sequence of int
        Each in 0..100.

    Returns
    -------
    list of float
        One of the values for each percentage; NaN where there are no triangles.

    Notes
    -----
    A radix selection on the bits of the values, which stand in the order of numbers as all are at
    least 0: bins are filled with area, the bin in which the percentage is reached is divided into
    bins in its turn.
    """
    if len(values) == 0:
        return [math.nan] * len(percents)
    unit = math.ldexp(1.0, min(1000, -math.frexp(float(areas.max()))[1]))  # largest area < 1
    bits = 62 - len(values).bit_length()  # the sum of all digits stays below 2^62
    keys = np.ascontiguousarray(values).view(np.int64)
    whole = _bin(keys, areas, unit, bits)

    def value_at(
        area: int, keys: NDArray[np.int64], areas: NDArray[np.float64], binned: _Binned
    ) -> float:
        i = binned.reaching(area)
        low = binned.first + (i << binned.shift)
        if binned.shift == 0:
            return float(np.int64(low).view(np.float64))
        inside = (keys >= low) & (keys < low + (1 << binned.shift))
        keys, areas = keys[inside], areas[inside]
        before = binned.area(i - 1) if i else 0
        return value_at(area - before, keys, areas, _bin(keys, areas, unit, bits))

    total = whole.area(-1)
    return [value_at(-(-percent * total // 100), keys, areas, whole) for percent in percents]
