"""The thread that draws: takes the newest wish, gives back pictures."""

import threading
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QImage

from app.jobs.priority import DRAWING, give_way
from app.model.view_state import ViewState
from app.scene.camera import Camera
from app.scene.content import Content

if TYPE_CHECKING:
    from app.drawing.renderer import Image, Renderer
    from app.scene.scene import MeshLayer, Scene

FRAME_SECONDS = 0.05
"""While the camera moves, the pictures are as coarse as this needs."""
COARSEST = 0.34
FINE = 2
"""Pixels drawn for each pixel shown, along each side, once the camera rests."""
AFFORDABLE_SECONDS = 0.05
"""Where the plain picture of a view took longer, a finer one is not drawn."""
FIRST = (3, 2, 0, 1)
"""The order in which views are drawn where each takes its time: the difference comes first."""


@dataclass(frozen=True, slots=True, eq=False)
class Wish:
    """What the views should show next.

    Attributes
    ----------
    sizes : tuple of (int, int, int)
        View, width and height in device pixels, of each visible view.
    moving : bool
        The camera is under the hand: speed before sharpness.
    ratio : float
        Device pixels for each pixel of the window, along each side.
    """

    content: Content
    state: ViewState
    camera: Camera
    sizes: tuple[tuple[int, int, int], ...]
    moving: bool
    ratio: float = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class Pictures:
    """Finished pictures by view, and how long they took."""

    images: dict[int, QImage]
    wish: Wish
    seconds: float
    final: bool
    """Nothing finer follows."""


@dataclass(frozen=True, slots=True, eq=False)
class Print:
    """Pictures for paper or a file: drawn apart from the screen, at `density` of its pixels."""

    wish: Wish
    density: float
    done: Callable[[dict[int, QImage]], None]
    """Called on the drawing thread."""


@dataclass(frozen=True, slots=True, eq=False)
class _Seen:
    """What a view's picture on the screen shows."""

    layer: "MeshLayer"
    camera: Camera
    size: tuple[int, int, int]
    dark: bool
    sharp: bool

    def shows(self, other: "_Seen") -> bool:
        """Whether it is the picture of `other`, sharp or not."""
        place = (self.camera, self.size, self.dark)
        same = place == (other.camera, other.size, other.dark)
        return same and not self.layer.differs_from(other.layer)


class Studio(QObject):
    """Owns the drawing thread; every VTK object lives and dies on it."""

    drawn = Signal(object)
    """Pictures."""

    def __init__(self) -> None:
        super().__init__()
        self._news = threading.Condition()
        self._wish: Wish | None = None
        self._prints: list[Print] = []
        self._ended = False
        self._thread = threading.Thread(target=self._run, name="studio", daemon=True)
        self._thread.start()

    def show(self, wish: Wish) -> None:
        """Draw `wish` next; an earlier one not yet begun is forgotten."""
        with self._news:
            self._wish = wish
            self._news.notify()

    def print(self, order: Print) -> None:
        """Draw for a file, once nothing is to be drawn for the screen."""
        with self._news:
            self._prints.append(order)
            self._news.notify()

    def close(self, seconds: float) -> bool:
        """End the thread; return whether it could be done in so many seconds."""
        with self._news:
            self._ended = True
            self._news.notify()
        self._thread.join(seconds)
        return not self._thread.is_alive()

    def _run(self) -> None:
        from app.drawing.renderer import Renderer
        from app.scene.scene import VIEWS

        give_way(DRAWING)
        renderer = Renderer(VIEWS)
        renderer.warm_up()
        hand = _Hand(renderer, lambda: self._ended or self._wish is not None, self._emit)
        while (order := self._next()) is not None:
            if isinstance(order, Print):
                hand.print(order)
            elif order.moving:
                hand.sketch(order)
            else:
                hand.finish(order)
        renderer.close()

    def _next(self) -> Wish | Print | None:
        with self._news:
            self._news.wait_for(lambda: self._ended or self._wish is not None or self._prints)
            if self._ended:
                return None
            if self._wish is None:
                return self._prints.pop(0)
            wish, self._wish = self._wish, None
            return wish

    def _emit(self, pictures: Pictures) -> None:
        if not self._ended:
            self.drawn.emit(pictures)


