"""The same comparison put together by hand from SciPy and numpy, as the peer to beat."""

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import LinearNDInterpolator
from scipy.spatial import Delaunay

from surfcmp_core.grid.curve import curve_keys
from surfcmp_core.surface import Surface


def _along_curve(nodes: NDArray[np.float64]) -> NDArray[np.int64]:
    return np.argsort(curve_keys(nodes, (0.0, 0.0, 1.0, 1.0)))


def mean_abs(first: Surface, second: Surface) -> float:
    """Return the area-weighted mean |d| over the triangles of both hulls."""
    grids = [s.points[_along_curve(s.points[:, :2])] for s in (first, second)]
    triangulations = [Delaunay(grid[:, :2]) for grid in grids]
    both = np.concatenate(grids)
    both = both[_along_curve(both[:, :2])][:, :2]
    united = Delaunay(both)
    values = [
        LinearNDInterpolator(triangulation, grid[:, 2])(both)
        for triangulation, grid in zip(triangulations, grids, strict=True)
    ]
    d = (values[0] - values[1])[united.simplices]
    a, b, c = (both[united.simplices[:, i]] for i in range(3))
    u, v = b - a, c - a
    area = np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2.0
    inside = ~np.isnan(d).any(axis=1)
    d, area = d[inside], area[inside]
    low, middle, high = np.sort(d, axis=1).T
    total = d.mean(axis=1)
    with np.errstate(invalid="ignore", divide="ignore"):
        tip = np.where(middle > 0.0, low, high)
        other = np.where(middle > 0.0, high, low)
        share = tip * tip / ((tip - middle) * (tip - other))
        split = np.abs(total - 2.0 * share * tip / 3.0)
    volume = area * np.where(low * high < 0.0, split, np.abs(total))
    return float(volume.sum() / area.sum())
