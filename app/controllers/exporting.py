"""Asks where to, and has results written beside the window."""

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QBuffer, QIODevice, QObject
from PySide6.QtGui import QImage, QPixmap
from PySide6.QtWidgets import QFileDialog

from app.jobs.exporting import Picture, export
from app.jobs.runner import Runner

if TYPE_CHECKING:
    from app.window import MainWindow


class Exporting(QObject):
    """Reports, pictures and data of what is shown."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        self.hide_names = False
        self.runner = Runner()
        self.runner.finished.connect(self._finished)
        self.runner.failed.connect(window.banner.tell)

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

    def write(self, path: Path) -> None:
        """Write what is shown now; the ending says the format."""
        result, hide = self._window.session.shown, self.hide_names
        if result is None:
            return
        pictures = self.pictures() if path.suffix == ".html" else []
        self.runner.start(lambda _progress: export(result, path, pictures, hide))

    def ask_views(self) -> None:
        """Ask for a file and write the views as one picture."""
        name = QFileDialog.getSaveFileName(
            self._window, self.tr("Picture of the views"), "views.png", "*.png"
        )[0]
        if name and not self.picture_of_views().save(name):
            self._window.banner.tell(self.tr("{} cannot be written").format(name))

    def picture_of_views(self) -> QPixmap:
        """Return the views as they are on the screen, twice as fine."""
        grid = self._window.grid
        picture = QPixmap(grid.size() * 2)
        picture.setDevicePixelRatio(2)
        grid.render(picture)
        return picture

    def pictures(self) -> list[Picture]:
        """Return each visible view with its scale and legend, as PNG files."""
        return [
            (frame.title.text, _png(frame.canvas.grab().toImage()))
            for frame in self._window.grid.frames
            if frame.isVisible()
        ]

    def _finished(self, path: Path) -> None:
        self._window.banner.tell(self.tr("Saved {}").format(path), "note")


def _png(image: QImage) -> bytes:
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    image.save(buffer, "PNG")  # type: ignore[call-overload]
    return bytes(buffer.data().data())
