"""Both scans on one pyvista plotter; only what differs from what it showed last is sent."""

from __future__ import annotations

from typing import Any

import numpy as np
import pyvista
from vtkmodules.vtkRenderingCore import vtkCellPicker

from app.drawing.lights import light
from app.drawing.mesh import cells_of, new_actor, paint, points_of
from app.model.superimposition import Style
from app.scene.superimposed import Skin, Superimposed

Place = tuple[float, float, float]

CURVE_PIXELS = 3.0
POINT_PIXELS = 3.0
MARK_PIXELS = 10.0
MARKED = (212, 0, 160)
VIEWS: dict[str, tuple[Place, Place]] = {
    "front": ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0)),
    "left": ((-1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    "right": ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    "three-quarter": ((0.7, 0.0, 0.7), (0.0, 1.0, 0.0)),
    "below": ((0.0, -1.0, 0.0), (0.0, 0.0, 1.0)),
}
"""From where, and what is upwards, as one looks along the comparison's z."""


class _Coat:
    """One scan's actors: whole, and coarse for while the camera moves."""

    def __init__(self, plotter: Any) -> None:
        self._surface = pyvista.Property(interpolation="gouraud", specular=0.06, specular_power=18)
        self.whole, self._whole_data = new_actor()
        self.coarse, self._coarse_data = new_actor()
        self.curve, self._curve_data = new_actor()
        self.data = self._whole_data
        """What is pointed at."""
        for actor in (self.whole, self.coarse):
            actor.prop = self._surface
            plotter.renderer.AddActor(actor)
        self.coarse.visibility = False
        self.curve.prop.lighting = False
        self.curve.prop.line_width = CURVE_PIXELS
        plotter.renderer.AddActor(self.curve)
        self._shown: Skin | None = None
        self._curves: Any = None

    def show(self, skin: Skin) -> None:
        old = self._shown
        if old is None or skin.points is not old.points or skin.triangles is not old.triangles:
            shared, upright = points_of(skin.points), pyvista.convert_array(skin.normals)
            coarse = skin.triangles if skin.coarse is None else skin.coarse
            for data, triangles in (
                (self._whole_data, skin.triangles),
                (self._coarse_data, coarse),
            ):
                data.SetPoints(shared)
                data.faces = cells_of(np.ascontiguousarray(triangles, dtype=np.int32))
                data.GetPointData().SetNormals(upright)
                data.Modified()
            old = None
        if old is None or skin.colours is not old.colours:
            if isinstance(skin.colours, tuple):
                self._surface.color = skin.colours
                self.whole.mapper.scalar_visibility = False
            else:
                paint(self.whole, self._whole_data, skin.colours)
        self._surface.opacity = skin.opacity
        self._surface.style = {
            Style.SOLID: "surface",
            Style.WIRE: "wireframe",
            Style.POINTS: "points",
        }[skin.style]
        self._surface.point_size = POINT_PIXELS
        self._surface.lighting = skin.style is Style.SOLID
        self.whole.visibility = skin.opacity > 0.0
        self._shown = skin

    def show_curve(self, curve: Any, colour: Any) -> None:
        self.curve.visibility = len(curve) > 0
        if len(curve) and curve is not self._curves:
            ends = np.ascontiguousarray(curve.reshape(-1, 3), dtype=np.float32)
            self._curve_data.SetPoints(points_of(ends))
            self._curve_data.lines = cells_of(np.arange(len(ends), dtype=np.int32).reshape(-1, 2))
            self._curve_data.Modified()
        self._curves = curve
        self.curve.prop.color = colour

    def sketch(self, moving: bool) -> None:
        shown = self._shown
        visible = shown is not None and shown.opacity > 0.0
        large = shown is not None and shown.coarse is not None
        self.coarse.visibility = visible and large and moving
        self.whole.visibility = visible and not (large and moving)


class SuperimposedScene:
    """Shows both scans on a plotter, which lives and dies with its owner.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        A `pyvista.Plotter` off the screen, or a `pyvistaqt.QtInteractor` on it.
    """

    def __init__(self, plotter: Any) -> None:
        self._plotter = plotter
        plotter.renderer.RemoveAllLights()
        light(plotter.renderer)
        self.coats = _Coat(plotter), _Coat(plotter)
        self._marks, self._mark_data = new_actor()
        self._marks.prop.lighting = False
        self._marks.prop.line_width = CURVE_PIXELS
        self._marks.prop.point_size = MARK_PIXELS
        self._marks.prop.render_points_as_spheres = True
        self._marks.prop.color = MARKED
        plotter.renderer.AddActor(self._marks)
        plotter.enable_depth_peeling(4)
        self._plane: tuple[int, float] | None = None

    def show(self, scene: Superimposed) -> None:
        """Show a scene; the camera stays."""
        self._plotter.renderer.background_color = scene.background
        for coat, skin, curve, colour in zip(
            self.coats, scene.skins, scene.curves, scene.curve_colours, strict=True
        ):
            coat.show(skin)
            coat.show_curve(curve, colour)
        if scene.plane != self._plane:
            self._cut(scene.plane)
        self._plotter.camera.parallel_projection = not scene.perspective

    def _cut(self, plane: tuple[int, float] | None) -> None:
        """Draw what lies below a plane, or all."""
        self._plane = plane
        for coat in self.coats:
            for actor in (coat.whole, coat.coarse):
                actor.mapper.RemoveAllClippingPlanes()
                if plane is not None:
                    axis, place = plane
                    normal, origin = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
                    normal[axis], origin[axis] = -1.0, place
                    actor.mapper.AddClippingPlane(pyvista.generate_plane(normal, origin))

    def look(self, view: str) -> None:
        """Look from one of `VIEWS` at everything."""
        back, up = VIEWS[view]
        camera = self._plotter.camera
        camera.focal_point = (0.0, 0.0, 0.0)
        camera.position = back
        camera.up = up
        self._plotter.renderer.ResetCamera()

    def sketch(self, moving: bool) -> None:
        """Draw coarse likenesses of large scans, for as long as the camera moves."""
        for coat in self.coats:
            coat.sketch(moving)

    def mark(self, places: list[Place]) -> None:
        """Mark places, and the way from each to the next."""
        self._marks.visibility = bool(places)
        if places:
            numbers = np.arange(len(places), dtype=np.int32)
            self._mark_data.SetPoints(points_of(np.array(places, dtype=np.float32)))
            self._mark_data.verts = cells_of(numbers.reshape(-1, 1))
            self._mark_data.lines = cells_of(np.stack([numbers[:-1], numbers[1:]], axis=1))
            self._mark_data.Modified()

    def pick(self, right: float, up: float) -> tuple[int, int, Place] | None:
        """Return surface, triangle and place at a pixel from the lower left corner, if any."""
        picker = vtkCellPicker()
        picker.PickFromListOn()
        for coat in self.coats:
            if coat.whole.visibility:
                picker.AddPickList(coat.whole)
        if not picker.Pick(right, up, 0.0, self._plotter.renderer):
            return None
        surface = next(k for k, coat in enumerate(self.coats) if coat.whole is picker.GetActor())
        x, y, z = picker.GetPickPosition()
        return surface, int(picker.GetCellId()), (x, y, z)

    def nearest(self, surface: int, place: Place) -> Place:
        """Return the place on a scan that is nearest to one in the scene."""
        data = self.coats[surface].data
        found: Any = data.find_closest_cell(place, return_closest_point=True)
        x, y, z = found[1].tolist()
        return x, y, z
