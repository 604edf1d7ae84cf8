"""The pass over the pieces of the overlay of T1, T2 and T on which d is linear."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.measures.compensated_sum import add
from surfcmp_core.measures.exact.clipping import (
    MOST_CORNERS,
    cut_by_triangle,
    fan_share,
    small_shares,
)
from surfcmp_core.measures.exact.linear_on_triangle import FRAME, value_at
from surfcmp_core.measures.exact.overlay_side import (
    OverlaySide,
    frame_of,
    from_leftmost,
    lines_of,
    overlapped_with_data,
)
from surfcmp_core.measures.exact.within import share_with_data, whole_polygon
from surfcmp_core.measures.totals import (
    AREA,
    WITHIN_1,
    WITHIN_2,
    Terms,
    TriangleValues,
    add_piece,
    add_triangle,
)
from surfcmp_core.measures.triangle_integrals import mean_abs_weighted, ordered
from surfcmp_core.predicates import twice_area

_BOTH = 3
_AT_HAND = 16
"""Triangles of the second surface that are described once for each triangle of T."""
_SLIVER = 1e-13
"""Share of a triangle's area that may be the rounding of two edges that only touch."""


@kernel
def _differences(
    polygons: NDArray[np.float64],
    piece: int,
    count: int,
    shape: NDArray[np.float64],
    frame_1: NDArray[np.float64],
    frames_2: NDArray[np.float64],
    which: int,
    per_unit: float,
    d: NDArray[np.float64],
) -> None:
    """Fill in d at the corners of a piece.

    Corners that rounding put beyond the tips of thin triangles are asked about in their boxes.
    """
    left, right = max(frame_1[0, 10], frames_2[which, 10]), min(frame_1[0, 11], frames_2[which, 11])
    low, high = max(frame_1[0, 12], frames_2[which, 12]), min(frame_1[0, 13], frames_2[which, 13])
    for k in range(count):
        b, c = polygons[piece, k, 1], polygons[piece, k, 2]
        x = min(max(b * shape[0, 0] + c * shape[1, 0], left), right)
        y = min(max(b * shape[0, 1] + c * shape[1, 1], low), high)
        base_1, rise_1 = value_at(x, y, frame_1, 0)
        base_2, rise_2 = value_at(x, y, frames_2, which)
        d[k] = ((base_1 - base_2) + (rise_1 - rise_2)) * per_unit


class Overlay(NamedTuple):
    """What is laid over each other.

    Attributes
    ----------
    places, label, triangles
        Nodes and triangles of T, see `United`.
    side_1, side_2 : OverlaySide
        T1 and T2.
    length : float
        What a unit of the nodes' coordinates is in that of the areas.
    continued : bool
        Whether all of T counts as having data.
    """

    places: NDArray[np.float64]
    label: NDArray[np.uint8]
    triangles: NDArray[np.int32]
    side_1: OverlaySide
    side_2: OverlaySide
    length: float
    continued: bool


