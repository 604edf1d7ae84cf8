"""Ties the workbench to what shows which surfaces are open, how, and whether work goes on."""

from PySide6.QtCore import QObject

from app.controllers.asking import Telling
from app.controllers.opening import Opening
from app.controllers.workbench import Workbench
from app.panels.empty import EmptyState
from app.panels.options_panel import OptionsPanel
from app.panels.progress_line import ProgressStrip
from app.panels.toolbar import Toolbar


class Work(QObject):
    """Follows the document in force and the work on it."""

    def __init__(
        self,
        workbench: Workbench,
        opening: Opening,
        toolbar: Toolbar,
        empty: EmptyState,
        options: OptionsPanel,
        progress: ProgressStrip,
        telling: Telling,
    ) -> None:
        super().__init__()
        self._workbench = workbench
        self._toolbar = toolbar
        self._empty = empty
        self._options = options
        self._progress = progress
        self._telling = telling
        toolbar.surface_asked.connect(opening.open_one)
        toolbar.swap_asked.connect(opening.swap_surfaces)
        empty.open_asked.connect(opening.open_missing)
        empty.sample_asked.connect(opening.open_sample)
        options.changed.connect(workbench.set_document)
        progress.cancel_asked.connect(workbench.runner.cancel)
        workbench.runner.progressed.connect(progress.tell)
        workbench.failed.connect(telling.tell)
        workbench.changed.connect(self._show)
        self._show()

    def _show(self) -> None:
        document, busy = self._workbench.document, self._workbench.runner.busy
        self._toolbar.show_paths(document.paths)
        self._empty.tell(document.paths, busy)
        self._options.show_document(document)
        if not busy:
            self._progress.hide()
        elif not self._progress.isVisible():
            self._progress.begin()
            self._telling.hide()
