"""All measures of one comparison, in one pass over the triangles."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.measures.chunks import over_chunks
from surfcmp_core.measures.measures import Measures
from surfcmp_core.measures.totals import (
    WITHIN_1,
    WITHIN_2,
    Covered,
    Part,
    Terms,
    TriangleValues,
    add_piece,
    add_triangle,
    measures_from,
    power_of_two_above,
    refuse_senseless,
    room_for_values,
    share_of,
    terms_of,
    totals_of,
    zero_sums,
)
from surfcmp_core.measures.triangle_area import triangle_area
from surfcmp_core.measures.triangle_integrals import mean_abs_weighted, ordered

_BOTH = 3


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


class _Measured(NamedTuple):
    """What is measured of T.

    Attributes
    ----------
    nodes, label, triangles, compared, triangle_weight
        As for :func:`measure`; no weight is an empty one.
    difference : (N,) float64
        d at the nodes, in a unit that makes it at most 1.
    share_1, share_2 : (M,) float64
        Of `Covered`; empty where all that is compared is covered.
    """

    nodes: NDArray[np.float64]
    label: NDArray[np.uint8]
    triangles: NDArray[np.int32]
    difference: NDArray[np.float64]
    compared: NDArray[np.bool_]
    triangle_weight: NDArray[np.float64]
    share_1: NDArray[np.float64]
    share_2: NDArray[np.float64]


@kernel
def _pass(
    begin: int,
    end: int,
    measured: _Measured,
    terms: Terms,
    values: TriangleValues,
    sums: NDArray[np.float64],
) -> tuple[int, float]:
    """Fill in values and sums of triangles begin..end-1.

    Values are in the input's unit, sums in that of `terms`.
    Return the first triangle without positive area or without difference (-1: none), and the
    largest |d|.
    """
    nodes, label, triangles, difference, compared, triangle_weight, share_1, share_2 = measured
    unit, tolerances, node_weight = terms
    areas, means_abs, means_signed = values
    largest = 0.0
    triangle_sums = np.zeros(len(sums))
    for t in range(begin, end):
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
        absolute, signed = add_piece(triangle_sums, area, lo, mid, hi, tolerances)
        weighted = absolute
        if len(node_weight):
            weighted = mean_abs_weighted(a, b, c, node_weight[i], node_weight[j], node_weight[k])
        if len(triangle_weight):
            weighted *= triangle_weight[t]
        interface = label[i] | label[j] | label[k] == _BOTH
        triangle_sums[WITHIN_1] = area * share_1[t] if len(share_1) else area
        triangle_sums[WITHIN_2] = area * share_2[t] if len(share_2) else area
        add_triangle(sums, triangle_sums, interface, absolute, weighted)
        areas[t] = area
        means_abs[t] = absolute * unit
        means_signed[t] = signed * unit
    return -1, largest


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
    footprint_1: Covered,
    footprint_2: Covered,
    hausdorff: tuple[float, float],
    threads: int = 1,
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
    footprint_1, footprint_2 : Covered
        Where each surface has data; what of a triangle lies beyond it does not count as coverage.
    hausdorff : (float, float)
        `Measures.hausdorff_1_2` and `Measures.hausdorff_2_1`.
    threads : int
        How many may work at once; the results do not depend on it.

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
    refuse_senseless(tolerances)
    difference = np.empty(len(nodes))
    unit = power_of_two_above(_subtract(z1, z2, difference))
    difference /= unit
    count = len(triangles)
    values = room_for_values(count)
    measured = _Measured(
        nodes,
        label,
        triangles,
        difference,
        compared,
        np.empty(0) if triangle_weight is None else triangle_weight,
        np.empty(0) if footprint_1.shares is None else footprint_1.shares,
        np.empty(0) if footprint_2.shares is None else footprint_2.shares,
    )
    terms = terms_of(unit, tolerances, node_weight)

    def work(begin: int, end: int) -> Part:
        sums = zero_sums(tolerances)
        faulty, largest = _pass(begin, end, measured, terms, values, sums)
        if faulty >= 0:
            raise ValueError(f"triangle {faulty} lacks area or data and cannot be compared")
        return Part(sums, largest)

    parts = [Part(zero_sums(tolerances), 0.0), *over_chunks(work, count, threads)]
    total = totals_of(parts)
    return values, measures_from(
        parts,
        values,
        unit,
        tolerances=tolerances,
        coverage=(
            share_of(total[WITHIN_1], footprint_1.area),
            share_of(total[WITHIN_2], footprint_2.area),
        ),
        hausdorff=hausdorff,
    )
