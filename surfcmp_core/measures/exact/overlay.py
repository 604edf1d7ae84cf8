"""The exact reading: F̂1 linear on T1, F̂2 on T2, integrated over the pieces of their overlay."""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.measures.chunks import over_chunks
from surfcmp_core.measures.exact.overlay_side import (
    LinearSurface,
    precedes,
    side_of,
)
from surfcmp_core.measures.exact.pieces import Overlay, integrate_pieces
from surfcmp_core.measures.measures import Measures
from surfcmp_core.measures.totals import (
    AREA,
    WITHIN_1,
    WITHIN_2,
    Part,
    TriangleValues,
    measures_from,
    power_of_two_above,
    refuse_senseless,
    room_for_values,
    share_of,
    terms_of,
    totals_of,
    zero_sums,
)
from surfcmp_core.measures.triangle_area import triangle_areas
from surfcmp_core.united import United


def measure_exactly(
    surface_1: LinearSurface,
    surface_2: LinearSurface,
    united: United,
    *,
    length: float = 1.0,
    tolerances: Sequence[float],
    node_weight: NDArray[np.float64] | None = None,
    continued: bool = False,
    hausdorff: tuple[float, float],
    threads: int = 1,
    progress: Callable[[float], None] | None = None,
) -> tuple[TriangleValues, Measures]:
    """Measure the difference of two functions, each linear on its own triangles.

    Every triangle of T counts with the part of it over which both surfaces have data, whether it
    is compared in the nodal reading or not; the paper's sums divide by its whole area.

    Parameters
    ----------
    surface_1, surface_2 : LinearSurface
        The surfaces.
    united : United
        T of their triangulations, with the very same nodes.
    length : float
        Power of two: what one unit of the nodes' coordinates is in the unit of the results.
    tolerances : sequence of float
        Lengths, at least 0, for `Measures.within_tolerance`.
    node_weight : (N,) float64, optional
        µ at the nodes of T, linear on each of its triangles.
    continued : bool
        Whether coverage is a share of all of T, over which surfaces are continued, and not of
        where each has data.
    hausdorff : (float, float)
        `Measures.hausdorff_1_2` and `Measures.hausdorff_2_1`.
    threads : int
        How many may work at once; the results do not depend on it.
    progress : callable, optional
        Called now and then with the share done; may raise to cancel.

    Returns
    -------
    TriangleValues
        Of the common part of each triangle of T; NaN where there is none.
    Measures
        Under the same names as the nodal ones. `area_compared` is the true common area, `max_abs`
        the largest difference anywhere. Where there is no common area, sums are 0 and means,
        percentiles and shares NaN.

    Raises
    ------
    ValueError
        Where a tolerance is negative or NaN.
    """
    refuse_senseless(tolerances)
    first = side_of(surface_1, len(united.nodes), united.node_1, united.node_2)
    second = side_of(surface_2, len(united.nodes), united.node_2, united.node_1)
    exchanged = precedes(surface_2, surface_1)  # so that rounding does not know the roles
    if exchanged:
        first, second = second, first
    z_1, z_2 = surface_1.z, surface_2.z
    unit = power_of_two_above(
        max(float(z_1.max()) - float(z_2.min()), float(z_2.max()) - float(z_1.min()))
    )
    # products of areas: in units of the whole extent they neither over- nor underflow
    extent = power_of_two_above(float(np.ptp(united.nodes, axis=0).max()))
    area_unit = (extent * length) * (extent * length)
    count = len(united.triangles)
    values = room_for_values(count)

    overlay = Overlay(
        united.nodes, united.label, united.triangles, first, second, 1.0 / extent, continued
    )
    terms = terms_of(unit, tolerances, node_weight)._replace(unit=-unit if exchanged else unit)

    def work(begin: int, end: int) -> Part:
        sums = zero_sums(tolerances)
        return Part(sums, integrate_pieces(begin, end, overlay, terms, values, sums))

    parts = [Part(zero_sums(tolerances), 0.0), *over_chunks(work, count, threads, progress)]
    total = totals_of(parts)
    coverage = tuple(share_of(total[AREA], total[w]) for w in (WITHIN_1, WITHIN_2))
    measures = measures_from(
        parts,
        values,
        unit,
        tolerances=tolerances,
        coverage=(coverage[exchanged], coverage[not exchanged]),
        hausdorff=hausdorff,
    )
    return values._replace(area=values.area * area_unit), replace(
        measures,
        area_compared=measures.area_compared * area_unit,
        area_interface=measures.area_interface * area_unit,
        volume_above=measures.volume_above * area_unit,
        volume_below=measures.volume_below * area_unit,
    )


def disagreement(one: LinearSurface, other: LinearSurface) -> tuple[float, float]:
    """Tell how far two surfaces on the same nodes, with the same values there, are apart.

    Parameters
    ----------
    one : LinearSurface
        Whose triangles differ from those of
    other : LinearSurface
        over which it is asked, where that has data.

    Returns
    -------
    mean, largest : float
        ∬|difference| over the area where the other has data, and the largest one.
    """
    count = len(one.z)
    everywhere = np.arange(count, dtype=np.int32)
    nobody = np.empty(0, np.int32)
    first, second = (side_of(s, count, everywhere, nobody) for s in (one, other))
    triangles = one.triangulation.triangles
    unlike = (triangles != other.triangulation.triangles).any(axis=1)
    unlike |= (np.sort(other.planes, axis=1) != np.sort(triangles, axis=1)).any(axis=1)
    triangles = triangles[unlike]
    unit = power_of_two_above(float(one.z.max()) - float(one.z.min()))
    t = other.triangulation
    extent = power_of_two_above(float(np.ptp(t.nodes, axis=0).max()))
    values = room_for_values(len(triangles))
    overlay = Overlay(
        one.triangulation.nodes,
        np.zeros(count, np.uint8),
        triangles,
        first,
        second,
        1.0 / extent,
        continued=True,
    )
    terms = terms_of(unit, (), None)
    largest = integrate_pieces(0, len(triangles), overlay, terms, values, zero_sums(()))
    whole = math.fsum(triangle_areas(t.nodes / extent, t.triangles[other.valid]))
    there = ~np.isnan(values.area)
    return math.fsum(values.area[there] * values.mean_abs[there]) / whole, largest * unit
