"""Keeps the view state and the camera, and has the views drawn."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEasingCurve, QObject, Qt, QTimer, QVariantAnimation, Signal
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QStyle

from app.drawing.studio import Pictures, Print, Studio, Wish
from app.look.numerals import short
from app.look.theme import theme
from app.model.tool import Tool
from app.model.view_state import Of, Place, ScaleChoice, ViewState
from app.scene.camera import Camera, between, home, showing
from app.scene.content import Content
from app.scene.pick import (
    corners_at,
    path_in_view,
    place_in_view,
    point_at,
    point_in_view,
    reading_at,
)
from app.views.canvas import Label
from app.views.four_views import ViewGrid

ARROWS = {
    int(Qt.Key.Key_Left): (-1, 0),
    int(Qt.Key.Key_Right): (1, 0),
    int(Qt.Key.Key_Up): (0, 1),
    int(Qt.Key.Key_Down): (0, -1),
}
ZOOMS = {
    int(Qt.Key.Key_Plus): 1.15,
    int(Qt.Key.Key_Equal): 1.15,
    int(Qt.Key.Key_Minus): 1 / 1.15,
}

REST_MILLISECONDS = 140
"""The camera rests when it has not moved for so long."""
FLIGHT_MILLISECONDS = 260
SLOW_SECONDS = 0.1
"""Where a picture takes longer while the camera moves, it jumps in place of flying."""


class Display(QObject):
    """One camera and one state for the four views."""

    changed = Signal()
    """The state or the content is another one."""
    shown = Signal(object)
    """Pictures reached the screen."""
    tool_changed = Signal(object)
    _printed = Signal(object, object, bool)
    path_drawn = Signal(object, object)
    """Tool, and places (x, y) in the plane of comparison."""
    landmark_picked = Signal(int, object)
    """Surface 1 or 2, and the place (3,) in the comparison's coordinates."""

    def __init__(self, grid: ViewGrid) -> None:
        super().__init__()
        self._grid = grid
        self._studio: Studio | None = None
        self.state = ViewState()
        self.content: Content | None = None
        self.unit = ""
        """Of the labels' values."""
        self._camera = self._seen = Camera()
        self._flight = QVariantAnimation(self, startValue=0.0, endValue=1.0)
        self._flight.setDuration(FLIGHT_MILLISECONDS)
        self._flight.setEasingCurve(QEasingCurve.Type.InOutCubic)
        self._flight.valueChanged.connect(self._fly_on)
        self._flight.finished.connect(self._land)
        self._from = self._to = self._camera
        self._frame_seconds = 0.0
        self._landmarks: list[tuple[int, NDArray[np.float64], str]] = []
        self.tool = Tool.LOOK
        self._brush = 0.0
        self._rest = QTimer(self, singleShot=True, interval=REST_MILLISECONDS)
        self._rest.timeout.connect(self.draw)
        self._printed.connect(self._use_print)
        grid.pressed = self.press
        for view, frame in enumerate(grid.frames):
            canvas = frame.canvas
            canvas.turned.connect(self._turn)
            canvas.panned.connect(lambda right, up: self._move(lambda c: c.panned(right, up)))
            canvas.zoomed.connect(self._zoom)
            canvas.resized.connect(self._move_nothing)
            canvas.drawn.connect(lambda path, v=view: self._drawn(v, path))
            canvas.clicked.connect(lambda right, up, v=view: self._pick(v, right, up))
            for source in (canvas.filled, frame.title.filled):
                source.connect(lambda v=view: self.toggle_fill(v))

    @property
    def camera(self) -> Camera:
        """Where all views look from, or fly to."""
        return self._to if self.flying else self._camera

    @property
    def seen(self) -> Camera:
        """The camera of the pictures on the screen."""
        return self._seen

    def set_content(self, content: Content, unit: str, scale: ScaleChoice) -> None:
        """Show another comparison; the camera stays where the box is much the same."""
        old, self.content = self.content, content
        self.unit = unit
        self.state = replace(self.state, scale=scale)
        if old is None or old.geometry is not content.geometry:
            self.state = self.state.without(Of.PLACES)
        if old is None or not _alike(old, content):
            self._flight.stop()
            self._camera = home(content.geometry, self._aspect(), self.state.relief)
        self.changed.emit()
        self.draw()

    def change(self, **changes: Any) -> None:
        """Replace fields of the view state."""
        self.show(replace(self.state, **changes))

    def show(self, state: ViewState) -> None:
        """Put another view state in force."""
        if state == self.state:
            return
        old, self.state = self.state, state
        if old.relief != state.relief and self.content is not None:
            camera = self.camera.from_above()
            if state.relief:
                first = home(self.content.geometry, self._aspect(), True)
                camera = replace(first, height=camera.height)
            self.fly(camera)
        if old.filled != state.filled:
            self._grid.fill(state.filled)
        self.changed.emit()
        if old.drawn != state.drawn or old.filled != state.filled:
            self.draw()
        self._show_labels()

    def toggle_fill(self, view: int) -> None:
        """Let one view have all the place, or give it back."""
        self.change(filled=None if self.state.filled == view else view)

    def go_home(self) -> None:
        """Show everything again, as at first."""
        if self.content is not None:
            self.fly(home(self.content.geometry, self._aspect(), self.state.relief))

    def look_from_above(self) -> None:
        """Look straight down, y upwards, at what is in the middle."""
        self.fly(self.camera.from_above())

    def look_at(self, low: Any, high: Any) -> None:
        """Move to a box in the scene's coordinates, keeping the direction of view."""
        if not self.state.relief:
            low, high = low.copy(), high.copy()
            low[2] = high[2] = 0.0
        self.fly(showing(low, high, self._aspect(), self.camera))

    def fly(self, camera: Camera) -> None:
        """Move to a camera, smoothly where pictures come fast enough and motion is welcome."""
        self._from, self._to = self._camera, camera
        self._flight.stop()
        style = self._grid.style()
        still = style.styleHint(QStyle.StyleHint.SH_Widget_Animation_Duration) == 0
        if still or self._frame_seconds > SLOW_SECONDS or not self._grid.isVisible():
            self._camera = camera
            self.draw()
        else:
            self._flight.start()

    @property
    def flying(self) -> bool:
        """Whether the camera is on its way."""
        return self._flight.state() == QVariantAnimation.State.Running

    def _fly_on(self, share: float) -> None:
        if self.flying:
            self._camera = between(self._from, self._to, share)
            self._wish(moving=True)

    def _land(self) -> None:
        self._camera = self._to
        self.draw()

    def draw(self) -> None:
        """Have the views drawn sharply."""
        self._rest.stop()
        self._wish(moving=self.flying)

    def print(self, density: float, use: Callable[[], object], *, light: bool = False) -> None:
        """Call `use` while the views hold pictures with `density` times the screen's pixels.

        `light`: as for paper, also where the window is dark.
        """
        if self.content is None or self._studio is None:
            return
        ratio, sizes = self._grid.devicePixelRatioF(), self._grid.sizes()
        state = replace(self.state, dark=self.state.dark and not light)
        wish = Wish(self.content, state, self.camera, sizes, moving=False, ratio=ratio)

        def done(images: dict[int, QImage]) -> None:
            self._printed.emit(images, use, state.dark)

        self._studio.print(Print(wish, density, done))

    def _use_print(self, images: dict[int, QImage], use: Callable[[], object], dark: bool) -> None:
        if self._studio is not None:
            with self._grid.holding(images, theme(dark)):
                use()
            for frame in self._grid.frames:
                frame.canvas.show_image(frame.canvas.image, theme(self.state.dark))

    def press(self, key: int, shifted: bool) -> bool:
        """Move the camera by a key; say whether the key means anything."""
        right, up = ARROWS.get(key, (0, 0))
        if right or up:
            if shifted or not self.state.relief:
                self._move(lambda camera: camera.panned(-0.05 * right, -0.05 * up))
            else:
                self._turn(0.12 * right, 0.12 * up)
            return True
        if key in ZOOMS:
            self._zoom(ZOOMS[key], 0.0, 0.0)
            return True
        return False

    def warm_up(self) -> None:
        """Have the drawing thread load what it needs while the core is still at work."""
        if self._studio is None:
            self._studio = Studio()
            self._studio.drawn.connect(self._receive)

    def close(self, seconds: float) -> bool:
        """End the drawing; return whether it could be done in so many seconds."""
        self._rest.stop()
        self._flight.stop()
        studio, self._studio = self._studio, None
        return studio is None or studio.close(seconds)

    def _move(self, step: Callable[[Camera], Camera]) -> None:
        self._flight.stop()
        self._camera = step(self._camera)
        self._wish(moving=True)
        self._rest.start()

    def _move_nothing(self) -> None:
        """Draw anew for another size; a flight goes on."""
        self._wish(moving=True)
        if not self.flying:
            self._rest.start()

    def _turn(self, right: float, up: float) -> None:
        self._move(lambda camera: camera.turned(right, up))

    def _zoom(self, factor: float, right: float, up: float) -> None:
        self._move(lambda camera: camera.zoomed(factor, right, up))

    def use(self, tool: Tool) -> None:
        """Take a tool in hand."""
        self.tool = tool
        for frame in self._grid.frames:
            frame.canvas.take(tool)
        self.tool_changed.emit(tool)

    def set_brush(self, radius: float) -> None:
        """Set the brush's radius, in the unit of the input."""
        self._brush = radius

    def _drawn(self, view: int, path: list[tuple[float, float]]) -> None:
        if self.content is not None:
            relief = self.state.relief
            geometry = self.content.geometry
            places = tuple(path_in_view(geometry, self._camera, relief, view, path))
            self.path_drawn.emit(self.tool, places)

    def _pick(self, view: int, right: float, up: float) -> None:
        if self.content is None:
            return
        geometry, relief = self.content.geometry, self.state.relief
        if self.tool is Tool.LANDMARK:
            point = point_in_view(geometry, self._camera, relief, view, right, up)
            if view < 2 and point is not None:
                self.landmark_picked.emit(view + 1, point + geometry.origin)
            return
        place = place_in_view(geometry, self._camera, relief, view, right, up)
        old = self.state.picked
        again = place is not None and old is not None and place.triangle == old.triangle
        self.change(picked=None if again else place)

    def _aspect(self) -> float:
        sizes = self._grid.sizes()
        return sizes[0][1] / sizes[0][2] if sizes else 1.0

    def _wish(self, moving: bool) -> None:
        for frame in self._grid.frames:
            frame.canvas.turning = self.state.relief
            frame.canvas.brush = self._brush / self._camera.height
        if self.content is None or not self._grid.isVisible():
            return
        self.warm_up()
        assert self._studio is not None
        ratio, sizes = self._grid.devicePixelRatioF(), self._grid.sizes()
        self._studio.show(Wish(self.content, self.state, self._camera, sizes, moving, ratio))

    def _receive(self, pictures: Pictures) -> None:
        if self._studio is None:  # closed while these were on their way
            return
        self._grid.show_pictures(pictures)
        self._seen = pictures.wish.camera
        if pictures.wish.moving:
            self._frame_seconds = pictures.seconds
        self._show_labels()
        self.shown.emit(pictures)

    def _show_labels(self) -> None:
        """Lay the labels of the picked and kept places where they stand in the pictures."""
        places = [(place, True) for place in self.state.probes]
        if self.state.picked is not None:
            places.append((self.state.picked, False))
        for view, frame in enumerate(self._grid.frames):
            labels = self._marks(view)
            if self.content is not None:
                labels += [self._label(self.content, place, kept, view) for place, kept in places]
            frame.canvas.show_labels(labels)

    def set_landmarks(self, marks: list[tuple[int, NDArray[np.float64], str]]) -> None:
        """Mark places: the view (0 or 1), the place in the comparison's coordinates, a text."""
        self._landmarks = marks
        self._show_labels()

    def _marks(self, view: int) -> list[Label]:
        if self.content is None:
            return []
        labels = []
        for of, place, text in self._landmarks:
            if of == view:
                point = place - self.content.geometry.origin
                point[2] *= self.state.relief
                right, up, _ = self._seen.project(point[None])[0].tolist()
                labels.append(Label(right, up, text, False))
        return labels

    def _label(self, content: Content, place: Place, kept: bool, view: int) -> Label:
        relief = self.state.relief
        point = point_at(content, place, relief, view)
        corners = () if kept else corners_at(content, place, relief, view)
        seen = self._seen.project(np.stack([point, *corners]))[:, :2].tolist()
        number = short(float(f"{reading_at(content.comparison, place).difference:.3g}"))
        text = f"{number} {self.unit}".strip()
        right, up = seen[0]
        return Label(right, up, text, kept, tuple((x, y) for x, y in seen[1:]))


def _alike(one: Content, two: Content) -> bool:
    """Whether the camera for one shows the other well."""
    a, b = one.geometry, two.geometry
    size = float(((a.high - a.low) ** 2).sum() ** 0.5)
    shift = abs(a.origin - b.origin).max() + abs(a.low - b.low).max() + abs(a.high - b.high).max()
    return bool(shift < 0.02 * size)
