"""Small comparisons for tests of the scene."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core import Comparison, Surface, compare

MAX_EDGE = 25.0
"""Longer than any side between `hills`' neighbours but those of the hull."""


def comparison_of(
    one: NDArray[np.float64], two: NDArray[np.float64], *, hole: float = 0.0
) -> Comparison:
    """Compare two clouds (n, 3); surface 2 has no data within `hole` of the middle of one."""
    away = np.hypot(*(two[:, :2] - one[:, :2].mean(axis=0)).T) >= hole
    surfaces = [
        Surface(points=points, name=name, unit="mm")
        for points, name in ((one, "one.xyz"), (two[away], "two.xyz"))
    ]
    return compare(surfaces[0], surfaces[1], max_edge=MAX_EDGE, threads=1)


def hills(count: int, seed: int, lift: float = 0.0) -> NDArray[np.float64]:
    """Return (count, 3) nodes on a smooth hilly surface over [-50, 50]²."""
    xy = np.random.default_rng(seed).uniform(-50, 50, (count, 2))
    z = 8 * np.sin(xy[:, 0] / 15) * np.cos(xy[:, 1] / 12)
    return np.column_stack([xy, z + lift * np.exp(-((xy - 20) ** 2).sum(axis=1) / 200)])
