"""One view's mesh and lines in VTK; only what differs from the last layer is sent."""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

from app.scene.camera import Camera
from app.scene.colour_maps import Colours, Rgb
from app.scene.scene import MeshLayer

EDGE_PIXELS = (2.0, 9.0)
"""Sides shorter than the first on the screen are not drawn; at the second they are full."""
EDGE_OPACITY = 0.45
NODE_PIXELS = 14.0
"""Nodes are drawn where sides are longer than this on the screen."""
NODE_SIZE = 5.0
LINE_PIXELS = 3.0


class View:
    """One tile: a mesh, and the lines over it."""

    def __init__(self) -> None:
        self.renderer = vtkRenderer()
        self._layer: MeshLayer | None = None
        self._mesh, self._data = _actor()
        self._lines, self._line_data = _actor()
        self._coarse, self._coarse_data = _actor()
        self._coarse.SetProperty(self._mesh.GetProperty())
        self._dots, self._dot_data = _actor()
        self._dotted: MeshLayer | None = None
        for actor in (self._mesh, self._coarse, self._lines, self._dots):
            self.renderer.AddActor(actor)
        self._dots.GetProperty().SetLighting(False)
        self._dots.GetProperty().SetRenderPointsAsSpheres(True)
        line = self._lines.GetProperty()
        line.SetLighting(False)
        for actor in (self._lines, self._dots):
            mapper = actor.GetMapper()
            mapper.SetResolveCoincidentTopologyToPolygonOffset()
            mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, -4000)
            mapper.SetRelativeCoincidentTopologyPointOffsetParameter(-4000)
        surface = self._mesh.GetProperty()
        surface.SetInterpolationToGouraud()
        surface.SetSpecular(0.06)
        surface.SetSpecularPower(18)
        self.renderer.AutomaticLightCreationOff()
        for place, strength in (((-0.55, 0.75, 1.0), 0.85), ((0.9, 0.1, 0.6), 0.22)):
            light = vtkLight()
            light.SetLightTypeToCameraLight()
            light.SetPosition(*place)
            light.SetFocalPoint(0, 0, 0)
            light.SetIntensity(strength)
            self.renderer.AddLight(light)
        self.renderer.GetActiveCamera().ParallelProjectionOn()

    def apply(self, layer: MeshLayer | None) -> bool:
        """Show a layer, or nothing; return whether that looks different."""
        old, self._layer = self._layer, layer
        self._lines.SetVisibility(layer is not None and len(layer.lines) > 0)
        if layer is None:
            for data in (self._data, self._coarse_data, self._dot_data):
                data.Initialize()
            self._dots.SetVisibility(False)
            return old is not None
        moved = old is None or old.patch is not layer.patch or old.relief != layer.relief
        fresh = old is None or old.patch is not layer.patch
        coarse = layer.patch.coarse
        if moved:
            points, normals = layer.patch.points, layer.patch.normals
            if not layer.relief:
                points = points * np.array([1, 1, 0], dtype=np.float32)
            _place(self._data, points, normals)
            if coarse is not None:
                _place(self._coarse_data, points[coarse.nodes], normals[coarse.nodes])
        if fresh:
            self._data.SetPolys(_cells(layer.patch.triangles))
            if coarse is not None:
                self._coarse_data.SetPolys(_cells(coarse.triangles))
        if fresh or old is None or old.colours is not layer.colours:
            self._paint(layer)
        if old is None or not np.array_equal(old.lines, layer.lines):
            ends = np.ascontiguousarray(layer.lines.reshape(-1, 3), dtype=np.float32)
            self._line_data.SetPoints(_points(ends))
            pairs = np.arange(len(ends), dtype=np.int32).reshape(-1, 2)
            self._line_data.SetLines(_cells(pairs))
            _paint(self._lines, self._line_data, layer.line_colours)
        self._mesh.GetProperty().SetLighting(layer.shaded)
        return old is None or layer.differs_from(old)

    def choose(self, fine: bool) -> None:
        """Draw the whole patch, or its coarse likeness where there is one."""
        layer = self._layer
        coarse = layer is not None and layer.patch.coarse is not None and not fine
        self._coarse.SetVisibility(coarse)
        self._mesh.SetVisibility(layer is not None and not coarse)

    def _paint(self, layer: MeshLayer) -> None:
        plain = isinstance(layer.colours, tuple) or layer.patch.data is not None
        surface = self._mesh.GetProperty()
        surface.SetAmbient(0.22 if plain else 0.46)  # flat light where a colour is to be read
        surface.SetDiffuse(0.86 if plain else 0.58)
        if isinstance(layer.colours, tuple):
            surface.SetColor(*_unit(layer.colours))
            for actor in (self._mesh, self._coarse):
                actor.GetMapper().ScalarVisibilityOff()
            return
        _paint(self._mesh, self._data, layer.colours)
        if layer.patch.coarse is not None:
            _paint(self._coarse, self._coarse_data, layer.colours[layer.patch.coarse.source])

    def colour(self, background: Rgb, edge: Rgb) -> None:
        """Set the colours that carry no quantity."""
        self.renderer.SetBackground(*_unit(background))
        self._mesh.GetProperty().SetEdgeColor(*_unit(edge))

    def thicken(self, density: float) -> None:
        """Draw lines for `density` pixels on each one of the screen."""
        self._lines.GetProperty().SetLineWidth(LINE_PIXELS * density)
        self._dots.GetProperty().SetPointSize(NODE_SIZE * density)

    def look(self, camera: Camera, pixels: float, fine: bool) -> None:
        """Look through `camera`, whose height takes so many pixels of the screen."""
        eye = self.renderer.GetActiveCamera()
        focus, back = np.array(camera.focus), np.array(camera.back)
        eye.SetFocalPoint(*focus)
        box = np.array(self.renderer.ComputeVisiblePropBounds()).reshape(3, 2)
        far = float(np.abs(box).max()) if box[0, 0] <= box[0, 1] else 0.0
        eye.SetPosition(*(focus + back * (camera.height + 4 * far)))  # nothing lies behind it
        eye.SetViewUp(*camera.up)
        eye.SetParallelScale(camera.height / 2)
        self.renderer.ResetCameraClippingRange()
        layer = self._layer
        surface = self._mesh.GetProperty()
        size = 0.0
        if fine and layer is not None and layer.edges:
            size = layer.patch.edge * pixels / camera.height
        low, high = EDGE_PIXELS
        strength = float(np.clip((size - low) / (high - low), 0, 1))
        surface.SetEdgeVisibility(strength > 0)
        surface.SetEdgeOpacity(EDGE_OPACITY * strength)
        self._dot(layer if size > NODE_PIXELS else None)

    def _dot(self, layer: MeshLayer | None) -> None:
        """Show a layer's nodes, or none; they are sent when they are first seen."""
        self._dots.SetVisibility(layer is not None)
        if layer is None or layer is self._dotted:
            return
        self._dotted = layer
        self._dot_data.SetPoints(self._data.GetPoints())
        numbers = np.arange(len(layer.patch.points), dtype=np.int32)
        self._dot_data.SetVerts(_cells(numbers.reshape(-1, 1)))
        _paint(self._dots, self._dot_data, layer.nodes)


