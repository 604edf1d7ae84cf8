"""The profile of both surfaces along a line in the plane."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.scene.pick import numbers_in

if TYPE_CHECKING:
    from app.scene.geometry import Geometry
    from surfcmp_core.comparing.comparison import Comparison

Floats = NDArray[np.float64]
Ends = tuple[float, float, float, float]
"""x, y of the start, x, y of the end."""


@dataclass(frozen=True, slots=True, eq=False)
class Profile:
    """Heights where the line crosses the sides of T, and at its ends; linear in between.

    Attributes
    ----------
    along : (k,) float64
        Distance from the start, ascending.
    z1, z2 : (k,) float64
        NaN without data.
    """

    along: Floats
    z1: Floats
    z2: Floats

    @property
    def difference(self) -> Floats:
        """(k,) d = z1 - z2."""
        return self.z1 - self.z2


def profile_of(comparison: Comparison, line: Ends, geometry: Geometry | None = None) -> Profile:
    """Return the profile along a line; empty where it does not meet T.

    With the scene's geometry only triangles near the line are looked at.
    """
    start, end = np.array(line[:2]), np.array(line[2:])
    length = math.sqrt(np.square(end - start).sum())
    if length == 0:
        empty = np.zeros(0)
        return Profile(empty, empty, empty)
    towards = (end - start) / length
    united = comparison.united
    triangles = united.triangles
    if geometry is not None:
        triangles = triangles[_near(geometry, start, towards)]
    a, b = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    (along_a, beside_a), (along_b, beside_b) = (
        _in_line(united.nodes[ends] - start, towards) for ends in (a, b)
    )
    cut = (beside_a > 0) != (beside_b > 0)
    a, b, beside_a, beside_b = a[cut], b[cut], beside_a[cut], beside_b[cut]
    share = beside_a / (beside_a - beside_b)
    places = along_a[cut] + share * (along_b[cut] - along_a[cut])
    inside = (places >= 0) & (places <= length)
    a, b, share, places = a[inside], b[inside], share[inside], places[inside]
    places, first = np.unique(places, return_index=True)
    a, b, share = a[first], b[first], share[first]
    z1, z2 = ((1 - share) * z[a] + share * z[b] for z in (comparison.z1, comparison.z2))
    return Profile(places, z1, z2)


def _in_line(points: Floats, towards: Floats) -> tuple[Floats, Floats]:
    """Return how far points (k, 2) lie along a direction, and to its left.

    Each by itself: equal nodes give equal numbers.
    """
    x, y = points[:, 0], points[:, 1]
    return x * towards[0] + y * towards[1], y * towards[0] - x * towards[1]


def _near(geometry: Geometry, start: Floats, towards: Floats) -> NDArray[np.intp]:
    """Return the triangles of T whose boxes a line meets."""
    patch = geometry.patches[2]
    if patch.boxes is None:
        return np.arange(len(patch.triangles))
    low, high = (patch.boxes[:, k, :2].astype(np.float64) for k in range(2))
    middle, half = (low + high) / 2 + geometry.origin[:2] - start, (high - low) / 2
    _, away = _in_line(middle, towards)
    room = 1e-6 * float(np.abs(patch.boxes).max())  # for single precision
    reach = half @ np.abs([towards[1], towards[0]]) + room
    return numbers_in(patch, np.abs(away) <= reach)
