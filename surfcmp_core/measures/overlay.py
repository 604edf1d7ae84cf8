"""The exact reading: F̂1 linear on T1, F̂2 on T2, integrated over the pieces of their overlay."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import kernel
from surfcmp_core.measures.chunks import over_chunks
from surfcmp_core.measures.clipping import MOST_CORNERS, cut_by_triangle, fan_share, plainest
from surfcmp_core.measures.linear_on_triangle import FRAME, moved_into, value_at
from surfcmp_core.measures.measures import Measures
from surfcmp_core.measures.overlay_side import (
    LinearSurface,
    OverlaySide,
    frame_of,
    lines_of,
    overlapped_with_data,
    precedes,
    side_of,
)
from surfcmp_core.measures.totals import (
    AREA,
    Part,
    TriangleValues,
    add_piece,
    add_triangle,
    measures_from,
    power_of_two_above,
    refuse_senseless,
    zero_sums,
)
from surfcmp_core.measures.triangle_integrals import mean_abs_weighted, ordered
from surfcmp_core.predicates import twice_area
from surfcmp_core.united import United

_BOTH = 3
_SLIVER = 1e-13
"""Share of a triangle's area that may be the rounding of two edges that only touch."""


@kernel
def _from_leftmost(
    nodes: NDArray[np.float64], triangles: NDArray[np.int32], t: int, corners: NDArray[np.int32]
) -> None:
    """Begin a triangle of T with its leftmost node, the lower one of two."""
    first = 0
    for k in range(1, 3):
        v, best = triangles[t, k], triangles[t, first]
        if nodes[v, 0] < nodes[best, 0] or (
            nodes[v, 0] == nodes[best, 0] and nodes[v, 1] < nodes[best, 1]
        ):
            first = k
    for k in range(3):
        corners[k] = triangles[t, (first + k) % 3]


@kernel
def _differences(
    polygons: NDArray[np.float64],
    piece: int,
    count: int,
    shape: NDArray[np.float64],
    frame_1: NDArray[np.float64],
    frame_2: NDArray[np.float64],
    unit: float,
    d: NDArray[np.float64],
) -> None:
    """Fill in d at the corners of a piece."""
    for k in range(count):
        b, c = polygons[piece, k, 1], polygons[piece, k, 2]
        x = b * shape[0, 0] + c * shape[1, 0]
        y = b * shape[0, 1] + c * shape[1, 1]
        x, y = moved_into(x, y, frame_1, frame_2)
        base_1, rise_1 = value_at(x, y, frame_1)
        base_2, rise_2 = value_at(x, y, frame_2)
        d[k] = ((base_1 - base_2) + (rise_1 - rise_2)) / unit


