"""A hilly landscape with a valley as a height field in metres."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

SIZE = (1200.0, 900.0)
"""Extent in x and y, from (0, 0)."""


def valley(x: Array) -> Array:
    """Give the y of the valley's bottom."""
    return np.asarray(380 + 90 * np.sin(x / 190 + 0.6) + 40 * np.sin(x / 83))


def terrain(x: Array, y: Array) -> Array:
    """Height before any digging, in m."""
    rng = np.random.default_rng(7)
    z = 420 + 0.02 * x + 0.03 * y
    for _ in range(45):
        cx, cy = rng.uniform(-100, SIZE[0] + 100), rng.uniform(-100, SIZE[1] + 100)
        width, height = rng.uniform(70, 190), rng.uniform(-9, 22)
        z = z + height * np.exp(-((x - cx) ** 2 + (y - cy) ** 2) / width**2)
    across = (y - valley(x)) / 75
    return np.asarray(z - 38 / (1 + across**2))


def inside(x: Array, y: Array, lakes: tuple[tuple[float, float, float], ...]) -> NDArray[np.bool_]:
    """In the extent and on dry land; a lake is (x, y, radius), with a wavy shore."""
    dry = (x >= 0) & (x <= SIZE[0]) & (y >= 0) & (y <= SIZE[1])
    for cx, cy, radius in lakes:
        theta = np.arctan2(y - cy, x - cx)
        shore = radius * (1 + 0.18 * np.cos(2 * theta + cx) + 0.10 * np.cos(3 * theta + cy))
        dry &= np.hypot(x - cx, y - cy) > shore
    return dry
