"""Units of length: their sizes, and a surface's coordinates in another one.

Where a file or a caller states a unit is told at :func:`surfcmp_core.io.read_surface`, in which
one two surfaces are compared at :func:`surfcmp_core.surface.together.bring_together`.
"""

from dataclasses import replace
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.surface import Surface

_INCH = Fraction(254, 10)
SIZES: dict[str, Fraction] = {
    "nm": Fraction(1, 10**6),
    "um": Fraction(1, 1000),
    "mm": Fraction(1),
    "cm": Fraction(10),
    "dm": Fraction(100),
    "m": Fraction(1000),
    "km": Fraction(10**6),
    "mil": _INCH / 1000,
    "in": _INCH,
    "ft": 12 * _INCH,
    "us-ft": Fraction(1200, 3937) * 1000,
    "yd": 36 * _INCH,
}
"""Size in mm, exactly, of each unit that a file may state. The foot of US surveys is 2 in 10**6
longer than the international one, which is 4 m at coordinates of two million."""

UNITS = ("mm", "cm", "m", "um", "in", "ft", "us-ft")
"""Those that a caller may name: the command line, the window and Python."""

_NAMES = {size: name for name, size in SIZES.items()}


def name_of(size: Fraction) -> str:
    """Give the name of the unit that is `size` mm long; ``2.5 mm`` where it has none."""
    return _NAMES.get(size) or f"{float(size):g} mm"


def converted(surface: Surface, size: Fraction, unit: str) -> Surface:
    """Tell a surface's coordinates in another unit.

    Parameters
    ----------
    surface : Surface
        Whatever its `unit`.
    size : Fraction
        What one unit of its coordinates is, in mm.
    unit : str
        A key of `SIZES`.

    Returns
    -------
    Surface
        In `unit`, its nodes multiplied by a whole number or divided by one, where the ratio of
        both units is one, and so rounded once; by both else. The nodes converted are counted in
        `changed`; where the units are the same every bit stays.
    """
    ratio = size / SIZES[unit]
    if ratio == 1:
        return replace(surface, unit=unit)
    return replace(
        surface,
        points=_times(surface.points, ratio),
        unit=unit,
        scale=surface.scale * ratio,
        changed={
            **surface.changed,
            f"nodes converted from {name_of(size)} to {unit}": len(surface.points),
        },
    )


def _times(points: NDArray[np.float64], ratio: Fraction) -> NDArray[np.float64]:
    with np.errstate(over="ignore"):  # what overflows is found not finite where it is checked
        if ratio.numerator != 1:
            points = points * float(ratio.numerator)
        if ratio.denominator != 1:
            points = points / float(ratio.denominator)
    return points