@kernel
def _pass(
    begin: int,
    end: int,
    nodes: NDArray[np.float64],
    label: NDArray[np.uint8],
    triangles: NDArray[np.int32],
    side_1: OverlaySide,
    side_2: OverlaySide,
    length: float,
    tolerances: NDArray[np.float64],
    node_weight: NDArray[np.float64],
    unit: float,
    areas: NDArray[np.float64],
    means_abs: NDArray[np.float64],
    means_signed: NDArray[np.float64],
    sums: NDArray[np.float64],
) -> float:
    """Fill in values and sums of triangles begin..end-1 of T; return the largest |d| there.

    Nodes are in units of `length`, sums in units of `unit`; a negative one exchanges the signs.
    """
    triangles_1 = np.empty(side_1.real, np.int32)
    triangles_2 = np.empty(side_2.real, np.int32)
    edges_1 = np.empty(side_1.real, np.int32)
    edges_2 = np.empty(side_2.real, np.int32)
    corners = np.empty(3, np.int32)
    shape = np.empty((2, 2))
    lines = np.empty((3, 3))
    frame_1 = np.empty(FRAME)
    frame_2 = np.empty(FRAME)
    weights = np.ones(3)
    polygons = np.zeros((5, MOST_CORNERS, 3))
    for k in range(3):
        polygons[0, k, k] = 1.0
    d = np.empty(MOST_CORNERS)
    weight = np.ones(MOST_CORNERS)
    triangle_sums = np.zeros(len(sums))
    largest = 0.0
    for t in range(begin, end):
        largest_here = 0.0
        share = 0.0
        volume = 0.0
        signed_volume = 0.0
        weighted_volume = 0.0
        _from_leftmost(nodes, triangles, t, corners)
        a, b, c = corners[0], corners[1], corners[2]
        x, y = nodes[a, 0], nodes[a, 1]
        shape[0, 0] = (nodes[b, 0] - x) * length
        shape[0, 1] = (nodes[b, 1] - y) * length
        shape[1, 0] = (nodes[c, 0] - x) * length
        shape[1, 1] = (nodes[c, 1] - y) * length
        whole = (
            0.5
            * length
            * length
            * twice_area(x, y, nodes[b, 0], nodes[b, 1], nodes[c, 0], nodes[c, 1])
        )
        if len(node_weight):
            for k in range(3):
                weights[k] = node_weight[corners[k]]
        count_1, covers_1 = overlapped_with_data(side_1, nodes, corners, triangles_1, edges_1)
        count_2, covers_2 = 0, False
        if count_1 > 0:
            count_2, covers_2 = overlapped_with_data(side_2, nodes, corners, triangles_2, edges_2)
        for i in range(count_1):
            lines_of(side_1, triangles_1[i], edges_1[i], nodes, corners, lines)
            part, in_part = cut_by_triangle(polygons, 0, 3, lines, edges_1[i], 1, 2)
            if in_part < 3:
                continue
            frame_of(side_1, triangles_1[i], x, y, length, frame_1)
            for j in range(count_2):
                lines_of(side_2, triangles_2[j], edges_2[j], nodes, corners, lines)
                piece, in_piece = cut_by_triangle(polygons, part, in_part, lines, edges_2[j], 3, 4)
                if in_piece < 3:
                    continue
                frame_of(side_2, triangles_2[j], x, y, length, frame_2)
                _differences(polygons, piece, in_piece, shape, frame_1, frame_2, unit, d)
                if len(node_weight):
                    for k in range(in_piece):
                        weight[k] = weights[0] + (
                            polygons[piece, k, 1] * (weights[1] - weights[0])
                            + polygons[piece, k, 2] * (weights[2] - weights[0])
                        )
                without = plainest(polygons, piece, in_piece)
                for k in range(2, in_piece):
                    fan = fan_share(polygons, piece, k, without)
                    if not fan > 0.0:
                        continue
                    lo, mid, hi = ordered(d[0], d[k - 1], d[k])
                    largest_here = max(largest_here, -lo, hi)
                    absolute, signed = add_piece(
                        triangle_sums, fan * whole, lo, mid, hi, tolerances
                    )
                    share += fan
                    volume += fan * absolute
                    signed_volume += fan * signed
                    if len(node_weight):
                        weighted_volume += fan * mean_abs_weighted(
                            d[0], d[k - 1], d[k], weight[0], weight[k - 1], weight[k]
                        )
        if share > _SLIVER:
            largest = max(largest, largest_here)
            if not len(node_weight):
                weighted_volume = volume
            interface = label[a] | label[b] | label[c] == _BOTH
            areas[t] = share * whole
            if covers_1 and covers_2:
                areas[t] = whole
                triangle_sums[AREA] = whole
            add_triangle(sums, triangle_sums, interface, volume, weighted_volume)
            means_abs[t] = volume / share * abs(unit)
            means_signed[t] = signed_volume / share * abs(unit)
        else:
            triangle_sums[:] = 0.0
            areas[t] = np.nan
            means_abs[t] = np.nan
            means_signed[t] = np.nan
    return largest


def measure_exactly(
    surface_1: LinearSurface,
    surface_2: LinearSurface,
    united: United,
    *,
    length: float = 1.0,
    tolerances: Sequence[float],
    node_weight: NDArray[np.float64] | None = None,
    footprint_1: float,
    footprint_2: float,
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
    footprint_1, footprint_2 : float
        Area in the plane over which each surface has data.
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
    area_unit = (extent * length) ** 2
    count = len(united.triangles)
    values = TriangleValues(np.empty(count), np.empty(count), np.empty(count))

    def work(begin: int, end: int) -> Part:
        sums = zero_sums(tolerances)
        largest = _pass(
            begin,
            end,
            united.nodes,
            united.label,
            united.triangles,
            first,
            second,
            1.0 / extent,
            np.array(tolerances, dtype=np.float64) / unit,
            np.empty(0) if node_weight is None else node_weight,
            -unit if exchanged else unit,
            values.area,
            values.mean_abs,
            values.mean_signed,
            sums,
        )
        return Part(sums, largest)

    measures = measures_from(
        over_chunks(work, count, threads, progress),
        values,
        unit,
        tolerances=tolerances,
        footprint_1=footprint_1 / area_unit,
        footprint_2=footprint_2 / area_unit,
        hausdorff=hausdorff,
    )
    return replace(values, area=values.area * area_unit), replace(
        measures,
        area_compared=measures.area_compared * area_unit,
        area_interface=measures.area_interface * area_unit,
        volume_above=measures.volume_above * area_unit,
        volume_below=measures.volume_below * area_unit,
    )
