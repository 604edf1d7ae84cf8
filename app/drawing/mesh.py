"""One mesh on the screen; only what differs from what it showed last is sent."""

from typing import Any

import numpy as np
import pyvista
from numpy.typing import NDArray

from app.scene.coarse import Coarse
from app.scene.geometry import Patch
from surfcmp_core.colours.maps import Colours, Rgb

PART = 1 << 17
"""Triangles drawn in one go."""
FLAT = np.array([1, 1, 0], dtype=np.float32)


class Mesh:
    """A patch, or its coarse likeness, on the screen.

    Large ones are drawn in parts, so that drawing can be given up between them.
    """

    def __init__(self, renderer: pyvista.Renderer, surface: pyvista.Property) -> None:
        self._renderer, self._surface = renderer, surface
        self._parts: list[tuple[pyvista.Actor, pyvista.PolyData]] = []
        self.points = np.zeros((0, 3), np.float32)
        """Where its nodes are drawn."""
        self.box = np.zeros((2, 3))
        """Lowest and highest coordinates of its nodes, as they are drawn."""
        self._patch: Patch | None = None
        self._relief: bool | None = None
        self._colours: Colours | Rgb | None = None

    def show(
        self, patch: Patch, coarse: Coarse | None, relief: bool, colours: Colours | Rgb
    ) -> None:
        """Show a patch, or where `coarse` is given its coarse likeness."""
        fresh = patch is not self._patch
        triangles = patch.triangles if coarse is None else coarse.triangles
        if fresh:
            self.clear()
            for begin in range(0, len(triangles), PART):
                actor, data = new_actor()
                actor.prop = self._surface
                data.faces = cells_of(triangles[begin : begin + PART])
                self._renderer.AddActor(actor)
                self._parts.append((actor, data))
        if fresh or relief != self._relief:
            points, normals = patch.points, patch.normals
            if coarse is not None:
                points, normals = points[coarse.nodes], normals[coarse.nodes]
            if not relief:
                points = points * FLAT
            self.box = np.stack([points.min(axis=0), points.max(axis=0)]).astype(np.float64)
            self.points = points
            shared, upright = points_of(points), pyvista.convert_array(normals)
            for _, data in self._parts:  # which share both
                data.SetPoints(shared)
                data.GetPointData().SetNormals(upright)
                data.Modified()
        if fresh or colours is not self._colours:
            self._paint(colours)
        self._patch, self._relief, self._colours = patch, relief, colours

    def _paint(self, colours: Colours | Rgb) -> None:
        if isinstance(colours, tuple):
            self._surface.color = colours
        for k, (actor, data) in enumerate(self._parts):
            if isinstance(colours, tuple):
                actor.mapper.scalar_visibility = False
            else:
                paint(actor, data, colours[k * PART : (k + 1) * PART])

    def set_visible(self, visible: bool) -> None:
        """Show or hide it."""
        for actor, _ in self._parts:
            actor.visibility = visible

    def clear(self) -> None:
        """Show nothing, and let go of what was shown."""
        for actor, _ in self._parts:
            self._renderer.RemoveActor(actor)
            actor.ReleaseGraphicsResources(self._renderer.GetRenderWindow())
        self._parts.clear()
        self._patch = self._relief = self._colours = None


def new_actor() -> tuple[pyvista.Actor, pyvista.PolyData]:
    """Return an actor and the data it draws."""
    data = pyvista.PolyData()
    actor = pyvista.Actor(pyvista.DataSetMapper(data))
    return actor, data


def paint(actor: pyvista.Actor, data: pyvista.PolyData, colours: Colours) -> None:
    """Give each cell its colour, (m, 3)."""
    data.GetCellData().SetScalars(pyvista.convert_array(np.ascontiguousarray(colours)))
    actor.mapper.scalar_map_mode = "cell"
    actor.mapper.scalar_visibility = True
    data.Modified()


def cells_of(nodes: NDArray[np.int32]) -> pyvista.CellArray:
    """Return cells of equal size, sharing the memory of (m, k) `nodes`."""
    numbers: Any = nodes  # which pyvista's types would have as int
    return pyvista.CellArray.from_regular_cells(numbers)


def points_of(points: NDArray[np.float32]) -> Any:
    """Return (n, 3) points as VTK's, sharing their memory."""
    places: Any = points  # which pyvista's types would have as float
    return pyvista.vtk_points(places, deep=False)
