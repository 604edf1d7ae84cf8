"""What is on the workbench: takes files in, keeps the history, has the core run."""

import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal

from app.controllers.display import Display
from app.jobs.comparing import Compared, compared
from app.jobs.runner import Runner
from app.model.document import Document
from app.model.history import History, Step
from app.model.view_state import Kept, Of, ScaleChoice, ViewState
from app.scene.camera import Camera
from surfcmp_core.comparing.options import NOT_MOVED
from surfcmp_core.report.record import unit_of

MERGED_SECONDS = 0.6
"""Changes of the scale that follow each other so fast are one drag, and one step."""


class Workbench(QObject):
    """The steps so far, and the comparison that belongs to the one in force.

    A step is a document and the kept part of the view. Every change of either is a step, but for
    what the view takes over from a finished comparison: that belongs to the document's own step.
    """

    changed = Signal()
    """Another step is in force, or work has begun or ended."""
    compared = Signal(object)
    """Compared: a comparison is finished; the display has it next."""
    failed = Signal(str)

    def __init__(self, display: Display) -> None:
        super().__init__()
        self._display = display
        self._view = display.state.kept
        self.history = History(Step(Document(), self._view))
        self.runner = Runner()
        self.shown: Compared | None = None
        self._follows = False
        """Whether changes of the view follow from a comparison."""
        self._loaded: tuple[ViewState, Camera | None] | None = None
        """The view of a session that is opened."""
        self._restores = False
        """Whether the view of the step is to be restored with its comparison."""
        self._last = 0.0
        self._fitted: tuple[Path | None, Path | None] = (None, None)
        """The pair that the range was last fitted to."""
        display.changed.connect(self._keep_view)
        self.runner.finished.connect(self._finish)
        self.runner.failed.connect(self._fail)
        self.runner.cancelled.connect(self._back)

    @property
    def document(self) -> Document:
        """The document in force."""
        return self.history.current.document

    @property
    def unit(self) -> str:
        """The length unit of the numbers shown; empty where nothing is."""
        return "" if self.shown is None else unit_of(self.shown.comparison)

    def open(self, paths: Sequence[Path], number: int | None = None) -> None:
        """Take in one surface as `number` (or the one missing), or two as both."""
        files = [path.absolute() for path in paths]
        document = self.document
        if len(files) >= 2:
            document = Document((files[0], files[1]), document.options).asking(
                align=NOT_MOVED, project="z"
            )
        elif files:
            missing = 1 if document.paths[0] is None else 2
            document = document.with_path(number or missing, files[0])
        self.set_document(document)

    def set_document(self, document: Document, **view: Any) -> None:
        """Put another document in force, with fields of the view, and compare if complete."""
        old = self.history.current
        kept = replace(old.view, **view)
        if not document.same_places(old.document):
            kept = kept.without(Of.PLACES)
        if document.paths != old.document.paths:
            kept, self._restores = kept.without(Of.FILES), False
        if document == old.document:
            self._display.change(**view)
        elif self._push(Step(document, kept)):
            self._follow(replace(self._display.state, **view))
            self._run()

    def restore(self, document: Document, state: ViewState, camera: Camera | None = None) -> None:
        """Put a document in force that was looked at in this way, from there."""
        self._push(Step(document, state.kept))
        self._loaded, self._restores = (state, camera), True
        self._run()

    def undo(self) -> None:
        """Step back."""
        self.history.undo()
        self._restores = True
        self._run()

    def redo(self) -> None:
        """Step forward again."""
        self.history.redo()
        self._restores = True
        self._run()

    def _push(self, step: Step) -> bool:
        now = time.monotonic()
        merged, self._last = now - self._last < MERGED_SECONDS, now
        return self.history.push(step, merged=merged)

    def _keep_view(self) -> None:
        """Make a step of what changed in the view."""
        old, self._view = self._view, self._display.state.kept
        step = self.history.current
        view = step.view.changed_as(old, self._view)
        if self._follows:
            self.history.amend(view)
        elif self._push(replace(step, view=view)):
            self.changed.emit()

    def _run(self) -> None:
        document = self.document
        self.runner.stop()
        if document.complete and (self.shown is None or document != self.shown.document):
            before = self.shown
            self.runner.start(lambda progress: compared(document, before, progress))
        elif self._restores:
            self._restore(self.history.current.view)
        elif self.shown is not None:
            self.history.amend(self._display.state.kept)
        self.changed.emit()

    def _finish(self, result: Compared) -> None:
        before, self.shown = self.shown, result
        self.history.begin()
        view = self.history.current.view
        self._follows = True
        if before is not None and before.document.paths != result.document.paths:
            self._display.show(self._display.state.without(Of.FILES))
        self.compared.emit(result)
        self._display.set_content(result.content, self.unit, self._scale_of(result))
        if self._restores:
            self._restore(view)
        self._follows = False
        self.history.amend(self._display.state.kept)
        self.changed.emit()

    def _scale_of(self, result: Compared) -> ScaleChoice:
        """Give the scale for a result: its range fits a new pair, unless the user fixed it."""
        scale = replace(self._display.state.scale, tolerances=result.document.options.tolerances)
        if not scale.pinned and result.document.paths != self._fitted:
            scale = replace(scale, limit=result.content.distributions.fitting_end)
        self._fitted = result.document.paths
        return scale

    def _restore(self, view: Kept) -> None:
        """Look at what is shown as its step says."""
        now = self._display.state
        state, camera = self._loaded or (now, None)
        self._loaded, self._restores = None, False
        state = state.keeping(view).in_window_of(now)
        if self.shown is not None:
            state = state.within(len(self.shown.comparison.united.triangles))
        self._follow(state)
        if camera is not None:
            self._display.fly(camera)

    def _follow(self, state: ViewState) -> None:
        """Change the view as a part of the current step."""
        follows, self._follows = self._follows, True
        self._display.show(state)
        self._follows = follows

    def _fail(self, message: str) -> None:
        self._back()
        self.failed.emit(message)

    def _back(self) -> None:
        """Return to the document of what is shown, so that inputs and numbers belong together."""
        self._loaded, self._restores = None, False
        if self.shown is None:
            self.history.drop()
        else:
            document = self.shown.document
            self.history.go_to(document)
            state, tolerances = self._display.state, document.options.tolerances
            self._follow(replace(state, scale=replace(state.scale, tolerances=tolerances)))
            self._push(Step(document, self._display.state.kept))
        self.changed.emit()
