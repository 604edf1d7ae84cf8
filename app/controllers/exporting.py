"""Asks where to, and has results written beside the window."""

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QBuffer, QIODevice, QObject
from PySide6.QtGui import QImage, QPixmap
from PySide6.QtWidgets import QFileDialog, QWidget

from app.jobs.exporting import Picture, export
from app.jobs.runner import Runner
from app.theme import theme

if TYPE_CHECKING:
    from app.window import MainWindow


REPORTS = (".html", ".pdf")
REPORT_DENSITY = 2
"""Pixels of a report's pictures for each one of the screen, along each side."""


class Exporting(QObject):
    """Reports, pictures and data of what is shown."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        self.runner = Runner()
        self.runner.finished.connect(self._finished)
        self.runner.failed.connect(window.banner.tell)

    @property
    def hide_names(self) -> bool:
        """Whether names and paths of files are left out."""
        return self._window.actions_of.hide.isChecked()

    def ask(self, ending: str) -> None:
        """Ask for a file with this ending and write it."""
        if self._window.session.shown is None:
            self._window.banner.tell(self.tr("There is nothing to export yet"), "note")
            return
        name = QFileDialog.getSaveFileName(
            self._window, self.tr("Export"), f"comparison{ending}", f"*{ending}"
        )[0]
        if name:
            self.write(Path(name).with_suffix(ending))

    def ask_report(self) -> None:
        """Ask for a name and write the report twice: as a page, and on paper."""
        if self._window.session.shown is None:
            self._window.banner.tell(self.tr("There is nothing to export yet"), "note")
            return
        name = QFileDialog.getSaveFileName(
            self._window, self.tr("Report"), "comparison.html", "*.html"
        )[0]
        if name:
            self.write(*(Path(name).with_suffix(ending) for ending in REPORTS))

    def write(self, *paths: Path) -> None:
        """Write what is shown now, all files or none; the endings say the formats."""
        result, hide = self._window.session.shown, self.hide_names
        if result is None:
            return
        state = self._window.display.state

        def begin(pictures: list[Picture]) -> None:
            self.runner.start(lambda _progress: export(result, state, paths, pictures, hide))

        if any(path.suffix in REPORTS for path in paths):
            display = self._window.display
            display.print(REPORT_DENSITY, lambda: begin(self.pictures(REPORT_DENSITY)), light=True)
        else:
            begin([])

    def ask_views(self, density: int) -> None:
        """Ask for a file and write the views as one picture, so many times as fine as here."""
        name = QFileDialog.getSaveFileName(
            self._window, self.tr("Picture of the views"), "views.png", "*.png"
        )[0]
        if name:
            path = Path(name).with_suffix(".png")
            self._window.display.print(density, lambda: self.write_views(path, density))

    def write_views(self, path: Path, density: int) -> None:
        """Write the views as they stand, with `density` times the pixels of the screen."""
        if self.picture_of_views(density).save(str(path)):
            self._finished(str(path))
        else:
            self._window.banner.tell(self.tr("{} cannot be written").format(path.name))

    def picture_of_views(self, density: int) -> QPixmap:
        """Return the views with their titles."""
        grid = self._window.grid
        if self.hide_names:
            for frame in grid.frames[:2]:
                frame.title.set_texts(frame.title.text, "")
        picture = _drawn(grid, density)
        if self.hide_names:
            self._window.display.changed.emit()  # the names are shown again
        return picture

    def pictures(self, density: int) -> list[Picture]:
        """Return each visible view with its scale and legend, light as paper, as PNG files."""
        grid, showing, state = self._window.grid, self._window.showing, self._window.display.state
        grid.dress(theme(False))
        showing.explain(replace(state, dark=False))
        found = [
            (frame.title.text, _png(_drawn(frame.canvas, density).toImage()))
            for frame in grid.frames
            if frame.isVisible()
        ]
        grid.dress(theme(state.dark))
        showing.explain(state)
        return found

    def _finished(self, names: str) -> None:
        self._window.banner.tell(self.tr("Saved {}").format(names), "note")


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