class _Hand:
    """Draws wishes with a renderer, as soon and as little as can be."""

    def __init__(
        self,
        renderer: "Renderer",
        overtaken: Callable[[], bool],
        show: Callable[[Pictures], None],
    ) -> None:
        self._renderer = renderer
        self._overtaken = overtaken
        self._show = show
        self._factor = 1.0
        self._seen: dict[int, _Seen] = {}
        self._content: Content | None = None

    def sketch(self, wish: Wish) -> None:
        """Draw what can be drawn while the camera moves."""
        scene = self._scene(wish, sketch=True)
        images, seconds = self._draw(wish, wish.sizes, self._factor, fine=False)
        ratio = (FRAME_SECONDS / max(seconds, 1e-4)) ** 0.5
        self._factor = float(np.clip(self._factor * np.clip(ratio, 0.5, 1.25), COARSEST, 1.0))
        self._note(wish, scene, wish.sizes, sharp=False)
        self._show(Pictures(_qimages(images), wish, seconds, final=False))

    def finish(self, wish: Wish) -> None:
        """Draw a sketch where that comes sooner, then all that is not sharp yet."""
        large = any(patch.coarse for patch in wish.content.geometry.patches)
        if large and not self._sketch_changes(wish):
            return
        scene = self._scene(wish)
        stale = [
            size
            for size in sorted(wish.sizes, key=lambda size: FIRST.index(size[0]))
            if not (seen := self._seen.get(size[0]))
            or not seen.sharp
            or not seen.shows(_seen(wish, scene, size, sharp=True))
        ]
        groups = [[size] for size in stale] if large and stale else [stale]
        finer = []
        for k, group in enumerate(groups):
            images, seconds = self._draw(wish, group, 1.0, fine=True)
            if group and not images:
                return
            affordable = seconds < AFFORDABLE_SECONDS * len(group)
            finer += group if affordable else []
            if not affordable:
                self._note(wish, scene, group, sharp=True)
            last = k == len(groups) - 1 and not finer
            self._show(Pictures(_qimages(images), wish, seconds, final=last))
            if self._overtaken() and not last:
                return
        if finer:
            images, seconds = self._draw(wish, finer, float(FINE), fine=True)
            if not images:
                return
            self._note(wish, scene, finer, sharp=True)
            halves = {view: _halved(image) for view, image in images.items()}
            self._show(Pictures(_qimages(halves), wish, seconds, final=True))

    def print(self, order: Print) -> None:
        """Draw each view sharply at a density of its own."""
        self._scene(order.wish)
        images: dict[int, Image] = {}
        for size in order.wish.sizes:
            images |= self._draw(order.wish, [size], order.density, fine=True, steady=True)[0]
        self._seen.clear()
        order.done(_qimages(images))

    def _sketch_changes(self, wish: Wish) -> bool:
        """Sketch the views whose picture shows something else; say whether there is time for more.

        After that the same is drawn sharply.
        """
        scene = self._scene(wish, sketch=True)
        changed = [
            size
            for size in wish.sizes
            if not (seen := self._seen.get(size[0]))
            or not seen.shows(_seen(wish, scene, size, sharp=False))
        ]
        if changed:
            images, seconds = self._draw(wish, changed, self._factor, fine=False)
            self._note(wish, scene, changed, sharp=False)
            self._show(Pictures(_qimages(images), wish, seconds, final=False))
        return not self._overtaken()

    def _scene(self, wish: Wish, *, sketch: bool = False) -> "Scene":
        from app.scene.scene import scene_of

        if wish.content is not self._content:
            self._seen.clear()
            self._content = wish.content
        scene = scene_of(wish.content, wish.state, sketch=sketch)
        self._renderer.apply(scene)
        return scene

    def _note(
        self, wish: Wish, scene: "Scene", sizes: Iterable[tuple[int, int, int]], *, sharp: bool
    ) -> None:
        for size in sizes:
            self._seen[size[0]] = _seen(wish, scene, size, sharp=sharp)

    def _draw(
        self,
        wish: Wish,
        sizes: Iterable[tuple[int, int, int]],
        factor: float,
        *,
        fine: bool,
        steady: bool = False,
    ) -> "tuple[dict[int, Image], float]":
        """Return pictures, and how long they took; none where others are wanted meanwhile.

        Sketches are always finished, and so is what is drawn `steady`.
        """
        from app.drawing.renderer import Tile

        start = time.perf_counter()
        tiles = [
            Tile(view, max(round(width * factor), 1), max(round(height * factor), 1))
            for view, width, height in sizes
        ]
        give_up = self._overtaken if fine and not steady else None
        density = max(factor, 1.0) * wish.ratio
        images = self._renderer.draw(wish.camera, tiles, fine, density, give_up)
        return images, time.perf_counter() - start


def _seen(wish: Wish, scene: "Scene", size: tuple[int, int, int], *, sharp: bool) -> _Seen:
    return _Seen(scene.layers[size[0]], wish.camera, size, wish.state.dark, sharp)


def _halved(image: "Image") -> "Image":
    """Return the picture at half its size, each pixel the mean of four."""
    height, width = image.shape[0] // 2, image.shape[1] // 2
    four = image[: 2 * height, : 2 * width].reshape(height, 2, width, 2, 4).astype(np.uint16)
    return ((four.sum(axis=(1, 3)) + 2) // 4).astype(np.uint8)


def _qimages(images: "dict[int, Image]") -> dict[int, QImage]:
    return {view: _qimage(image) for view, image in images.items()}


def _qimage(image: "Image") -> QImage:
    height, width, _ = image.shape
    image[..., 3] = 255  # VTK leaves the ground transparent
    return QImage(image.data, width, height, 4 * width, QImage.Format.Format_RGBX8888).copy()
