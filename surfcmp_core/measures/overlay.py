"""The exact reading: F̂1 linear on T1, F̂2 on T2, integrated over the pieces of their overlay."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import kernel
from surfcmp_core.measures.chunks import over_chunks
from surfcmp_core.measures.clipping import MOST_CORNERS, cut_by_triangle, value_at
from surfcmp_core.measures.measures import Measures
from surfcmp_core.measures.overlap import overlapped
from surfcmp_core.measures.totals import (
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
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import leaving_edges
from surfcmp_core.united import United

_BOTH = 3
_SLIVER = 1e-13
"""Share of a triangle's area that may be the rounding of two edges that only touch."""


@dataclass(frozen=True, slots=True, eq=False)
class LinearSurface:
    """One surface as a linear function on each triangle of its own triangulation.

    Attributes
    ----------
    triangulation : Triangulation
        T1 or T2, n nodes and m real triangles.
    z : (n,) float64
        F at its nodes.
    valid : (m,) bool
        Triangles over which the surface has data.
    found : (n',) int32
        Its triangle or ghost in which each node of the other grid lies.
    """

    triangulation: Triangulation
    z: NDArray[np.float64]
    valid: NDArray[np.bool_]
    found: NDArray[np.int32]


class _Side(NamedTuple):
    """A `LinearSurface` in the numbers of T, for the kernel."""

    nodes: NDArray[np.float64]
    start: NDArray[np.int32]
    twin: NDArray[np.int32]
    real: int
    leaving: NDArray[np.int32]
    own: NDArray[np.int32]
    found: NDArray[np.int32]
    z: NDArray[np.float64]
    valid: NDArray[np.bool_]


def _side(
    surface: LinearSurface,
    count: int,
    own_nodes: NDArray[np.int32],
    other_nodes: NDArray[np.int32],
) -> _Side:
    t = surface.triangulation
    own = np.full(count, -1, np.int32)
    own[own_nodes] = np.arange(len(own_nodes), dtype=np.int32)
    found = np.full(count, -1, np.int32)
    found[other_nodes] = surface.found
    leaving = leaving_edges(t.start, len(t.nodes))
    return _Side(
        t.nodes,
        t.start,
        t.twin,
        t.real,
        leaving,
        own,
        found,
        surface.z,
        surface.valid,
    )


@kernel
def _fetch(
    side: _Side,
    t: int,
    x: float,
    y: float,
    length: float,
    corners: NDArray[np.float64],
    z: NDArray[np.float64],
    numbers: NDArray[np.int32],
) -> None:
    """Read triangle t of T1 or T2, its corners as seen from (x, y)."""
    for k in range(3):
        v = side.start[3 * t + k]
        numbers[k] = v
        corners[k, 0] = (side.nodes[v, 0] - x) * length
        corners[k, 1] = (side.nodes[v, 1] - y) * length
        z[k] = side.z[v]


@kernel
def _overlapped(
    side: _Side,
    nodes: NDArray[np.float64],
    a: int,
    b: int,
    c: int,
    found_triangles: NDArray[np.int32],
    found_edges: NDArray[np.int32],
) -> int:
    return overlapped(
        side.nodes,
        side.start,
        side.twin,
        side.real,
        side.leaving,
        side.own,
        side.found,
        nodes,
        a,
        b,
        c,
        found_triangles,
        found_edges,
    )


