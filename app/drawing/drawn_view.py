"""One view: a mesh and its coarse likeness, lines and nodes over it, light and camera."""

import numpy as np
import pyvista

from app.drawing.lights import light
from app.drawing.mesh import Mesh, cells_of, new_actor, paint, points_of
from app.scene.camera import Camera, Vector
from app.scene.scene import MeshLayer
from surfcmp_core.colours.maps import Rgb

EDGE_PIXELS = (2.0, 9.0)
"""Sides shorter than the first on the screen are not drawn; at the second they are full."""
EDGE_OPACITY = 0.45
NODE_PIXELS = 14.0
"""Nodes are drawn where sides are longer than this on the screen."""
NODE_SIZE = 5.0
LINE_PIXELS = 3.0


class DrawnView:
    """One tile."""

    def __init__(self, renderer: pyvista.Renderer) -> None:
        self.renderer = renderer
        self._layer: MeshLayer | None = None
        self._surface = surface = pyvista.Property(
            interpolation="gouraud", specular=0.06, specular_power=18
        )
        self._whole, self._coarse = (Mesh(renderer, surface) for _ in range(2))
        self._lines, self._line_data = new_actor()
        self._drawn: MeshLayer | None = None
        """Whose lines were sent last."""
        self._sketched = False
        self._dots, self._dot_data = new_actor()
        self._dotted: MeshLayer | None = None
        self._dots.prop.render_points_as_spheres = True
        for actor in (self._lines, self._dots):
            actor.prop.lighting = False
            mapper = actor.mapper
            mapper.SetResolveCoincidentTopologyToPolygonOffset()
            mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, -4000)
            mapper.SetRelativeCoincidentTopologyPointOffsetParameter(-4000)
            renderer.AddActor(actor)
        light(renderer)
        renderer.camera.parallel_projection = True

    def apply(self, layer: MeshLayer | None) -> None:
        """Show a layer, or nothing."""
        self._layer = layer
        if layer is None:
            self._whole.clear()
            self._coarse.clear()
            self._dot_data.Initialize()
            self._dotted = self._drawn = None
            for actor in (self._lines, self._dots):
                actor.visibility = False
            return
        patch = layer.patch
        if layer.colours is not None:
            self._whole.show(patch, None, layer.relief, layer.colours)
        if patch.coarse is not None and layer.coarse_colours is not None:
            self._coarse.show(patch, patch.coarse, layer.relief, layer.coarse_colours)
        self._lines.visibility = len(layer.lines) > 0
        if self._drawn is None or layer.lines_differ_from(self._drawn):
            ends = np.ascontiguousarray(layer.lines.reshape(-1, 3), dtype=np.float32)
            pairs = np.arange(len(ends), dtype=np.int32).reshape(-1, 2)
            self._line_data.SetPoints(points_of(ends))
            self._line_data.lines = cells_of(pairs)
            paint(self._lines, self._line_data, layer.line_colours)
        self._drawn = layer
        kinds = (layer.colours, layer.coarse_colours)
        plain = any(isinstance(kind, tuple) for kind in kinds) or patch.data is not None
        self._surface.ambient = 0.28 if plain else 0.58  # flat light where a colour is to be read
        self._surface.diffuse = 0.84 if plain else 0.5
        self._surface.lighting = layer.shaded

    def choose(self, fine: bool) -> None:
        """Draw the whole patch, or its coarse likeness where there is one."""
        layer = self._layer
        self._sketched = layer is not None and layer.patch.coarse is not None and not fine
        self._coarse.set_visible(self._sketched)
        self._whole.set_visible(layer is not None and not self._sketched)

    def colour(self, background: Rgb, edge: Rgb) -> None:
        """Set the colours that carry no quantity."""
        self.renderer.background_color = background
        self._surface.edge_color = edge

    def thicken(self, density: float) -> None:
        """Draw lines for `density` pixels on each one of the screen."""
        self._lines.prop.line_width = LINE_PIXELS * density
        self._dots.prop.point_size = NODE_SIZE * density

    def look(self, camera: Camera, pixels: float, fine: bool) -> None:
        """Look through `camera`, whose height takes so many pixels of the screen."""
        eye = self.renderer.camera
        focus, back = np.array(camera.focus), np.array(camera.back)
        near, far = self._depths(focus, back)
        eye.focal_point = tuple(focus)
        eye.position = tuple(focus + back * (far + camera.height))
        eye.up = camera.up
        eye.parallel_scale = camera.height / 2
        eye.clipping_range = camera.height, camera.height + far - near
        layer = self._layer
        surface, size = self._surface, 0.0
        if fine and layer is not None and layer.edges:
            size = layer.patch.edge * pixels / camera.height
        low, high = EDGE_PIXELS
        strength = float(np.clip((size - low) / (high - low), 0, 1))
        surface.show_edges = strength > 0
        surface.edge_opacity = EDGE_OPACITY * strength
        self._dot(layer if size > NODE_PIXELS else None)

    def _depths(self, focus: Vector, back: Vector) -> tuple[float, float]:
        """Return between which distances from the focus, towards the eye, all is drawn.

        VTK would find the same by going through all nodes, and hold Python's lock meanwhile.
        """
        box = (self._coarse if self._sketched else self._whole).box
        if self._layer is not None and len(self._layer.lines):
            ends = self._layer.lines.reshape(-1, 3)
            box = np.stack([np.minimum(box[0], ends.min(0)), np.maximum(box[1], ends.max(0))])
        middle, half = box.mean(axis=0), (box[1] - box[0]) / 2
        reach = float(half @ np.abs(back)) + 0.05 * float(np.linalg.norm(half)) + 1e-6
        depth = float((middle - focus) @ back)
        return depth - reach, depth + reach

    def _dot(self, layer: MeshLayer | None) -> None:
        """Show a layer's nodes, or none; they are sent when they are first seen."""
        self._dots.visibility = layer is not None
        if layer is None or layer.nodes is None or layer is self._dotted:
            return
        self._dotted = layer
        self._dot_data.SetPoints(points_of(self._whole.points))
        numbers = np.arange(len(layer.patch.points), dtype=np.int32)
        self._dot_data.verts = cells_of(numbers.reshape(-1, 1))
        paint(self._dots, self._dot_data, layer.nodes)
