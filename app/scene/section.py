"""The profile of both surfaces along a line in the plane."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from surfcmp_core.comparison import Comparison

Floats = NDArray[np.float64]
Line = tuple[float, float, float, float]
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


@lru_cache(maxsize=2)
def profile_of(comparison: Comparison, line: Line) -> Profile:
    """Return the profile along a line; empty where it does not meet T."""
    start, end = np.array(line[:2]), np.array(line[2:])
    length = float(np.hypot(*(end - start)))
    if length == 0:
        empty = np.zeros(0)
        return Profile(empty, empty, empty)
    towards = (end - start) / length
    relative = comparison.united.nodes - start
    along = relative @ towards
    beside = relative @ np.array([-towards[1], towards[0]])
    left = beside > 0
    triangles = comparison.united.triangles
    a, b = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    cut = left[a] != left[b]
    a, b = a[cut], b[cut]
    share = beside[a] / (beside[a] - beside[b])
    places = along[a] + share * (along[b] - along[a])
    inside = (places >= 0) & (places <= length)
    a, b, share, places = a[inside], b[inside], share[inside], places[inside]
    places, first = np.unique(places, return_index=True)
    a, b, share = a[first], b[first], share[first]
    z1, z2 = ((1 - share) * z[a] + share * z[b] for z in (comparison.z1, comparison.z2))
    return Profile(places, z1, z2)
