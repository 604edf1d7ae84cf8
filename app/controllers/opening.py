"""Takes in files: named by the command, chosen, dropped."""

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtGui import QCursor
from PySide6.QtWidgets import QFileDialog, QMenu

from app.model.session_file import ENDING

if TYPE_CHECKING:
    from app.window import MainWindow

ENDINGS = ".ply .obj .stl .off .vtp .vtk .xyz .txt .csv .npy .npz .las .laz"
"""Of surfaces that can be read."""


class Opening(QObject):
    """Finds out which file is which surface."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window

    def begin(self, paths: list[Path]) -> None:
        """Open what the command named, or the sample."""
        if paths:
            self.take(paths)
        else:
            self.open_sample()

    def take(self, paths: list[Path]) -> None:
        """Take in dropped files; one file asks where it belongs if both places are taken."""
        session = self._window.session
        if len(paths) == 1 and paths[0].suffix == ENDING:
            self._window.sessions.open(paths[0])
        elif len(paths) > 2:
            text = self.tr("Two surfaces at a time, please: {} files were dropped")
            self._window.banner.tell(text.format(len(paths)))
        elif len(paths) == 1 and session.document.complete:
            self._ask(paths[0])
        elif paths:
            session.open(paths)

    def open_sample(self) -> None:
        """Open the built-in pair."""
        from surfcmp_core.samples import sample_pair

        try:
            self._window.session.open(sample_pair("face"))
        except FileNotFoundError as error:
            self._window.banner.tell(str(error))

    def open_both(self) -> None:
        """Ask for two files."""
        paths = self._choose(self.tr("Open two surfaces"), several=True)
        self.take(paths)

    def open_one(self, number: int) -> None:
        """Ask for one file, to be surface `number`."""
        paths = self._choose(self.tr("Open surface {}").format(number), several=False)
        if paths:
            self._window.session.open(paths, number)

    def swap_surfaces(self) -> None:
        """Exchange surfaces 1 and 2."""
        session = self._window.session
        if session.document.complete:
            session.set_document(session.document.swapped())

    def _choose(self, title: str, several: bool) -> list[Path]:
        globs = " ".join("*" + ending for ending in ENDINGS.split())
        kinds = self.tr("Surfaces ({})").format(globs)
        if several:
            names = QFileDialog.getOpenFileNames(self._window, title, "", kinds)[0]
        else:
            names = [QFileDialog.getOpenFileName(self._window, title, "", kinds)[0]]
        return [Path(name) for name in names if name]

    def _ask(self, path: Path) -> None:
        self.question = QMenu(self._window)
        self.question.addSection(path.name)
        for number in (1, 2):
            action = self.question.addAction(self.tr("Use as surface {}").format(number))
            action.triggered.connect(lambda _=False, n=number: self._window.session.open([path], n))
        self.question.popup(QCursor.pos())
