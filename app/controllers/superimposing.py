"""Ties both scans in one scene to what is compared, and tells what is read off there."""

import math
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import BinaryIO, Protocol

import numpy as np
from PySide6.QtCore import QBuffer, QObject, SignalInstance
from PySide6.QtGui import QImage

from app.controllers.asking import Asking, Telling
from app.controllers.display import Display
from app.controllers.workbench import Workbench
from app.look.numerals import three
from app.model.superimposition import Superimposition
from app.panels.superimposition_panel import SuperimpositionPanel
from app.scene.superimposed import Superimposed, difference_at, profile_on, superimposed
from surfcmp_core.comparing.options import NOT_MOVED
from surfcmp_core.report.outputs import check_outputs
from surfcmp_core.system.whole_files import OutputError, write_all

Place = tuple[float, float, float]
Pointed = tuple[int, int, Place]
"""Surface 0 or 1, one of its triangles with data, and where, in the scene's coordinates."""


class SceneView(Protocol):
    """A view of both scans."""

    @property
    def pointed(self) -> SignalInstance:
        """Pointed or None: what lies under the pointer."""

    @property
    def clicked(self) -> SignalInstance:
        """The same, where the mouse was pressed."""

    @property
    def flickered(self) -> SignalInstance:
        """The user wants to see the other scan."""

    def show_scene(self, scene: Superimposed) -> None:
        """Show a scene."""

    def mark(self, places: list[Place]) -> None:
        """Mark places, and the way from each to the next."""

    def look(self, view: str) -> None:
        """Look from a standard side."""

    def nearest(self, surface: int, place: Place) -> Place:
        """Return the place of a scan that is nearest to one in the scene."""

    def is_seen(self) -> bool:
        """Whether the window is on the screen."""

    def picture(self) -> QImage:
        """Return what is seen."""

    def raise_up(self) -> None:
        """Show the window, in front of others."""

    def close_for_good(self) -> None:
        """Give back what the graphics hold."""


class Superimposing(QObject):
    """Keeps how both scans are looked at; the view is made when it is first wanted."""

    def __init__(
        self,
        workbench: Workbench,
        display: Display,
        panel: SuperimpositionPanel,
        make: Callable[[SuperimpositionPanel], SceneView],
        telling: Telling,
        asking: Asking,
    ) -> None:
        super().__init__()
        self._workbench = workbench
        self._display = display
        self._make = make
        self._telling = telling
        self._asking = asking
        self._view: SceneView | None = None
        self.panel = panel
        self.state = Superimposition()
        self._measures = False
        self.reading = ""
        """What is read off the scene, a line for each thing."""
        self.places: list[Place] = []
        """Between which distances and the angle are measured, in the scene's coordinates."""
        panel.changed.connect(self.change)
        panel.measure_asked.connect(self.measure)
        panel.picture_asked.connect(self.save_picture)
        panel.view_asked.connect(self.look)
        display.changed.connect(self._show)
        workbench.compared.connect(self._forget_places)

    def open(self) -> None:
        """Show both scans in one scene."""
        if self._display.content is None:
            self._telling.tell(self.tr("Open two surfaces first"), "note")
            return
        if self._view is None:
            self._view = view = self._make(self.panel)
            view.pointed.connect(self._read)
            view.clicked.connect(self._click)
            view.flickered.connect(lambda: self.change(self.state.flickered()))
        self._view.raise_up()
        self._show()

    def close(self) -> None:
        """Let go of the view, before the application ends."""
        if self._view is not None:
            self._view.close_for_good()
            self._view = None

    def change(self, state: Superimposition) -> None:
        """Look in another way."""
        self.state = state
        self._show()

    def look(self, view: str) -> None:
        """Look from a standard side."""
        if self._view is not None:
            self._view.look(view)

    def save_picture(self) -> None:
        """Ask where to, and write what is seen."""
        if self._view is None:
            return
        path, _ = self._asking.place(
            self.tr("Save picture"), "both.png", self.tr("Picture (*.png)")
        )
        if path is not None:
            target = path if path.suffix.lower() == ".png" else Path(f"{path}.png")
            png = QBuffer()
            self._view.picture().save(png, "PNG")  # type: ignore[call-overload]

            def write(stream: BinaryIO) -> None:
                stream.write(png.data().data())

            try:
                check_outputs([target], self._inputs(), (".png",))
                write_all({target: write})
            except OutputError as error:
                self._telling.tell(str(error))

    def _inputs(self) -> list[Path]:
        shown = self._workbench.shown
        return [] if shown is None else [path for path in shown.document.paths if path]

    def _show(self) -> None:
        content, state = self._display.content, self._display.state
        if self._view is None or content is None or not self._view.is_seen():
            return
        shown = self._workbench.shown
        moved = shown is not None and shown.document.motion != NOT_MOVED
        if not moved and self.state.before:
            self.state = replace(self.state, before=False)
        self.panel.show_state(self.state, moved=moved)
        scene = superimposed(content, state.colours, self.state, dark=state.dark)
        self._view.show_scene(scene)
        self._read(None)

    def _forget_places(self) -> None:
        self.places = []
        if self._view is not None:
            self._view.mark([])

    def measure(self, on: bool) -> None:
        """Measure between places that are clicked, or no longer."""
        self._measures = on
        self._forget_places()
        self._read(None)

    def _click(self, pointed: Pointed | None) -> None:
        if self._view is None or pointed is None or not self._measures:
            return
        self.places = [*(self.places if len(self.places) < 3 else []), pointed[2]]
        self._view.mark(self.places)
        self._read(pointed)

    def _read(self, pointed: Pointed | None) -> None:
        """Tell what lies under the pointer, on the cut, and between the places."""
        lines = [*self._under(pointed), *self._between(), *self._on_the_cut()]
        self.reading = "\n".join(lines)
        self.panel.read(self.reading)

    def _under(self, pointed: Pointed | None) -> list[str]:
        content, unit = self._display.content, self._display.unit
        if pointed is None or content is None or self._view is None:
            return []
        surface, number, place = pointed
        patch = content.geometry.patches[surface]
        triangles = patch.triangles if patch.data is None else patch.triangles[patch.data]
        lines = [self.tr("Surface {}").format(surface + 1)]
        if not self.state.before:
            where = np.array(place[:2]) + content.geometry.origin[:2]
            d = difference_at(content.comparison, surface, triangles[number], where)
            if math.isfinite(d):
                lines.append(self.tr("along the view: {} {}").format(three(d), unit))
        away = math.dist(place, self._view.nearest(1 - surface, place))
        lines.append(self.tr("nearest place of the other: {} {}").format(three(away), unit))
        return lines

    def _between(self) -> list[str]:
        unit, places = self._display.unit, self.places
        lines = [
            self.tr("distance: {} {}").format(three(math.dist(one, two)), unit)
            for one, two in pairwise(places)
        ]
        if len(places) == 3:
            one, two = (np.subtract(places[k], places[1]) for k in (0, 2))
            across = float(np.linalg.norm(np.cross(one, two)))
            angle = math.degrees(math.atan2(across, float(one @ two)))
            lines.append(self.tr("angle: {}°").format(three(angle)))
        return lines

    def _on_the_cut(self) -> list[str]:
        content, cut = self._display.content, self.state.cut
        if content is None or cut is None:
            return []
        d = np.abs(content.once(profile_on, content.comparison, content.geometry, cut).difference)
        if not np.isfinite(d).any():
            return [self.tr("on the cut there is nothing to compare")]
        largest = three(float(np.nanmax(d)))
        return [self.tr("on the cut at most {} {}").format(largest, self._display.unit)]