@kernel
def _pass(
    begin: int,
    end: int,
    nodes: NDArray[np.float64],
    label: NDArray[np.uint8],
    triangles: NDArray[np.int32],
    side_1: _Side,
    side_2: _Side,
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

    Nodes are in units of `length`, sums in units of `unit`.
    """
    triangles_1 = np.empty(side_1.real, np.int32)
    triangles_2 = np.empty(side_2.real, np.int32)
    edges_1 = np.empty(side_1.real, np.int32)
    edges_2 = np.empty(side_2.real, np.int32)
    corners = np.empty((3, 2))
    corners_1 = np.empty((3, 2))
    corners_2 = np.empty((3, 2))
    weights = np.ones(3)
    z_1 = np.empty(3)
    z_2 = np.empty(3)
    numbers_1 = np.empty(3, np.int32)
    numbers_2 = np.empty(3, np.int32)
    polygons = np.empty((5, MOST_CORNERS, 2))
    d = np.empty(MOST_CORNERS)
    weight = np.ones(MOST_CORNERS)
    triangle_sums = np.zeros(len(sums))
    largest = 0.0
    for t in range(begin, end):
        area = 0.0
        largest_here = 0.0
        volume = 0.0
        signed_volume = 0.0
        weighted_volume = 0.0
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        x, y = nodes[a, 0], nodes[a, 1]
        for k in range(3):
            v = triangles[t, k]
            corners[k, 0] = (nodes[v, 0] - x) * length
            corners[k, 1] = (nodes[v, 1] - y) * length
            polygons[0, k, 0] = corners[k, 0]
            polygons[0, k, 1] = corners[k, 1]
            if len(node_weight):
                weights[k] = node_weight[v]
        count_1 = _overlapped(side_1, nodes, a, b, c, triangles_1, edges_1)
        count_2 = 0
        if count_1 > 0:
            count_2 = _overlapped(side_2, nodes, a, b, c, triangles_2, edges_2)
        for i in range(count_1):
            t_1 = triangles_1[i]
            if not side_1.valid[t_1]:
                continue
            _fetch(side_1, t_1, x, y, length, corners_1, z_1, numbers_1)
            part, in_part = cut_by_triangle(polygons, 0, 3, corners_1, numbers_1, edges_1[i], 1, 2)
            if in_part < 3:
                continue
            for j in range(count_2):
                t_2 = triangles_2[j]
                if not side_2.valid[t_2]:
                    continue
                _fetch(side_2, t_2, x, y, length, corners_2, z_2, numbers_2)
                piece, in_piece = cut_by_triangle(
                    polygons, part, in_part, corners_2, numbers_2, edges_2[j], 3, 4
                )
                for k in range(in_piece):
                    px, py = polygons[piece, k, 0], polygons[piece, k, 1]
                    base_1, rise_1 = value_at(px, py, corners_1, z_1)
                    base_2, rise_2 = value_at(px, py, corners_2, z_2)
                    d[k] = ((base_1 - base_2) + (rise_1 - rise_2)) / unit
                    if len(node_weight):
                        base, rise = value_at(px, py, corners, weights)
                        weight[k] = base + rise
                px, py = polygons[piece, 0, 0], polygons[piece, 0, 1]
                for k in range(2, in_piece):
                    ux, uy = polygons[piece, k - 1, 0] - px, polygons[piece, k - 1, 1] - py
                    vx, vy = polygons[piece, k, 0] - px, polygons[piece, k, 1] - py
                    fan_area = 0.5 * (ux * vy - vx * uy)
                    if not fan_area > 0.0:
                        continue
                    lo, mid, hi = ordered(d[0], d[k - 1], d[k])
                    largest_here = max(largest_here, -lo, hi)
                    absolute, signed = add_piece(triangle_sums, fan_area, lo, mid, hi, tolerances)
                    area += fan_area
                    volume += fan_area * absolute
                    signed_volume += fan_area * signed
                    if len(node_weight):
                        weighted_volume += fan_area * mean_abs_weighted(
                            d[0], d[k - 1], d[k], weight[0], weight[k - 1], weight[k]
                        )
        ux, uy, vx, vy = corners[1, 0], corners[1, 1], corners[2, 0], corners[2, 1]
        whole = max(area, 0.5 * (ux * vy - vx * uy))
        if area > _SLIVER * whole:
            largest = max(largest, largest_here)
            if not len(node_weight):
                weighted_volume = volume
            interface = label[a] | label[b] | label[c] == _BOTH
            add_triangle(sums, triangle_sums, interface, volume / whole, weighted_volume / whole)
            areas[t] = area
            means_abs[t] = volume / area * unit
            means_signed[t] = signed_volume / area * unit
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
    side_1 = _side(surface_1, len(united.nodes), united.node_1, united.node_2)
    side_2 = _side(surface_2, len(united.nodes), united.node_2, united.node_1)
    z_1, z_2 = surface_1.z, surface_2.z
    unit = power_of_two_above(
        max(float(z_1.max()) - float(z_2.min()), float(z_2.max()) - float(z_1.min()))
    )
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
            side_1,
            side_2,
            length,
            np.array(tolerances, dtype=np.float64) / unit,
            np.empty(0) if node_weight is None else node_weight,
            unit,
            values.area,
            values.mean_abs,
            values.mean_signed,
            sums,
        )
        return Part(sums, largest)

    return values, measures_from(
        over_chunks(work, count, threads, progress),
        values,
        unit,
        tolerances=tolerances,
        footprint_1=footprint_1,
        footprint_2=footprint_2,
        hausdorff=hausdorff,
    )
