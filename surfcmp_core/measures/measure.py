"""All measures of one comparison, in one pass over the triangles."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import kernel
from surfcmp_core.measures.compensated_sum import add
from surfcmp_core.measures.measures import Measures
from surfcmp_core.measures.percentiles import area_percentiles
from surfcmp_core.measures.triangle_area import triangle_area
from surfcmp_core.measures.triangle_integrals import (
    mean,
    mean_abs_weighted,
    mean_parts,
    mean_square,
    ordered,
    share_within,
)

_REPRESENTATIVE = 3

# The sums of the pass; those of the tolerances follow.
_AREA = 0
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
_WITHIN = 11


@dataclass(frozen=True, slots=True, eq=False)
class TriangleValues:
    """What each of M triangles contributes; NaN where a triangle is not compared."""

    area: NDArray[np.float64]
    """(M,) area in the plane."""
    mean_abs: NDArray[np.float64]
    """(M,) mean of |d| over the triangle."""
    mean_signed: NDArray[np.float64]
    """(M,) mean of d over the triangle."""


@kernel
def _subtract(
    z1: NDArray[np.float64], z2: NDArray[np.float64], difference: NDArray[np.float64]
) -> float:
    """Fill in d = z1 - z2; return the largest finite |d|."""
    largest = 0.0
    for i in range(len(z1)):
        d = z1[i] - z2[i]
        difference[i] = d
        if largest < abs(d) < np.inf:
            largest = abs(d)
    return largest


@kernel
def _pass(
    nodes: NDArray[np.float64],
    label: NDArray[np.uint8],
    triangles: NDArray[np.int32],
    difference: NDArray[np.float64],
    compared: NDArray[np.bool_],
    tolerances: NDArray[np.float64],
    node_weight: NDArray[np.float64],
    triangle_weight: NDArray[np.float64],
    unit: float,
    areas: NDArray[np.float64],
    means_abs: NDArray[np.float64],
    means_signed: NDArray[np.float64],
    sums: NDArray[np.float64],
) -> tuple[int, float]:
    """Fill in values and sums.

    The difference comes in units that make it at most 1; values leave in the input's, sums stay.
    Return the first triangle without positive area or without difference (-1: none), and the
    largest |d|.
    """
    largest = 0.0
    for t in range(len(triangles)):
        if not compared[t]:
            areas[t] = np.nan
            means_abs[t] = np.nan
            means_signed[t] = np.nan
            continue
        i, j, k = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        area = triangle_area(
            nodes[i, 0], nodes[i, 1], nodes[j, 0], nodes[j, 1], nodes[k, 0], nodes[k, 1]
        )
        a, b, c = difference[i], difference[j], difference[k]
        if not (area > 0.0 and abs(a) <= 1.0 and abs(b) <= 1.0 and abs(c) <= 1.0):
            return t, largest
        lo, mid, hi = ordered(a, b, c)
        largest = max(largest, -lo, hi)
        signed = mean(lo, mid, hi)
        above, below = mean_parts(lo, mid, hi)
        absolute = above + below
        weighted = absolute
        if len(node_weight):
            weighted = mean_abs_weighted(a, b, c, node_weight[i], node_weight[j], node_weight[k])
        if len(triangle_weight):
            weighted *= triangle_weight[t]

        areas[t] = area
        means_abs[t] = absolute * unit
        means_signed[t] = signed * unit
        add(sums, _AREA, area)
        add(sums, _VOLUME, area * absolute)
        add(sums, _VOLUME_SIGNED, area * signed)
        add(sums, _VOLUME_ABOVE, area * above)
        add(sums, _VOLUME_BELOW, area * below)
        add(sums, _SQUARE, area * mean_square(lo, mid, hi))
        add(sums, _RHO, absolute)
        add(sums, _RHO_WEIGHTED, weighted)
        if label[i] | label[j] | label[k] == _REPRESENTATIVE:
            add(sums, _AREA_INTERFACE, area)
            add(sums, _VOLUME_INTERFACE, area * absolute)
            add(sums, _RHO_INTERFACE, absolute)
        for n in range(len(tolerances)):
            add(sums, _WITHIN + n, area * share_within(lo, mid, hi, tolerances[n]))
    return -1, largest


def _ratio(part: float, whole: float) -> float:
    return part / whole if whole else math.nan


def measure(
    nodes: NDArray[np.float64],
    label: NDArray[np.uint8],
    triangles: NDArray[np.int32],
    z1: NDArray[np.float64],
    z2: NDArray[np.float64],
    compared: NDArray[np.bool_],
    *,
    tolerances: Sequence[float],
    node_weight: NDArray[np.float64] | None = None,
    triangle_weight: NDArray[np.float64] | None = None,
    footprint_1: float,
    footprint_2: float,
    hausdorff: tuple[float, float],
) -> tuple[TriangleValues, Measures]:
    """Measure the difference d = z1 − z2, linear on each triangle (the nodal reading).

    For a region, pass the mask of its compared triangles: areas, volumes and the paper's sums of
    disjoint regions add up to those of their union.

    Parameters
    ----------
    nodes : (N, 2) float64
        x, y of the united grid.
    label : (N,) uint8
        1 node of G1, 2 of G2, 3 shared.
    triangles : (M, 3) int32
        Counter-clockwise.
    z1, z2 : (N,) float64
        F̂1 and F̂2 at the nodes; NaN where there is no data.
    compared : (M,) bool
        Triangles to measure; none may touch a node without data or lack area.
    tolerances : sequence of float
        Lengths, at least 0, for `Measures.within_tolerance`.
    node_weight : (N,) float64, optional
        µ at the nodes, linear on each triangle.
    triangle_weight : (M,) float64, optional
        µ of each triangle; multiplies `node_weight` where both are given.
    footprint_1, footprint_2 : float
        Area in the plane over which each surface has data.
    hausdorff : (float, float)
        `Measures.hausdorff_1_2` and `Measures.hausdorff_2_1`.

    Returns
    -------
    TriangleValues
        Of each triangle.
    Measures
        Where no triangle is compared, sums are 0 and means, percentiles and shares NaN.

    Raises
    ------
    ValueError
        Where a compared triangle has no positive area or touches a node without data, or a
        tolerance is negative or NaN.
    """
    if not all(tolerance >= 0.0 for tolerance in tolerances):
        raise ValueError("a tolerance is negative or not a number")
    difference = np.empty(len(nodes))
    largest = _subtract(z1, z2, difference)
    # In units of this power of two |d| ≤ 1 and d² keeps its digits; the scaling itself is exact.
    exponent = min(max(math.frexp(largest)[1], -1000), 1000)
    scale = math.ldexp(1.0, -exponent)
    unit = math.ldexp(1.0, exponent)
    difference *= scale

    count = len(triangles)
    values = TriangleValues(np.empty(count), np.empty(count), np.empty(count))
    sums = np.zeros((_WITHIN + len(tolerances), 2))
    nowhere = np.empty(0)
    faulty, largest = _pass(
        nodes,
        label,
        triangles,
        difference,
        compared,
        np.array(tolerances, dtype=np.float64) * scale,
        nowhere if node_weight is None else node_weight,
        nowhere if triangle_weight is None else triangle_weight,
        unit,
        values.area,
        values.mean_abs,
        values.mean_signed,
        sums,
    )
    if faulty >= 0:
        raise ValueError(f"triangle {faulty} lacks area or data and cannot be compared")
    del difference

    total = sums.sum(axis=1).tolist()
    area, area_interface = total[_AREA], total[_AREA_INTERFACE]
    if compared.all():
        p50, p90, p95 = area_percentiles(values.mean_abs, values.area, (50, 90, 95))
    else:
        p50, p90, p95 = area_percentiles(
            values.mean_abs[compared], values.area[compared], (50, 90, 95)
        )
    return values, Measures(
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
            for tolerance, within in zip(tolerances, total[_WITHIN:], strict=True)
        },
        volume_above=total[_VOLUME_ABOVE] * unit,
        volume_below=total[_VOLUME_BELOW] * unit,
        area_compared=area,
        area_interface=area_interface,
        coverage_1=area / footprint_1 if footprint_1 else 0.0,
        coverage_2=area / footprint_2 if footprint_2 else 0.0,
        hausdorff_1_2=hausdorff[0],
        hausdorff_2_1=hausdorff[1],
    )
