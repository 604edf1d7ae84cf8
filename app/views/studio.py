"""The thread that draws: takes the newest wish, gives back pictures."""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QImage

from app.model.view_state import ViewState
from app.scene.camera import Camera
from app.scene.content import Content

if TYPE_CHECKING:
    from app.views.renderer import Image, Renderer, Tile

FRAME_SECONDS = 0.05
"""While the camera moves, the pictures are as coarse as this needs."""
COARSEST = 0.34
FINE = 2
"""Pixels drawn for each pixel shown, along each side, once the camera rests."""
AFFORDABLE_SECONDS = 0.2
"""Where the plain picture took longer, a finer one is not drawn."""


@dataclass(frozen=True, slots=True, eq=False)
class Wish:
    """What the views should show next.

    Attributes
    ----------
    content : Content or None
        None for empty views.
    sizes : tuple of (int, int, int)
        View, width and height in device pixels, of each visible view.
    moving : bool
        The camera is under the hand: speed before sharpness.
    """

    content: Content | None
    state: ViewState
    camera: Camera
    sizes: tuple[tuple[int, int, int], ...]
    moving: bool

    def same_place(self, other: "Wish") -> bool:
        """Whether both look from the same place, at equal sizes and in equal ground colours."""
        return (self.camera, self.sizes, self.state.dark) == (
            other.camera,
            other.sizes,
            other.state.dark,
        )


@dataclass(frozen=True, slots=True, eq=False)
class Pictures:
    """Finished pictures by view, and how long they took."""

    images: dict[int, QImage]
    wish: Wish
    seconds: float
    final: bool
    """No finer picture of the same follows."""


class Studio(QObject):
    """Owns the drawing thread; every VTK object lives and dies on it."""

    drawn = Signal(object)
    """Pictures."""

    def __init__(self) -> None:
        super().__init__()
        self._news = threading.Condition()
        self._wish: Wish | None = None
        self._ended = False
        self._thread = threading.Thread(target=self._run, name="studio", daemon=True)
        self._thread.start()

    def show(self, wish: Wish) -> None:
        """Draw `wish` next; an earlier one not yet begun is forgotten."""
        with self._news:
            self._wish = wish
            self._news.notify()

    def close(self, seconds: float) -> bool:
        """End the thread; return whether it could be done in so many seconds."""
        with self._news:
            self._ended = True
            self._news.notify()
        self._thread.join(seconds)
        return not self._thread.is_alive()

    def _run(self) -> None:
        from app.scene.scene import VIEWS, scene_of
        from app.views.renderer import Renderer, Tile

        renderer = Renderer(VIEWS)
        renderer.warm_up()
        coarseness = _Coarseness()
        sharp: Wish | None = None
        while (wish := self._next()) is not None:
            scene = None if wish.content is None else scene_of(wish.content, wish.state)
            changed = renderer.apply(scene)
            del scene
            if wish.moving:
                self._draw(renderer, wish, coarseness, Tile)
                sharp = None
            else:
                same = sharp is not None and sharp.same_place(wish)
                views = changed if same else {view for view, _, _ in wish.sizes}
                complete = self._draw_sharp(renderer, wish, views, Tile)
                sharp = wish if complete else None
        renderer.close()

    def _next(self) -> Wish | None:
        with self._news:
            self._news.wait_for(lambda: self._ended or self._wish is not None)
            wish, self._wish = self._wish, None
            return None if self._ended else wish

    def _overtaken(self) -> bool:
        return self._ended or self._wish is not None

    def _draw(
        self, renderer: "Renderer", wish: Wish, coarseness: "_Coarseness", tile: "type[Tile]"
    ) -> None:
        factor = coarseness.factor
        seconds, images = _draw(renderer, wish, factor, False, tile)
        coarseness.learn(seconds)
        self._emit(wish, images, seconds, final=False)

    def _draw_sharp(
        self, renderer: "Renderer", wish: Wish, views: set[int], tile: "type[Tile]"
    ) -> bool:
        """Draw some views, then finer where that is soon done; return whether nothing is left."""
        part = replace(wish, sizes=tuple(size for size in wish.sizes if size[0] in views))
        seconds, images = _draw(renderer, part, 1.0, True, tile)
        finer = seconds < AFFORDABLE_SECONDS
        self._emit(wish, images, seconds, final=not finer)
        if not finer:
            return True
        if self._overtaken():
            return False
        seconds, images = _draw(renderer, part, float(FINE), True, tile)
        self._emit(wish, {k: _halved(image) for k, image in images.items()}, seconds, True)
        return True

    def _emit(self, wish: Wish, images: "dict[int, Image]", seconds: float, final: bool) -> None:
        if not self._ended:
            pictures = {view: _qimage(image) for view, image in images.items()}
            self.drawn.emit(Pictures(pictures, wish, seconds, final))


class _Coarseness:
    """How coarse a picture must be to come in time, learnt from the last ones."""

    def __init__(self) -> None:
        self.factor = 1.0

    def learn(self, seconds: float) -> None:
        ratio = (FRAME_SECONDS / max(seconds, 1e-4)) ** 0.5
        self.factor = float(np.clip(self.factor * np.clip(ratio, 0.5, 1.25), COARSEST, 1.0))


def _draw(
    renderer: "Renderer",
    wish: Wish,
    factor: float,
    fine: bool,
    tile: "Callable[[int, int, int], Tile]",
) -> "tuple[float, dict[int, Image]]":
    start = time.perf_counter()
    tiles = [
        tile(view, max(round(width * factor), 1), max(round(height * factor), 1))
        for view, width, height in wish.sizes
    ]
    images = renderer.draw(wish.camera, tiles, fine, max(factor, 1.0))
    return time.perf_counter() - start, images


def _halved(image: "Image") -> "Image":
    """Return the picture at half its size, each pixel the mean of four."""
    height, width = image.shape[0] // 2, image.shape[1] // 2
    four = image[: 2 * height, : 2 * width].reshape(height, 2, width, 2, 4).astype(np.uint16)
    return ((four.sum(axis=(1, 3)) + 2) // 4).astype(np.uint8)


def _qimage(image: "Image") -> QImage:
    height, width, _ = image.shape
    image[..., 3] = 255  # VTK leaves the ground transparent
    return QImage(image.data, width, height, 4 * width, QImage.Format.Format_RGBX8888).copy()
