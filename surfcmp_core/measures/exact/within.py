"""How much of each triangle of T lies where a surface has data."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.cells.bed import Bed, extent
from surfcmp_core.cells.gaps import Gaps
from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.measures.chunks import over_chunks
from surfcmp_core.measures.compensated_sum import add
from surfcmp_core.measures.exact.clipping import (
    MOST_CORNERS,
    cut_by_triangle,
    fan_share,
    small_shares,
)
from surfcmp_core.measures.exact.overlay_side import (
    LinearSurface,
    OverlaySide,
    from_leftmost,
    lines_of,
    overlapped_with_data,
    side_of,
)
from surfcmp_core.united import United


@kernel
def share_with_data(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    own: NDArray[np.int32],
    places: NDArray[np.float64],
    corners: NDArray[np.int32],
    found_triangles: NDArray[np.int32],
    found_edges: NDArray[np.int32],
    count: int,
    polygons: NDArray[np.float64],
    lines: NDArray[np.float64],
) -> float:
    """Share of a triangle of T under some triangles of T1, as `overlapped_with_data` lists them.

    The first of the polygons is the triangle itself; the next two get overwritten.
    """
    share = 0.0
    for i in range(count):
        lines_of(nodes, start, own, found_triangles[i], found_edges[i], places, corners, lines, 0)
        part, in_part = cut_by_triangle(polygons, 0, 3, lines, 0, found_edges[i], 1, 2)
        if in_part < 3:
            continue
        a, b = small_shares(polygons, part, in_part)
        for k in range(2, in_part):
            share += max(fan_share(polygons, part, k, a, b), 0.0)
    return share


@kernel
def whole_polygon(polygons: NDArray[np.float64]) -> None:
    """Make the first of the polygons the triangle of T itself."""
    for k in range(3):
        for i in range(3):
            polygons[0, k, i] = 1.0 if k == i else 0.0


@kernel
def _fill_shares(
    begin: int,
    end: int,
    places: NDArray[np.float64],
    triangles: NDArray[np.int32],
    side: OverlaySide,
    box: NDArray[np.float64],
    bed: Bed,
    near: NDArray[np.int32],
    shares: NDArray[np.float64],
) -> None:
    """Fill in triangles begin..end-1; `near` counts marked cells below and left of each corner."""
    nodes, start, twin, real = side.nodes, side.start, side.twin, side.real
    leaving, own, found, valid = side.leaving, side.own, side.found, side.valid
    found_triangles = np.empty(real, np.int32)
    found_edges = np.empty(real, np.int32)
    corners = np.empty(3, np.int32)
    lines = np.empty((1, 3, 3))
    polygons = np.empty((3, MOST_CORNERS, 3))
    whole_polygon(polygons)
    for t in range(begin, end):
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        left = min(min(places[a, 0], places[b, 0]), places[c, 0])
        right = max(max(places[a, 0], places[b, 0]), places[c, 0])
        low = min(min(places[a, 1], places[b, 1]), places[c, 1])
        high = max(max(places[a, 1], places[b, 1]), places[c, 1])
        if right <= box[0] or left >= box[1] or high <= box[2] or low >= box[3]:
            shares[t] = 0.0
            continue
        inside = True
        for k in range(3):
            v = triangles[t, k]
            if own[v] < 0 and found[v] >= real:
                inside = False
        if inside:
            r0, r1, c0, c1 = extent(bed, places, triangles, t)
            marked = (near[r1 + 1, c1 + 1] - near[r0, c1 + 1]) - (near[r1 + 1, c0] - near[r0, c0])
            if marked == 0:
                shares[t] = 1.0
                continue
        from_leftmost(places, triangles, t, corners)
        count, covers = overlapped_with_data(
            nodes,
            start,
            twin,
            real,
            leaving,
            own,
            found,
            valid,
            places,
            corners,
            found_triangles,
            found_edges,
        )
        if covers:
            shares[t] = 1.0
        else:
            shares[t] = share_with_data(
                nodes,
                start,
                own,
                places,
                corners,
                found_triangles,
                found_edges,
                count,
                polygons,
                lines,
            )


def shares_within(
    surface: LinearSurface,
    united: United,
    own: NDArray[np.int32],
    other: NDArray[np.int32],
    gaps: Gaps,
    threads: int = 1,
) -> NDArray[np.float64]:
    """Tell how much of each triangle of T lies where a surface has data, by true areas.

    Parameters
    ----------
    surface : LinearSurface
    united : United
        T, with the very same nodes.
    own, other : (n,), (n') int32
        Numbers in T of the surface's nodes and of the other grid's.
    gaps : Gaps
        What its triangles without data may touch; elsewhere in its hull there is data for sure.
    threads : int
        How many may work at once; the results do not depend on it.

    Returns
    -------
    (M,) float64
        From 0 to 1 but for rounding; exactly 1 for a triangle with data all over.
    """
    side = side_of(surface, len(united.nodes), own, other)
    low, high = side.nodes.min(axis=0), side.nodes.max(axis=0)
    box = np.array([low[0], high[0], low[1], high[1]])
    near = np.zeros((gaps.near.shape[0] + 1, gaps.near.shape[1] + 1), np.int32)
    near[1:, 1:] = gaps.near.cumsum(axis=0, dtype=np.int32).cumsum(axis=1, dtype=np.int32)
    shares = np.empty(len(united.triangles))

    def work(begin: int, end: int) -> None:
        _fill_shares(
            begin,
            end,
            united.nodes,
            united.triangles,
            side,
            box,
            gaps.bed,
            near,
            shares,
        )

    over_chunks(work, len(shares), threads)
    return shares


@kernel
def _add_products(
    areas: NDArray[np.float64], shares: NDArray[np.float64], sums: NDArray[np.float64]
) -> None:
    for t in range(len(areas)):
        if areas[t] > 0.0:
            add(sums, 0, areas[t] * shares[t])


def area_within(areas: NDArray[np.float64], shares: NDArray[np.float64]) -> float:
    """Add up the parts of triangles that `shares_within` tells of, in any order to the last bit.

    Parameters
    ----------
    areas, shares : (M,) float64

    Returns
    -------
    float
    """
    sums = np.zeros((1, 2))
    _add_products(areas, shares, sums)
    return float(sums[0, 0] + sums[0, 1])
