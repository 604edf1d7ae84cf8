"""Asks where to, and has results written beside the window."""

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QBuffer, QIODevice, QObject
from PySide6.QtGui import QImage, QPixmap
from PySide6.QtWidgets import QWidget

from app import settings
from app.controllers.asking import Asking, Telling
from app.controllers.captions import Captions
from app.controllers.display import Display
from app.controllers.workbench import Workbench
from app.jobs.runner import Runner
from app.jobs.writing import export
from app.look.theme import theme
from app.views.four_views import ViewGrid

if TYPE_CHECKING:
    from surfcmp_core.report.page import Picture

REPORTS = (".html", ".pdf")
REPORT_DENSITY = 2
"""Pixels of a report's pictures for each one of the screen, along each side."""


class Exporting(QObject):
    """Reports, pictures and data of what is shown."""

    def __init__(
        self,
        workbench: Workbench,
        display: Display,
        grid: ViewGrid,
        captions: Captions,
        telling: Telling,
        asking: Asking,
    ) -> None:
        super().__init__()
        self._workbench = workbench
        self._display = display
        self._grid = grid
        self._captions = captions
        self._telling = telling
        self._asking = asking
        self.runner = Runner()
        self.runner.finished.connect(self._finished)
        self.runner.failed.connect(telling.tell)

    def ask(self, ending: str) -> None:
        """Ask for a file with this ending and write it."""
        path = self._ask_place(self.tr("Export"), f"comparison{ending}")
        if path is not None:
            self.write(path.with_suffix(ending))

    def ask_report(self) -> None:
        """Ask for a name and write the report twice: as a page, and on paper."""
        path = self._ask_place(self.tr("Report"), "comparison.html")
        if path is not None:
            self.write(*(path.with_suffix(ending) for ending in REPORTS))

    def _ask_place(self, title: str, start: str) -> Path | None:
        if self._workbench.shown is None:
            self._telling.tell(self.tr("There is nothing to export yet"), "note")
            return None
        return self._asking.place(title, start, f"*{Path(start).suffix}")[0]

    def write(self, *paths: Path) -> None:
        """Write what is shown now, all files or none; the endings say the formats."""
        result, hide = self._workbench.shown, settings.names_hidden()
        if result is None:
            return
        state = self._display.state

        def begin(pictures: "list[Picture]") -> None:
            self.runner.start(lambda _progress: export(result, state, paths, pictures, hide))

        if any(path.suffix in REPORTS for path in paths):
            display = self._display
            display.print(REPORT_DENSITY, lambda: begin(self.pictures(REPORT_DENSITY)), light=True)
        else:
            begin([])

    def ask_views(self, density: int) -> None:
        """Ask for a file and write the views as one picture, so many times as fine as here."""
        name = self._asking.place(self.tr("Picture of the views"), "views.png", "*.png")[0]
        if name is not None:
            path = name.with_suffix(".png")
            self._display.print(density, lambda: self.write_views(path, density))

    def write_views(self, path: Path, density: int) -> None:
        """Write the views as they stand, with `density` times the pixels of the screen."""
        if self.picture_of_views(density).save(str(path)):
            self._finished(str(path))
        else:
            self._telling.tell(self.tr("{} cannot be written").format(path.name))

    def picture_of_views(self, density: int) -> QPixmap:
        """Return the views with their titles."""
        grid, hide = self._grid, settings.names_hidden()
        if hide:
            for frame in grid.frames[:2]:
                frame.title.set_texts(frame.title.text, "")
        picture = _drawn(grid, density)
        if hide:
            self._display.changed.emit()  # the names are shown again
        return picture

    def pictures(self, density: int) -> "list[Picture]":
        """Return each visible view with its scale and legend, light as paper, as PNG files."""
        grid, captions, state = self._grid, self._captions, self._display.state
        grid.dress(theme(False))
        captions.explain(replace(state, dark=False))
        found = [
            (frame.title.text, _png(_drawn(frame.canvas, density).toImage()))
            for frame in grid.frames
            if frame.isVisible()
        ]
        grid.dress(theme(state.dark))
        captions.explain(state)
        return found

    def _finished(self, names: str) -> None:
        self._telling.tell(self.tr("Saved {}").format(names), "note")


def _drawn(widget: QWidget, density: int) -> QPixmap:
    """Draw a widget with `density` times its pixels on the screen."""
    ratio = density * widget.devicePixelRatioF()
    picture = QPixmap(widget.size() * ratio)
    picture.setDevicePixelRatio(ratio)
    widget.render(picture)
    return picture


def _png(image: QImage) -> bytes:
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    image.save(buffer, "PNG")  # type: ignore[call-overload]
    return bytes(buffer.data().data())
