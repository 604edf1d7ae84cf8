"""Surfaces to measure with: uniform random nodes of a smooth function with a little noise."""

import numpy as np

from surfcmp_core.surface import Surface


def uniform_surface(count: int, seed: int) -> Surface:
    """Return a cloud of `count` nodes over the unit square."""
    rng = np.random.default_rng(seed)
    points = rng.random((count, 3))
    points[:, 2] = np.sin(6.0 * points[:, 0]) * np.cos(5.0 * points[:, 1]) + 0.01 * points[:, 2]
    return Surface(points, name=f"uniform {seed}", unit="mm")
