"""Takes in files: named by the command, chosen, dropped."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject

from app import settings
from app.controllers.asking import Asking, Telling
from app.controllers.workbench import Workbench
from app.jobs.comparing import Compared
from app.model.session_text import ENDING
from surfcmp_core.io.read import READERS
from surfcmp_core.io.samples import sample_pair


class Opening(QObject):
    """Finds out which file is which surface."""

    def __init__(
        self,
        workbench: Workbench,
        telling: Telling,
        asking: Asking,
        open_session: Callable[[Path], object],
    ) -> None:
        super().__init__()
        self._workbench = workbench
        self._telling = telling
        self._asking = asking
        self._open_session = open_session
        workbench.compared.connect(_remember)

    def begin(self, paths: list[Path]) -> None:
        """Open what the command named, or the sample."""
        if paths:
            self.take(paths)
        else:
            self.open_sample()

    def take(self, paths: list[Path]) -> None:
        """Take in dropped files; one file asks where it belongs if both places are taken."""
        if len(paths) == 1 and paths[0].suffix == ENDING:
            self._open_session(paths[0])
        elif len(paths) > 2:
            text = self.tr("Two surfaces at a time, please: {} files were dropped")
            self._telling.tell(text.format(len(paths)))
        elif len(paths) == 1 and self._workbench.document.complete:
            answers = {
                self.tr("Use as surface {}").format(number): partial(
                    self._workbench.open, paths, number
                )
                for number in (1, 2)
            }
            self._asking.choose(paths[0].name, answers)
        elif paths:
            self._workbench.open(paths)

    def open_sample(self) -> None:
        """Open the built-in pair."""
        try:
            self._workbench.open(sample_pair("face"))
        except FileNotFoundError as error:
            self._telling.tell(str(error))

    def open_both(self) -> None:
        """Ask for two files."""
        self.take(self._asking.files(self.tr("Open two surfaces"), self._kinds()))

    def open_one(self, number: int) -> None:
        """Ask for one file, to be surface `number`."""
        path = self._asking.file(self.tr("Open surface {}").format(number), kinds=self._kinds())
        if path is not None:
            self._workbench.open([path], number)

    def open_missing(self) -> None:
        """Ask for the file that is missing to a pair, or for both."""
        paths = self._workbench.document.paths
        if any(paths) and not all(paths):
            self.open_one(1 if paths[0] is None else 2)
        else:
            self.open_both()

    def swap_surfaces(self) -> None:
        """Exchange surfaces 1 and 2."""
        if self._workbench.document.complete:
            self._workbench.set_document(self._workbench.document.swapped())

    def _kinds(self) -> str:

        globs = " ".join("*" + ending for ending in READERS)
        return self.tr("Surfaces ({})").format(globs)


def _remember(result: Compared) -> None:
    one, two = result.document.paths
    if one and two:
        settings.remember_pair((one, two))