@kernel
def integrate_pieces(
    begin: int,
    end: int,
    overlay: Overlay,
    terms: Terms,
    values: TriangleValues,
    sums: NDArray[np.float64],
) -> float:
    """Fill in values and sums of triangles begin..end-1 of T; return the largest |d| there."""
    places, label, triangles, side_1, side_2, length, continued = overlay
    unit, tolerances, node_weight = terms
    areas, means_abs, means_signed = values
    nodes_1, start_1, twin_1, real_1 = side_1.nodes, side_1.start, side_1.twin, side_1.real
    leaving_1, own_1, found_1, valid_1 = side_1.leaving, side_1.own, side_1.found, side_1.valid
    z_1, planes_1 = side_1.z, side_1.planes
    nodes_2, start_2, twin_2, real_2 = side_2.nodes, side_2.start, side_2.twin, side_2.real
    leaving_2, own_2, found_2, valid_2 = side_2.leaving, side_2.own, side_2.found, side_2.valid
    z_2, planes_2 = side_2.z, side_2.planes
    triangles_1 = np.empty(real_1, np.int32)
    triangles_2 = np.empty(real_2, np.int32)
    edges_1 = np.empty(real_1, np.int32)
    edges_2 = np.empty(real_2, np.int32)
    corners = np.empty(3, np.int32)
    shape = np.empty((2, 2))
    lines_1 = np.empty((1, 3, 3))
    lines_2 = np.empty((_AT_HAND, 3, 3))
    frame_1 = np.empty((1, FRAME))
    frames_2 = np.empty((_AT_HAND, FRAME))
    weights = np.ones(3)
    polygons = np.empty((5, MOST_CORNERS, 3))
    whole_polygon(polygons)
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
        from_leftmost(places, triangles, t, corners)
        a, b, c = corners[0], corners[1], corners[2]
        x, y = places[a, 0], places[a, 1]
        shape[0, 0] = (places[b, 0] - x) * length
        shape[0, 1] = (places[b, 1] - y) * length
        shape[1, 0] = (places[c, 0] - x) * length
        shape[1, 1] = (places[c, 1] - y) * length
        whole = (
            0.5
            * length
            * length
            * twice_area(x, y, places[b, 0], places[b, 1], places[c, 0], places[c, 1])
        )
        if len(node_weight):
            for k in range(3):
                weights[k] = node_weight[corners[k]]
        count_1, covers_1 = overlapped_with_data(
            nodes_1,
            start_1,
            twin_1,
            real_1,
            leaving_1,
            own_1,
            found_1,
            valid_1,
            places,
            corners,
            triangles_1,
            edges_1,
        )
        count_2, covers_2 = overlapped_with_data(
            nodes_2,
            start_2,
            twin_2,
            real_2,
            leaving_2,
            own_2,
            found_2,
            valid_2,
            places,
            corners,
            triangles_2,
            edges_2,
        )
        if count_1 > 0:
            for j in range(min(count_2, _AT_HAND)):
                lines_of(
                    nodes_2, start_2, own_2, triangles_2[j], edges_2[j], places, corners, lines_2, j
                )
                frame_of(nodes_2, start_2, z_2, planes_2, triangles_2[j], x, y, length, frames_2, j)
        for i in range(count_1):
            lines_of(
                nodes_1, start_1, own_1, triangles_1[i], edges_1[i], places, corners, lines_1, 0
            )
            part, in_part = cut_by_triangle(polygons, 0, 3, lines_1, 0, edges_1[i], 1, 2)
            if in_part < 3:
                continue
            frame_of(nodes_1, start_1, z_1, planes_1, triangles_1[i], x, y, length, frame_1, 0)
            for j in range(count_2):
                at = min(j, _AT_HAND - 1)
                if count_2 > _AT_HAND and j >= at:  # rare: those beyond share the last place
                    lines_of(
                        nodes_2,
                        start_2,
                        own_2,
                        triangles_2[j],
                        edges_2[j],
                        places,
                        corners,
                        lines_2,
                        at,
                    )
                    frame_of(
                        nodes_2, start_2, z_2, planes_2, triangles_2[j], x, y, length, frames_2, at
                    )
                piece, in_piece = cut_by_triangle(
                    polygons, part, in_part, lines_2, at, edges_2[j], 3, 4
                )
                if in_piece < 3:
                    continue
                _differences(polygons, piece, in_piece, shape, frame_1, frames_2, at, 1.0 / unit, d)
                if len(node_weight):
                    for k in range(in_piece):
                        weight[k] = weights[0] + (
                            polygons[piece, k, 1] * (weights[1] - weights[0])
                            + polygons[piece, k, 2] * (weights[2] - weights[0])
                        )
                first, second = small_shares(polygons, piece, in_piece)
                for k in range(2, in_piece):
                    fan = fan_share(polygons, piece, k, first, second)
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
            share = 0.0
            triangle_sums[:] = 0.0
            areas[t] = np.nan
            means_abs[t] = np.nan
            means_signed[t] = np.nan
        common = share if not (covers_1 and covers_2) else 1.0
        share_1 = share_2 = 1.0
        if not (covers_1 or continued):
            share_1 = share_with_data(
                nodes_1,
                start_1,
                own_1,
                places,
                corners,
                triangles_1,
                edges_1,
                count_1,
                polygons,
                lines_1,
            )
        if not (covers_2 or continued):
            share_2 = share_with_data(
                nodes_2,
                start_2,
                own_2,
                places,
                corners,
                triangles_2,
                edges_2,
                count_2,
                polygons,
                lines_1,
            )
        add(sums, WITHIN_1, max(common, share_1) * whole)
        add(sums, WITHIN_2, max(common, share_2) * whole)
    return largest
