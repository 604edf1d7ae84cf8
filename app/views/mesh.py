"""One mesh in VTK; only what differs from what it showed last is sent."""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkProperty

from app.scene.coarse import Coarse
from app.scene.colour_maps import Colours, Rgb
from app.scene.geometry import Patch

FLAT = np.array([1, 1, 0], dtype=np.float32)


class Mesh:
    """A patch, or its coarse likeness, on the screen."""

    def __init__(self, surface: vtkProperty) -> None:
        self.actor, self.data = new_actor()
        self.actor.SetProperty(surface)
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
        if fresh or relief != self._relief:
            points, normals = patch.points, patch.normals
            if coarse is not None:
                points, normals = points[coarse.nodes], normals[coarse.nodes]
            if not relief:
                points = points * FLAT
            self.box = np.stack([points.min(axis=0), points.max(axis=0)]).astype(np.float64)
            self.data.SetPoints(points_of(points))
            self.data.GetPointData().SetNormals(to_vtk(normals))
            self.data.Modified()
        if fresh:
            self.data.SetPolys(cells_of(patch.triangles if coarse is None else coarse.triangles))
        if fresh or colours is not self._colours:
            if isinstance(colours, tuple):
                self.actor.GetMapper().ScalarVisibilityOff()
                self.actor.GetProperty().SetColor(*unit(colours))
            else:
                paint(self.actor, self.data, colours)
        self._patch, self._relief, self._colours = patch, relief, colours

    def clear(self) -> None:
        """Show nothing, and let go of what was shown."""
        self.data.Initialize()
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
