"""The sums behind the measures, whichever way the difference was integrated."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.measures.compensated_sum import add
from surfcmp_core.measures.measures import Measures
from surfcmp_core.measures.percentiles import area_percentiles
from surfcmp_core.measures.triangle_integrals import mean, mean_parts, mean_square, share_within

AREA = 0
"""Place of a triangle's area among its sums."""
_AREA_INTERFACE = 1
_VOLUME = 2
_VOLUME_INTERFACE = 3
_VOLUME_SIGNED = 4
_VOLUME_ABOVE = 5
_VOLUME_BELOW = 6
_SQUARE = 7
_RHO = 8
_RHO_INTERFACE = 9
_RHO_WEIGHTED = 10
WITHIN_1 = 11
WITHIN_2 = 12
"""Areas of the triangles within the footprint of either surface."""
_TOLERATED = 13


class TriangleValues(NamedTuple):
    """What each of M triangles contributes; NaN where a triangle is not compared."""

    area: NDArray[np.float64]
    """(M,) area in the plane."""
    mean_abs: NDArray[np.float64]
    """(M,) mean of |d| over the triangle."""
    mean_signed: NDArray[np.float64]
    """(M,) mean of d over the triangle."""


@dataclass(frozen=True, slots=True, eq=False)
class Covered:
    """Where a surface has data, as far as areas go."""

    area: float
    """Of its footprint in the plane; what faces cover twice counts once."""
    shares: NDArray[np.float64] | None = None
    """(M,) how much of each triangle of T lies in it, 0 to 1; None: all that is compared does."""


class Terms(NamedTuple):
    """In which terms a difference d is measured."""

    unit: float
    """Length in which sums and tolerances are; a negative one exchanges the signs of values."""
    tolerances: NDArray[np.float64]
    node_weight: NDArray[np.float64]
    """(N,) µ at the nodes of T; empty for none."""


class Part(NamedTuple):
    """What some of the triangles of T contribute."""

    sums: NDArray[np.float64]
    """(k, 2) as `zero_sums` makes them, filled by `add_triangle`."""
    largest: float
    """Largest |d|."""


def refuse_senseless(tolerances: Sequence[float]) -> None:
    """Raise ValueError where a tolerance is negative or NaN."""
    if not all(tolerance >= 0.0 for tolerance in tolerances):
        raise ValueError("a tolerance is negative or not a number")


def terms_of(
    unit: float, tolerances: Sequence[float], node_weight: NDArray[np.float64] | None
) -> Terms:
    """Bring tolerances into a unit; no weight is an empty one."""
    weight = np.empty(0) if node_weight is None else node_weight
    return Terms(unit, np.array(tolerances, dtype=np.float64) / unit, weight)


def room_for_values(count: int) -> TriangleValues:
    """Make room for the values of so many triangles."""
    return TriangleValues(np.empty(count), np.empty(count), np.empty(count))


def zero_sums(tolerances: Sequence[float]) -> NDArray[np.float64]:
    """Make the sums to begin with, (k, 2) float64, each in two parts."""
    return np.zeros((_TOLERATED + len(tolerances), 2))


def power_of_two_above(largest: float) -> float:
    """Power of two that brings a length below 1 by division, which is exact."""
    return math.ldexp(1.0, min(max(math.frexp(largest)[1], -1000), 1000))


@kernel
def add_piece(
    triangle_sums: NDArray[np.float64],
    area: float,
    lo: float,
    mid: float,
    hi: float,
    tolerances: NDArray[np.float64],
) -> tuple[float, float]:
    """Add the integrals over a piece of a triangle of T; return its means of |d| and of d.

    Parameters
    ----------
    triangle_sums : (k,) float64
        Of the triangle of T.
    area : float
        Of the piece: a triangle on which d is linear.
    lo, mid, hi : float
        d at its corners, sorted; in a unit that keeps |d| ≤ 1.
    tolerances : float64
        In the same unit.
    """
    signed = mean(lo, mid, hi)
    above, below = mean_parts(lo, mid, hi)
    absolute = above + below
    triangle_sums[AREA] += area
    triangle_sums[_VOLUME] += area * absolute
    triangle_sums[_VOLUME_SIGNED] += area * signed
    triangle_sums[_VOLUME_ABOVE] += area * above
    triangle_sums[_VOLUME_BELOW] += area * below
    triangle_sums[_SQUARE] += area * mean_square(lo, mid, hi)
    for n in range(len(tolerances)):
        triangle_sums[_TOLERATED + n] += area * share_within(lo, mid, hi, tolerances[n])
    return absolute, signed


