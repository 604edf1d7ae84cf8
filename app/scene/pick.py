"""What lies under the pointer, and its values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.model.view_state import Place
from app.scene.camera import Camera
from app.scene.geometry import Geometry, Patch

if TYPE_CHECKING:
    from surfcmp_core.comparison import Comparison


def place_at(patch: Patch, camera: Camera, relief: bool, right: float, up: float) -> Place | None:
    """Return the nearest place of `patch` seen at a point of the picture, or None.

    Parameters
    ----------
    right, up : float
        In shares of the picture's height from its middle, as `Camera.project` gives.
    """
    points = patch.points.astype(np.float64)
    if not relief:
        points[:, 2] = 0.0
    seen = camera.project(points)
    x, y = seen[:, 0] - right, seen[:, 1] - up
    code = np.zeros(len(x), dtype=np.uint8)  # a triangle that hits has nodes on all four sides
    for bit, side in enumerate((x <= 0, x >= 0, y <= 0, y >= 0)):
        code |= side.view(np.uint8) << np.uint8(bit)
    a, b, c = patch.triangles.T
    found = np.flatnonzero((code[a] | code[b] | code[c]) == 15)
    a, b, c = patch.triangles[found].T
    weights = np.stack(
        [x[b] * y[c] - x[c] * y[b], x[c] * y[a] - x[a] * y[c], x[a] * y[b] - x[b] * y[a]]
    )
    total = weights.sum(axis=0)
    hit = (total != 0) & ((weights * np.sign(total)) >= 0).all(axis=0)
    if not hit.any():
        return None
    shares = weights[:, hit] / total[hit]
    depth = np.stack([seen[a, 2], seen[b, 2], seen[c, 2]])[:, hit]
    nearest = int(np.argmax((shares * depth).sum(axis=0)))
    first, second, third = (float(share) for share in shares[:, nearest])
    return Place(int(found[hit][nearest]), (first, second, third))


@dataclass(frozen=True, slots=True)
class Reading:
    """Values at a place; heights are linear on the triangle, NaN without data."""

    x: float
    y: float
    z1: float
    z2: float
    mean_signed: float
    """Of the whole triangle, as its colour shows."""

    @property
    def difference(self) -> float:
        """D = z1 - z2 at the place."""
        return self.z1 - self.z2


def reading_at(comparison: Comparison, place: Place) -> Reading:
    """Return the values at a place of T."""
    nodes = comparison.united.triangles[place.triangle]
    weights = np.array(place.weights)
    x, y = weights @ comparison.united.nodes[nodes]
    return Reading(
        x=float(x),
        y=float(y),
        z1=float(weights @ comparison.z1[nodes]),
        z2=float(weights @ comparison.z2[nodes]),
        mean_signed=float(comparison.mean_signed[place.triangle]),
    )


def point_at(geometry: Geometry, place: Place, relief: bool) -> NDArray[np.float64]:
    """Return (3,) where a place of T is drawn, in the scene's coordinates."""
    patch = geometry.patches[2]
    corners = patch.points[patch.triangles[place.triangle]].astype(np.float64)
    point = np.array(place.weights) @ corners
    if not relief:
        point[2] = 0.0
    return np.asarray(point)