def _actor() -> tuple[vtkActor, vtkPolyData]:
    data = vtkPolyData()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor, data


def _to_vtk(array: NDArray[Any]) -> Any:
    """Return the array as VTK's, sharing its memory."""
    return numpy_support.numpy_to_vtk(array)  # type: ignore[no-untyped-call]


def _place(data: vtkPolyData, points: NDArray[Any], normals: NDArray[np.float32]) -> None:
    data.SetPoints(_points(points))
    data.GetPointData().SetNormals(_to_vtk(normals))
    data.Modified()


def _paint(actor: vtkActor, data: vtkPolyData, colours: Colours) -> None:
    data.GetCellData().SetScalars(_to_vtk(np.ascontiguousarray(colours)))
    actor.GetMapper().SetScalarModeToUseCellData()
    actor.GetMapper().ScalarVisibilityOn()
    data.Modified()


def _points(points: NDArray[np.float32]) -> vtkPoints:
    holder = vtkPoints()
    holder.SetData(_to_vtk(np.ascontiguousarray(points)))
    return holder


def _cells(nodes: NDArray[np.int32]) -> vtkCellArray:
    """Return cells of equal size, sharing the memory of (m, k) `nodes`."""
    cells = vtkCellArray()
    cells.SetData(nodes.shape[1], _to_vtk(nodes.reshape(-1)))
    return cells


def _unit(colour: Rgb) -> tuple[float, float, float]:
    return (colour[0] / 255, colour[1] / 255, colour[2] / 255)
