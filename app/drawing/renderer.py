"""Draws layers into images with pyvista, off the screen. All calls come from one thread."""

import os
import sys
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.scene.camera import Camera
from app.scene.geometry import Patch
from app.scene.scene import MeshLayer, Scene
from surfcmp_core.colours.maps import Colours, Rgb

if sys.platform == "linux":  # needs no X server and starts three times faster than GLX
    os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")

import pyvista
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray

from app.drawing.drawn_view import DrawnView

Image = NDArray[np.uint8]


@dataclass(frozen=True, slots=True)
class Tile:
    """One view's picture to be: which view, and its size in pixels."""

    view: int
    width: int
    height: int


class Renderer:
    """An off-screen window whose tiles are the views."""

    def __init__(self, views: int) -> None:
        self._plotter = pyvista.Plotter(
            off_screen=True, shape=(1, views), border=False, lighting="none"
        )
        window = self._plotter.render_window
        assert window is not None
        self._window = window
        self._window.SetMultiSamples(0)
        self._window.AddObserver("AbortCheckEvent", self._check)
        self._give_up: Callable[[], bool] | None = None
        self._pixels = vtkUnsignedCharArray()  # memory that numpy owns would be freed too early
        self._views = [DrawnView(renderer) for renderer in self._plotter.renderers]

    def warm_up(self) -> None:
        """Draw next to nothing once, so that the first true picture finds its shaders ready."""
        corner = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], dtype=np.float32)
        patch = Patch(corner, corner + 1, np.array([[0, 1, 2]], dtype=np.int32), 1.0)
        line = np.zeros((1, 2, 3), dtype=np.float32)
        painted, dots = np.zeros((1, 3), dtype=np.uint8), np.zeros((3, 3), dtype=np.uint8)
        kinds: tuple[Colours | Rgb, ...] = ((0, 0, 0), painted)
        for view, colours in zip(self._views, kinds, strict=False):
            layer = MeshLayer(patch, colours, None, dots, True, True, True, line, painted)
            view.apply(layer)
        tiles = [Tile(view, 16, 16) for view in range(len(self._views))]
        for height in (1.0, 100.0):  # with sides and without
            self.draw(Camera(height=height), tiles, fine=True)
        self.apply(None)

    def apply(self, scene: Scene | None) -> None:
        """Make the views show `scene`."""
        for k, view in enumerate(self._views):
            view.apply(None if scene is None else scene.layers[k])
            if scene is not None:
                view.colour(scene.palette.background, scene.palette.edge)

    def _check(self, *_: object) -> None:
        """Stop drawing half way where that is wanted; VTK asks before each part of a mesh."""
        if self._give_up is not None and self._give_up():
            self._window.SetAbortRender(True)

    def draw(
        self,
        camera: Camera,
        tiles: list[Tile],
        fine: bool,
        density: float = 1.0,
        give_up: Callable[[], bool] | None = None,
    ) -> dict[int, Image]:
        """Return the picture of each tile's view, (height, width, 4) RGBA, top row first.

        `fine` draws whole patches and the triangles' sides; without it the picture comes sooner.
        `density` is how many pixels are drawn for one on the screen, along each side. Nothing is
        returned where `give_up` says so half way.
        """
        if not tiles:
            return {}
        wide, tall = max(tile.width for tile in tiles), max(tile.height for tile in tiles)
        columns = 1 if len(tiles) == 1 else 2
        rows = -(-len(tiles) // columns)
        width, height = wide * columns, tall * rows
        if self._window.GetSize() != (width, height):
            self._window.SetSize(width, height)
        for view in self._views:
            view.renderer.DrawOff()
        corners = {}
        for k, tile in enumerate(tiles):
            x, y = (k % columns) * wide, (k // columns) * tall
            view = self._views[tile.view]
            view.renderer.DrawOn()
            view.renderer.viewport = (
                x / width,
                y / height,
                (x + tile.width) / width,
                (y + tile.height) / height,
            )
            view.choose(fine)
            view.look(camera, tile.height / density, fine)
            view.thicken(density)
            corners[tile.view] = (x, y, tile)
        self._give_up = give_up
        self._window.Render()
        if self._window.GetAbortRender():
            return {}
        box = (0, 0, width - 1, height - 1)
        self._window.GetRGBACharPixelData(*box, 0, self._pixels, 0)
        whole = np.asarray(pyvista.convert_array(self._pixels))
        whole = whole.reshape(height, width, 4)
        return {
            view: np.ascontiguousarray(whole[y : y + tile.height, x : x + tile.width][::-1])
            for view, (x, y, tile) in corners.items()
        }

    def close(self) -> None:
        """Give the graphics memory back; nothing may be drawn afterwards."""
        self._plotter.close()
