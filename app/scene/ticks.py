"""Round ticks."""

import math

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.colours.scale import round_up


def ticks(low: float, high: float, most: int = 7) -> list[float]:
    """Return round values from `low` to `high`, at most `most` of them."""
    step = round_up((high - low) / most) if high > low else 1.0
    while (high - low) / step > most - 1 + 1e-9:
        step = round_up(step * 1.5)
    first = math.ceil(low / step - 1e-9)
    last = math.floor(high / step + 1e-9)
    return [float(f"{k * step:.12g}") for k in range(first, last + 1)]


def round_down(value: float) -> float:
    """Return the largest of 1, 2, 5 times a power of ten that is at most `value`."""
    if not math.isfinite(value) or value <= 0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(value) + 1e-12)
    step = next(k for k in (5, 2, 1) if value >= k * power * (1 - 1e-9))
    return float(f"{step * power:.12g}")


def padded(values: NDArray[np.float64]) -> tuple[float, float]:
    """Return the range of an axis that shows all finite values with some room."""
    known = values[np.isfinite(values)]
    if not known.size:
        return (0.0, 1.0)
    low, high = float(known.min()), float(known.max())
    room = 0.06 * (high - low) or max(abs(high), 1.0) * 0.1
    return (low - room, high + room)
