"""Two surfaces as they were read, brought to one unit of length and to the same axes."""

from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.surface import Surface
from surfcmp_core.surface.units import SIZES, converted, name_of

ASSUMED = "mm"
"""The unit taken, with a warning, where neither surface states one."""

_SURVEYS = {"m", "km", "ft", "us-ft", "yd"}
"""Units of surveys: two different ones are compared in metres, all others in millimetres."""


@dataclass(frozen=True, slots=True, eq=False)
class Together:
    """Two surfaces that may be compared number by number.

    Attributes
    ----------
    surfaces : two Surface
        Both state the same unit, and the same axes or none; `changed` counts what was done.
    warnings : tuple of str
        What was taken for granted.
    """

    surfaces: tuple[Surface, Surface]
    warnings: tuple[str, ...]


def bring_together(first: Surface, second: Surface) -> Together:
    """Give both surfaces one unit and the same axes, by one rule whatever their formats.

    Where both state the same unit every bit stays. Two different ones become millimetres, or
    metres where both are units of surveys (m, km, ft, us-ft, yd): the same with the roles
    exchanged. A surface that states none is taken as in the unit that the file of the other one
    states, and in millimetres where neither does; both with a warning. Where one is in RAS and the
    other in LPS (x to the right and y to the front, or to the left and to the back), that in RAS
    is turned to LPS; one that states no axes is taken as in those of the other, with a warning.

    Parameters
    ----------
    first, second : Surface
        As read.

    Returns
    -------
    Together

    Raises
    ------
    InputError
        Two units of which one is not a length that is known, or of two geodetic reference systems:
        places on the earth have other coordinates there, not the same in another unit.
    """
    surfaces, of_units = _in_one_unit(first, second)
    surfaces, of_axes = _in_one_space(*surfaces)
    return Together(surfaces, (*of_units, *of_axes))


def check_together(first: Surface, second: Surface) -> None:
    """Refuse two surfaces that state different units or axes.

    Raises
    ------
    InputError
        It names both; :func:`bring_together` makes them one.
    """
    for one, two in ((first.unit, second.unit), (first.space, second.space)):
        if one and two and one != two:
            raise _unlike(second, one, two)


def carried(motion: NDArray[np.float64], scale: Fraction, turned: bool) -> NDArray[np.float64]:
    """Tell a motion in another unit and other axes.

    Parameters
    ----------
    motion : (4, 4) float64
        Rigid.
    scale : Fraction
        How many of the new units an old one is.
    turned : bool
        Whether the new axes x and y point against the old ones.

    Returns
    -------
    (4, 4) float64
        The rotation keeps its bits but for signs, the shift is multiplied by `scale`.
    """
    told = np.array(motion, np.float64)
    if scale != 1:
        told[:3, 3] *= float(scale)
    if turned:
        told[:2] *= -1.0
        told[:, :2] *= -1.0
    return told


def _in_one_unit(
    first: Surface, second: Surface
) -> tuple[tuple[Surface, Surface], tuple[str, ...]]:
    if first.unit and second.unit:
        if first.unit == second.unit:
            return (first, second), ()
        if first.georeferenced and second.georeferenced:
            remedy = "bring both into one reference system"
            raise _unlike(second, first.unit, second.unit).with_hints(remedy)
        if not {first.unit, second.unit} <= set(SIZES):
            raise _unlike(second, first.unit, second.unit)
        unit = "m" if {first.unit, second.unit} <= _SURVEYS else ASSUMED
        return (
            converted(first, SIZES[first.unit], unit),
            converted(second, SIZES[second.unit], unit),
        ), ()
    if not first.unit and not second.unit:
        names = " and ".join(dict.fromkeys((first.name, second.name)))
        note = f"no unit stated in {names}: taken as {ASSUMED}"
        return (replace(first, unit=ASSUMED), replace(second, unit=ASSUMED)), (note,)
    silent, other = (second, first) if first.unit else (first, second)
    taken, word = _like(silent, other)
    note = f"no unit stated in {silent.name}: taken as {word}"
    return ((taken, other) if silent is first else (other, taken)), (note,)


def _like(silent: Surface, other: Surface) -> tuple[Surface, str]:
    """Take a surface as in the unit of the other's file, and tell it as the other is told."""
    assert other.unit is not None
    if other.unit not in SIZES:
        return replace(silent, unit=other.unit), other.unit
    size = SIZES[other.unit] * other.scale
    return converted(silent, size, other.unit), name_of(size)


def _in_one_space(
    first: Surface, second: Surface
) -> tuple[tuple[Surface, Surface], tuple[str, ...]]:
    if first.space == second.space:
        return (first, second), ()
    if first.space and second.space:
        return (_in_lps(first), _in_lps(second)), ()
    silent, other = (second, first) if first.space else (first, second)
    note = (
        f"{other.name} says that its axes are {other.space}, {silent.name} does not say: "
        f"taken as {other.space} too"
    )
    taken = replace(silent, space=other.space)
    return ((taken, other) if silent is first else (other, taken)), (note,)


def _in_lps(surface: Surface) -> Surface:
    if surface.space == "LPS":
        return surface
    return replace(
        surface,
        points=surface.points * [-1.0, -1.0, 1.0],  # half a turn about z: no bit is lost
        space="LPS",
        turned=not surface.turned,
        changed={**surface.changed, "nodes turned from RAS to LPS": len(surface.points)},
    )


def _unlike(second: Surface, one: str, two: str) -> InputError:
    fault = f"is in {two}, but the other surface in {one}"
    return InputError(fault, where=(str(second.path or second.name),))
