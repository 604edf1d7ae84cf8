"""One mesh in VTK; only what differs from what it showed last is sent."""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkProperty, vtkRenderer

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

    def __init__(self, renderer: vtkRenderer, surface: vtkProperty) -> None:
        self._renderer, self._surface = renderer, surface
        self._parts: list[tuple[vtkActor, vtkPolyData]] = []
        self.points = vtkPoints()
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
                actor.SetProperty(self._surface)
                data.SetPolys(cells_of(triangles[begin : begin + PART]))
                self._renderer.AddActor(actor)
                self._parts.append((actor, data))
        if fresh or relief != self._relief:
            points, normals = patch.points, patch.normals
            if coarse is not None:
                points, normals = points[coarse.nodes], normals[coarse.nodes]
            if not relief:
                points = points * FLAT
            self.box = np.stack([points.min(axis=0), points.max(axis=0)]).astype(np.float64)
            self.points, upright = points_of(points), to_vtk(normals)
            for _, data in self._parts:  # which share both
                data.SetPoints(self.points)
                data.GetPointData().SetNormals(upright)
                data.Modified()
        if fresh or colours is not self._colours:
            self._paint(colours)
        self._patch, self._relief, self._colours = patch, relief, colours

    def _paint(self, colours: Colours | Rgb) -> None:
        if isinstance(colours, tuple):
            self._surface.SetColor(*unit(colours))
        for k, (actor, data) in enumerate(self._parts):
            if isinstance(colours, tuple):
                actor.GetMapper().ScalarVisibilityOff()
            else:
                paint(actor, data, colours[k * PART : (k + 1) * PART])

    def set_visible(self, visible: bool) -> None:
        """Show or hide it."""
        for actor, _ in self._parts:
            actor.SetVisibility(visible)

    def clear(self) -> None:
        """Show nothing, and let go of what was shown."""
        for actor, _ in self._parts:
            self._renderer.RemoveActor(actor)
            actor.ReleaseGraphicsResources(self._renderer.GetRenderWindow())
        self._parts.clear()
        self._patch = self._relief = self._colours = None


def new_actor() -> tuple[vtkActor, vtkPolyData]:
    """Return an actor and the data it draws."""
    data = vtkPolyData()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor, data


def to_vtk(array: NDArray[Any]) -> Any:
    """Return the array as VTK's, sharing its memory."""
    return numpy_support.numpy_to_vtk(array)  # type: ignore[no-untyped-call]


def paint(actor: vtkActor, data: vtkPolyData, colours: Colours) -> None:
    """Give each cell its colour, (m, 3)."""
    data.GetCellData().SetScalars(to_vtk(np.ascontiguousarray(colours)))
    actor.GetMapper().SetScalarModeToUseCellData()
    actor.GetMapper().ScalarVisibilityOn()
    data.Modified()


def points_of(points: NDArray[np.float32]) -> vtkPoints:
    """Return (n, 3) points, sharing their memory."""
    holder = vtkPoints()
    holder.SetData(to_vtk(np.ascontiguousarray(points)))
    return holder


def cells_of(nodes: NDArray[np.int32]) -> vtkCellArray:
    """Return cells of equal size, sharing the memory of (m, k) `nodes`."""
    cells = vtkCellArray()
    cells.SetData(nodes.shape[1], to_vtk(nodes.reshape(-1)))
    return cells


def unit(colour: Rgb) -> tuple[float, float, float]:
    """Return a colour as shares of full light."""
    return (colour[0] / 255, colour[1] / 255, colour[2] / 255)