@kernel
def add_triangle(
    sums: NDArray[np.float64],
    triangle_sums: NDArray[np.float64],
    interface: bool,
    absolute: float,
    weighted: float,
) -> None:
    """Add the sums of a triangle of T to those of all, and empty them for the next.

    Parameters
    ----------
    sums : (k, 2) float64
    triangle_sums : (k,) float64
    interface : bool
        Whether the triangle is representative.
    absolute, weighted : float
        Its terms of the paper's sums: V/S without and with the weight.
    """
    triangle_sums[_RHO] = absolute
    triangle_sums[_RHO_WEIGHTED] = weighted
    if interface:
        triangle_sums[_AREA_INTERFACE] = triangle_sums[AREA]
        triangle_sums[_VOLUME_INTERFACE] = triangle_sums[_VOLUME]
        triangle_sums[_RHO_INTERFACE] = absolute
    for n in range(triangle_sums.size):
        add(sums, n, triangle_sums[n])
        triangle_sums[n] = 0.0


def _ratio(part: float, whole: float) -> float:
    return part / whole if whole else math.nan


def totals_of(parts: Sequence[Part]) -> list[float]:
    """Add up the sums of all parts, in any order to the last bit."""
    terms = np.concatenate([part.sums for part in parts], axis=1)
    return [math.fsum(row) for row in terms.tolist()]


_ROUNDING = 2.0**-40
"""Of two sums over the same area, cut into other pieces."""


def share_of(part: float, whole: float) -> float:
    """Divide two areas; no part of nothing is covered.

    Where both are the same but for the rounding of their sums, that is 1.
    """
    if not whole:
        return 0.0
    share = part / whole
    return 1.0 if 1.0 < share <= 1.0 + _ROUNDING else share


def measures_from(
    parts: Sequence[Part],
    values: TriangleValues,
    unit: float,
    *,
    tolerances: Sequence[float],
    coverage: tuple[float, float],
    hausdorff: tuple[float, float],
) -> Measures:
    """Make the measures of the sums.

    Parameters
    ----------
    parts : sequence of Part
        All triangles of T.
    values : TriangleValues
        For the percentiles.
    unit : float
        Length in which the parts are.
    tolerances, hausdorff
        As for :func:`surfcmp_core.measures.nodal`.
    coverage : (float, float)
        `Measures.coverage_1` and `Measures.coverage_2`.

    Returns
    -------
    Measures
        Where no triangle is compared, sums are 0 and means, percentiles and shares NaN.
    """
    total = totals_of(parts)
    largest = max((part.largest for part in parts), default=0.0)
    area, area_interface = total[AREA], total[_AREA_INTERFACE]
    compared = ~np.isnan(values.area)
    if compared.all():
        p50, p90, p95 = area_percentiles(values.mean_abs, values.area, (50, 90, 95))
    else:
        p50, p90, p95 = area_percentiles(
            values.mean_abs[compared], values.area[compared], (50, 90, 95)
        )
    return Measures(
        rho_V=total[_RHO] * unit,
        rho_V_mu=total[_RHO_WEIGHTED] * unit,
        rho_delta_V=total[_RHO_INTERFACE] * unit,
        mean_abs=_ratio(total[_VOLUME], area) * unit,
        mean_abs_interface=_ratio(total[_VOLUME_INTERFACE], area_interface) * unit,
        mean_signed=_ratio(total[_VOLUME_SIGNED], area) * unit,
        rms=math.sqrt(_ratio(total[_SQUARE], area)) * unit,
        max_abs=largest * unit if area else math.nan,
        p50=p50,
        p90=p90,
        p95=p95,
        within_tolerance={
            repr(float(tolerance)).removesuffix(".0"): _ratio(within, area)
            for tolerance, within in zip(tolerances, total[_TOLERATED:], strict=True)
        },
        volume_above=total[_VOLUME_ABOVE] * unit,
        volume_below=total[_VOLUME_BELOW] * unit,
        area_compared=area,
        area_interface=area_interface,
        coverage_1=coverage[0],
        coverage_2=coverage[1],
        hausdorff_1_2=hausdorff[0],
        hausdorff_2_1=hausdorff[1],
    )
