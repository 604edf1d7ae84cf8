"""Values that stand for "nothing was measured here": found, and on request left out."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.io.raw import Raw

_USUAL = np.array(
    (
        *(sign * (10**digits - 1) for digits in range(3, 7) for sign in (-1, 1)),
        *(-32768, -32767, 32767, 65535, -2147483648, 2147483647, -999.25),
    )
)
"""What rasters, surveys and logs write for it (ESRI, GDAL, Surfer, 16 and 32 bits)."""
_HUGE = 1e30
"""So does what is larger: the extremes of floating point, Surfer's 1.70141e38, netCDF's 9.97e36."""
_NEAR = 1e-6
"""Two values as near as this, in share of their size, are one: files round decimals."""
_APART = 0.1
"""So far, in share of its size, such a value must at least be from all others to be suspected."""


def marked(raw: Raw, no_data: Sequence[float] = ()) -> Raw:
    """Leave out nodes without data, and count those that may have none.

    Parameters
    ----------
    raw : Raw
    no_data : sequence of float
        Values of x, y or z that mean it, in the file's unit; NaN means all that is not finite.

    Returns
    -------
    Raw
        With `dropped` counting the nodes left out, `changed` the faces at them, and what
        :func:`suspected` finds among the others.
    """
    points = np.ascontiguousarray(raw.points, np.float64)
    dropped, gone = dict(raw.dropped), np.zeros(len(points), np.bool_)
    for value in no_data:
        same = _same(points, value).any(axis=1) & ~gone
        if count := int(same.sum()):
            dropped[f"no data ({value:.9g})"] = count
        gone |= same
    changed = dict(raw.changed)
    polygons = raw.polygons
    if gone.any():
        points = points[~gone]
        polygons, lost = _without(polygons, gone)
        if lost:
            changed["faces at nodes without data, left out"] = lost
    changed |= suspected(points)
    return replace(raw, points=points, polygons=polygons, dropped=dropped, changed=changed)


def suspected(points: NDArray[np.float64]) -> dict[str, int]:
    """Count nodes with a value that usually means "no data", far from all others.

    Parameters
    ----------
    points : (n, 3) float64

    Returns
    -------
    dict of str to int
        Nodes by what is to be told of them. A value counts where it is the least or the greatest
        of its axis, and farther from the others than 98 % of them from each other: depths of a mine
        around −9999 do not.
    """
    places: dict[float, list[str]] = {}
    with np.errstate(all="ignore"):
        for axis, values in zip("xyz", points.T, strict=True):
            ends = np.array([values.min(), values.max()]) if len(values) else values
            if not _usual(ends).any():
                continue
            usual = _usual(values)
            others = values[~usual & np.isfinite(values)]
            if not len(others):
                continue
            low, high = np.quantile(others, (0.01, 0.99))
            for value in np.unique(values[usual]).tolist():
                gap = np.abs(others - value).min()
                if gap > max(high - low, _APART * abs(value)):
                    places.setdefault(value, []).append(axis)
    return {
        f"nodes with {', '.join(axes)} = {value:.9g}, which often means that nothing was measured"
        f" (--no-data {value:.9g} leaves them out)": int(
            np.any([points[:, "xyz".index(axis)] == value for axis in axes], axis=0).sum()
        )
        for value, axes in places.items()
    }


def _usual(values: NDArray[np.float64]) -> NDArray[np.bool_]:
    found = np.abs(values) >= _HUGE
    for value in _USUAL:
        found |= _same(values, float(value))
    return found & np.isfinite(values)


def _same(values: NDArray[np.float64], value: float) -> NDArray[np.bool_]:
    if np.isnan(value):
        return ~np.isfinite(values)
    return np.asarray((values == value) | (np.abs(values - value) <= _NEAR * abs(value)))


def _without(
    polygons: Sequence[NDArray[np.integer]], gone: NDArray[np.bool_]
) -> tuple[list[NDArray[np.integer]], int]:
    """Leave out polygons at nodes that are gone, and number the others anew.

    Polygons with numbers that are no node's stay what they are: who reads them on refuses them.
    """
    number = np.cumsum(~gone) - 1
    kept: list[NDArray[np.integer]] = []
    lost = 0
    for group in polygons:
        known = (group >= 0) & (group < len(gone))
        inside = np.where(known, group, 0)
        whole = ~(gone[inside] & known).any(axis=1) | ~known.all(axis=1)
        lost += int((~whole).sum())
        kept.append(np.where(known, number[inside], group)[whole])
    return kept, lost
