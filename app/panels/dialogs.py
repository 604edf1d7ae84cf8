"""Questions to the user, in the system's own windows."""

from collections.abc import Callable, Mapping
from pathlib import Path

from PySide6.QtGui import QColor, QCursor
from PySide6.QtWidgets import QColorDialog, QFileDialog, QMenu, QWidget


class Dialogs:
    """Asks over a window."""

    def __init__(self, over: QWidget) -> None:
        self._over = over
        self.question = QMenu(over)

    def file(self, title: str, start: str = "", kinds: str = "") -> Path | None:
        """Ask for a file that is there."""
        name = QFileDialog.getOpenFileName(self._over, title, start, kinds)[0]
        return Path(name) if name else None

    def files(self, title: str, kinds: str) -> list[Path]:
        """Ask for several of them."""
        names = QFileDialog.getOpenFileNames(self._over, title, "", kinds)[0]
        return [Path(name) for name in names]

    def place(self, title: str, start: str, kinds: str) -> tuple[Path | None, str]:
        """Ask where to write, and as which of the kinds."""
        name, kind = QFileDialog.getSaveFileName(self._over, title, start, kinds)
        return (Path(name) if name else None), kind

    def colour(self, title: str, old: tuple[int, int, int]) -> tuple[int, int, int] | None:
        """Ask for a colour."""
        chosen = QColorDialog.getColor(QColor(*old), self._over, title)
        return (chosen.red(), chosen.green(), chosen.blue()) if chosen.isValid() else None

    def choose(self, heading: str, answers: Mapping[str, Callable[[], object]]) -> None:
        """Offer things to do, where the mouse is; returns at once."""
        self.question.clear()
        self.question.addSection(heading)
        for text, work in answers.items():
            action = self.question.addAction(text)
            action.triggered.connect(lambda _=False, do=work: do())
        self.question.popup(QCursor.pos())
