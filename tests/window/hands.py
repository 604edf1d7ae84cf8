"""What a person's hands do."""

from pathlib import Path

import numpy as np
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from app.jobs.window_folder import WindowFolder
from app.window import MainWindow

LEFT = Qt.MouseButton.LeftButton


def drag(qtbot: QtBot, widget: QWidget, *places: tuple[float, float]) -> None:
    """Drag over a widget; places in shares of its width and height."""
    points = [QPoint(round(x * widget.width()), round(y * widget.height())) for x, y in places]
    qtbot.mousePress(widget, LEFT, pos=points[0])
    for point in points[1:]:
        qtbot.mouseMove(widget, point)
    qtbot.mouseRelease(widget, LEFT, pos=points[-1])


def kill(folder: WindowFolder) -> None:
    """Leave a window's folder as if its program had been killed."""
    aside = folder.path.rename(folder.path.with_name("aside"))
    folder.close()
    aside.rename(folder.path)
    folder.path.with_suffix(".lock").touch()


def show(window: MainWindow, name: str) -> None:
    dock = next(dock for dock in window.docks.all if dock.objectName() == name)
    dock.show()
    dock.raise_()


def drop(window: MainWindow, *paths: Path) -> None:
    """Drop files onto the window, as a file manager does."""
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    button, key = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    event = QDropEvent(QPointF(300, 300), Qt.DropAction.CopyAction, data, button, key)
    window.dragEnterEvent(event)  # type: ignore[arg-type]
    assert event.isAccepted()
    window.dropEvent(event)


def pixels(window: MainWindow, view: int) -> np.ndarray:
    """Return the picture on a view's canvas, (height, width, 4)."""
    image = window.grid.frames[view].canvas.grab().toImage()
    image = image.convertToFormat(image.Format.Format_RGBX8888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
    return rows[:, : 4 * image.width()].reshape(image.height(), image.width(), 4).copy()
