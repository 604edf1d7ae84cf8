"""Measures of regions: they add up to the whole, because triangle values do."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.model.region import Region
from surfcmp_core.measures import measure

if TYPE_CHECKING:
    from surfcmp_core.comparing.comparison import Comparison
    from surfcmp_core.measures.measures import Measures
    from surfcmp_core.united import United


Covers = Callable[[NDArray[np.float64], NDArray[np.float64]], NDArray[np.bool_]]
"""From x and y (n,) to which of the points are covered."""


@dataclass(frozen=True, slots=True, eq=False)
class RegionMeasures:
    """What was measured over one region.

    `region` is None for all triangles outside every region; `measures` is None where none of the
    region's triangles is compared.
    """

    region: Region | None
    triangles: int
    measures: Measures | None


def region_of(comparison: Comparison, regions: tuple[Region, ...]) -> NDArray[np.int32]:
    """Return (M,) the number of each triangle's region, by its centroid; -1 for none."""
    x, y = centroids(comparison.united)
    number = np.full(len(x), -1, dtype=np.int32)
    for k, region in enumerate(regions):
        number[region_mask(x, y, region)] = k
    return number


def centroids(united: United) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return x and y (M,) of the middle of each triangle."""
    a, b, c = united.triangles.T
    x, y = np.ascontiguousarray(united.nodes.T)
    return (x[a] + x[b] + x[c]) / 3, (y[a] + y[b] + y[c]) / 3


def region_mask(
    x: NDArray[np.float64], y: NDArray[np.float64], region: Region
) -> NDArray[np.bool_]:
    """Return which points lie in a region."""
    mask = np.zeros(len(x), dtype=bool)
    for stroke in region.strokes:
        path = np.array(stroke.path, dtype=np.float64)
        low, high = path.min(axis=0) - stroke.radius, path.max(axis=0) + stroke.radius
        near = np.flatnonzero((x >= low[0]) & (x <= high[0]) & (y >= low[1]) & (y <= high[1]))
        covers = beside(path, stroke.radius) if stroke.radius > 0 else inside(path)
        mask[near[covers(x[near], y[near])]] = not stroke.takes
    return mask


def inside(path: NDArray[np.float64]) -> Covers:
    """Return what says which points lie inside a polygon (even-odd rule)."""

    def covers(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.bool_]:
        found = np.zeros(len(x), dtype=bool)
        for (x0, y0), (x1, y1) in zip(path, np.roll(path, -1, axis=0), strict=True):
            if y0 != y1:
                crosses = (y0 <= y) != (y1 <= y)
                found ^= crosses & (x < x0 + (y - y0) * (x1 - x0) / (y1 - y0))
        return found

    return covers


def beside(path: NDArray[np.float64], radius: float) -> Covers:
    """Return what says which points lie within a radius of a path."""

    def covers(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.bool_]:
        found = np.zeros(len(x), dtype=bool)
        for (x0, y0), (x1, y1) in zip(path, path[1:] if len(path) > 1 else path, strict=False):
            dx, dy = x1 - x0, y1 - y0
            length = dx * dx + dy * dy
            along = ((x - x0) * dx + (y - y0) * dy) / length if length > 0 else np.zeros(len(x))
            along = np.clip(along, 0.0, 1.0)
            found |= (x - x0 - along * dx) ** 2 + (y - y0 - along * dy) ** 2 <= radius * radius
        return found

    return covers


def measured_regions(
    comparison: Comparison, regions: tuple[Region, ...], number: NDArray[np.int32]
) -> tuple[RegionMeasures, ...]:
    """Return the measures of each region, and of the rest last; nothing without regions.

    `number` is what `region_of` gives.
    """
    if not regions:
        return ()
    found = []
    for k, region in enumerate((*regions, None)):
        mine = comparison.compared & (number == (k if region is not None else -1))
        measures = _measure(comparison, mine) if mine.any() else None
        found.append(RegionMeasures(region, int(mine.sum()), measures))
    return tuple(found)


def weighted(
    comparison: Comparison, regions: tuple[Region, ...], number: NDArray[np.int32]
) -> Comparison:
    """Return the comparison with ρ_V measured under the regions' weights µ, 1 elsewhere."""
    if all(region.weight == 1.0 for region in regions):
        return comparison
    weights = np.array([*(region.weight for region in regions), 1.0])
    measures = _measure(comparison, comparison.compared, weights[number])
    return replace(comparison, measures=replace(measures, exact=comparison.measures.exact))


def with_tolerances(comparison: Comparison, tolerances: tuple[float, ...]) -> Comparison:
    """Return the comparison measured with other tolerances (nodal reading)."""
    comparison = replace(comparison, options=replace(comparison.options, tolerances=tolerances))
    return replace(comparison, measures=_measure(comparison, comparison.compared))


def _measure(
    comparison: Comparison,
    mine: NDArray[np.bool_],
    triangle_weight: NDArray[np.float64] | None = None,
) -> Measures:

    whole, united = comparison.measures, comparison.united
    return measure(
        united.nodes,
        united.label,
        united.triangles,
        comparison.z1,
        comparison.z2,
        mine,
        tolerances=comparison.options.tolerances,
        node_weight=comparison.weight,
        triangle_weight=triangle_weight,
        footprint_1=comparison.footprints[0],
        footprint_2=comparison.footprints[1],
        hausdorff=(whole.hausdorff_1_2, whole.hausdorff_2_1),
    )[1]
