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


ROOM = np.float32(1e-5)
"""Shares of the picture's height that single precision may be off."""


def place_at(patch: Patch, camera: Camera, relief: bool, right: float, up: float) -> Place | None:
    """Return the nearest place of `patch` seen at a point of the picture, or None.

    Parameters
    ----------
    right, up : float
        In shares of the picture's height from its middle, as `Camera.project` gives.
    """
    lift = np.array([1.0, 1.0, float(relief)])
    x, y = (
        patch.points @ (np.array(axis) * lift / camera.height).astype(np.float32)
        - np.float32(np.dot(axis, camera.focus) / camera.height + place)
        for axis, place in ((camera.right, right), (camera.up, up))
    )
    code = np.zeros(len(x), dtype=np.uint8)  # a triangle that hits has nodes on all four sides
    for bit, side in enumerate((x <= ROOM, x >= -ROOM, y <= ROOM, y >= -ROOM)):
        code |= side.view(np.uint8) << np.uint8(bit)
    a, b, c = patch.triangles.T
    found = np.flatnonzero((code[a] | code[b] | code[c]) == 15)
    nodes = patch.triangles[found]
    seen = camera.project(patch.points[nodes.ravel()].astype(np.float64) * lift)
    x, y, depth = seen.T.reshape(3, -1, 3).transpose(0, 2, 1)
    x, y = x - right, y - up
    weights = np.stack(
        [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]
    )
    total = weights.sum(axis=0)
    hit = (total != 0) & ((weights * np.sign(total)) >= 0).all(axis=0)
    if not hit.any():
        return None
    shares = weights[:, hit] / total[hit]
    nearest = int(np.argmax((shares * depth[:, hit]).sum(axis=0)))
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


def corners_at(geometry: Geometry, place: Place, relief: bool) -> NDArray[np.float64]:
    """Return (3, 3) the corners of a place's triangle, in the scene's coordinates."""
    patch = geometry.patches[2]
    corners = patch.points[patch.triangles[place.triangle]].astype(np.float64)
    return np.asarray(corners * np.array([1.0, 1.0, float(relief)]))
