"""What lies under the pointer, and its values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.model.view_state import Place
from app.scene.camera import Camera, Vector
from app.scene.content import Content
from app.scene.geometry import RUN, Geometry, Patch

if TYPE_CHECKING:
    from surfcmp_core.comparing.comparison import Comparison


Shadows = tuple[Vector, Vector]
"""Middles and half the sizes (k, 2) of a patch's boxes as a camera sees them."""

SIDEWAYS = 0.2
"""Where the line of sight rises less than this, it meets a level too far away."""


def place_at(
    patch: Patch,
    camera: Camera,
    relief: bool,
    right: float,
    up: float,
    shadows: Shadows | None = None,
) -> Place | None:
    """Return the nearest place of `patch` seen at a point of the picture, or None.

    Parameters
    ----------
    right, up : float
        In shares of the picture's height from its middle, as `Camera.project` gives.
    shadows
        Of the patch, as this camera sees it, where they are known.
    """
    lift = np.array([1.0, 1.0, float(relief)])
    shadows = shadows or shadows_of(patch, camera, relief)
    found = np.arange(len(patch.triangles))
    if shadows is not None:
        found = numbers_in(patch, (np.abs(shadows[0] - (right, up)) <= shadows[1]).all(axis=1))
    seen = camera.project(patch.points[patch.triangles[found].ravel()].astype(np.float64) * lift)
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


def numbers_in(patch: Patch, boxes: NDArray[np.bool_]) -> NDArray[np.intp]:
    """Return the triangles of some of a patch's boxes."""
    runs = np.flatnonzero(boxes)[:, None] * RUN + np.arange(RUN)
    return runs[runs < len(patch.triangles)]


def shadows_of(patch: Patch, camera: Camera, relief: bool) -> Shadows | None:
    """Return where the camera sees a patch's boxes; None where it has none."""
    if patch.boxes is None:
        return None
    lift = np.array([1.0, 1.0, float(relief)])
    low, high = patch.boxes[:, 0].astype(np.float64), patch.boxes[:, 1].astype(np.float64)
    middle, half = (low + high) / 2 * lift, (high - low) / 2 * lift
    axes = np.stack([camera.right, np.array(camera.up)], axis=1) / camera.height
    room = 1e-9 * (float(np.abs(patch.boxes).max()) / camera.height + 1.0)  # for rounding
    return (middle - camera.focus) @ axes, half @ np.abs(axes) + room


def place_in_view(
    geometry: Geometry, camera: Camera, relief: bool, view: int, right: float, up: float
) -> Place | None:
    """Return the place of T at a point of a view's picture; None beside the surface it shows."""
    united = geometry.patches[2]
    if view > 1 or not relief:
        return place_at(united, camera, relief, right, up)
    point = point_in_view(geometry, camera, relief, view, right, up)
    if point is None:
        return None
    above = Camera(focus=(float(point[0]), float(point[1]), 0.0))
    return place_at(united, above, False, 0.0, 0.0)


def point_in_view(
    geometry: Geometry,
    camera: Camera,
    relief: bool,
    view: int,
    right: float,
    up: float,
    shadows: Shadows | None = None,
) -> Vector | None:
    """Return (3,) the point of the surface a view shows, in the scene's coordinates, or None."""
    patch = geometry.patches[min(view, 2)]
    place = place_at(patch, camera, relief, right, up, shadows)
    if place is None:
        return None
    corners = patch.points[patch.triangles[place.triangle]].astype(np.float64)
    return _mixed(np.array(place.weights), corners)


def path_in_view(
    geometry: Geometry,
    camera: Camera,
    relief: bool,
    view: int,
    path: Sequence[tuple[float, float]],
) -> list[tuple[float, float]]:
    """Return where a path drawn over a view's picture runs in the plane of comparison.

    Beside the surface it runs on the level of the surface's point before, or of the first one. A
    relief seen from its side has no such level there: those places are left out.
    """
    points: list[Vector | None] = [None] * len(path)
    if relief:
        shadows = shadows_of(geometry.patches[min(view, 2)], camera, relief)
        points = [point_in_view(geometry, camera, relief, view, *place, shadows) for place in path]
    heights = [point[2] for point in points if point is not None]
    level = float(heights[0]) if heights else 0.0
    back, found = np.array(camera.back), []
    for point, (right, up) in zip(points, path, strict=True):
        if point is None and abs(back[2]) > SIDEWAYS:
            start = camera.at(right, up)
            point = start + (level - start[2]) / back[2] * back
        if point is not None:
            level = float(point[2])
            x, y = (point + geometry.origin)[:2].tolist()
            found.append((x, y))
    return found


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
    x, y = _mixed(weights, comparison.united.nodes[nodes])
    return Reading(
        x=float(x),
        y=float(y),
        z1=float(_mixed(weights, comparison.z1[nodes])),
        z2=float(_mixed(weights, comparison.z2[nodes])),
        mean_signed=float(comparison.mean_signed[place.triangle]),
    )


def heights_at(
    comparison: Comparison, geometry: Geometry, nodes: NDArray[np.int32], view: int
) -> Vector:
    """Return the scene's heights at nodes of T as a view draws them.

    Of surface 1 or 2 where the view shows it and it has data there, else half way between both.
    """
    middle: Vector = geometry.patches[2].points[nodes, 2].astype(np.float64)
    if view > 1:
        return middle
    own = (comparison.z1, comparison.z2)[view][nodes] - geometry.origin[2]
    return np.asarray(np.where(np.isnan(own), middle, own))


def corners_at(content: Content, place: Place, relief: bool, view: int) -> Vector:
    """Return (3, 3) the corners of a place's triangle where a view draws them."""
    geometry = content.geometry
    patch = geometry.patches[2]
    nodes = patch.triangles[place.triangle]
    corners: Vector = patch.points[nodes].astype(np.float64)
    corners[:, 2] = relief * heights_at(content.comparison, geometry, nodes, view)
    return corners


def point_at(content: Content, place: Place, relief: bool, view: int) -> Vector:
    """Return (3,) where a view draws a place of T, in the scene's coordinates."""
    return _mixed(np.array(place.weights), corners_at(content, place, relief, view))


def _mixed(weights: NDArray[np.float64], values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give the weighed sum of three values, or of three rows, the same on every processor."""
    return np.asarray((weights * values.T).sum(axis=-1))
