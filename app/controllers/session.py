"""What is compared: takes files in, keeps the history, has the core run."""

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from app.jobs.comparing import Compared, compared
from app.jobs.runner import Runner
from app.model.document import Document
from app.model.history import History


class Session(QObject):
    """The documents so far, and the comparison that belongs to the one in force."""

    changed = Signal()
    """Another document is in force, or work has begun or ended."""
    compared = Signal(object)
    """Compared: a comparison is finished."""
    failed = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.history = History(Document())
        self.runner = Runner()
        self.shown: Compared | None = None
        self.runner.finished.connect(self._finish)
        self.runner.failed.connect(self._fail)
        self.runner.cancelled.connect(self._back)

    @property
    def document(self) -> Document:
        """The document in force."""
        return self.history.current

    def open(self, paths: Sequence[Path], number: int | None = None) -> None:
        """Take in one surface as `number` (or the one missing), or two as both."""
        files = [path.absolute() for path in paths]
        document = self.document
        if len(files) >= 2:
            document = Document((files[0], files[1]), document.options, unit=document.unit)
        elif files:
            missing = 1 if document.paths[0] is None else 2
            document = document.with_path(number or missing, files[0])
        self.set_document(document)

    def set_document(self, document: Document) -> None:
        """Put another document in force and compare where it is complete."""
        if self.history.push(document):
            self._run()

    def undo(self) -> None:
        """Step back to the document before."""
        self.history.undo()
        self._run()

    def redo(self) -> None:
        """Step forward again."""
        self.history.redo()
        self._run()

    def _run(self) -> None:
        document = self.document
        self.runner.stop()
        if document.complete and (self.shown is None or document != self.shown.document):
            before = self.shown
            self.runner.start(lambda progress: compared(document, before, progress))
        self.changed.emit()

    def _finish(self, result: Compared) -> None:
        self.shown = result
        self.compared.emit(result)
        self.changed.emit()

    def _fail(self, message: str) -> None:
        self._back()
        self.failed.emit(message)

    def _back(self) -> None:
        """Return to the document of what is shown, so that inputs and numbers belong together."""
        self.history.drop()
        if self.shown is not None:
            self.history.push(self.shown.document)
        self.changed.emit()
