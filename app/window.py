"""The main window, and the program around it."""

import gc
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, override

from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import (
    QApplication,
    QLabel,
    QMainWindow,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from app import settings
from app.actions import Actions
from app.controllers.display import Display
from app.look.theme import UNIT, qt_palette, style_sheet, theme
from app.panels.alignment_panel import AlignmentPanel
from app.panels.banner import Banner
from app.panels.chains_panel import ChainsPanel
from app.panels.dialogs import Dialogs
from app.panels.dock import Docks
from app.panels.empty import EmptyState
from app.panels.measures_panel import MeasuresPanel
from app.panels.options_panel import OptionsPanel
from app.panels.probes_panel import ProbesPanel
from app.panels.progress_line import ProgressStrip
from app.panels.regions_panel import RegionsPanel
from app.panels.scale_panel import ScalePanel
from app.panels.section_panel import SectionPanel
from app.panels.superimposition_panel import SuperimpositionPanel
from app.panels.toolbar import Toolbar
from app.views.four_views import ViewGrid
from surfcmp_core.system.children import end_children

if TYPE_CHECKING:
    from app.controllers.aligning import Aligning
    from app.controllers.chain_choice import ChainChoice
    from app.controllers.colour_range import Scaling
    from app.controllers.exporting import Exporting
    from app.controllers.marking import Regions
    from app.controllers.opening import Opening
    from app.controllers.probing import Places
    from app.controllers.saving import Sessions
    from app.controllers.superimposing import SceneView, Superimposing
    from app.controllers.workbench import Workbench
    from app.jobs.runner import Runner

CLOSING_SECONDS = 0.3
"""How long closing waits for what runs; then the process ends without it."""


class MainWindow(QMainWindow):
    """Puts the parts together; what they do stands in their own files."""

    workbench: "Workbench"
    opening: "Opening"
    scaling: "Scaling"
    places: "Places"
    chains_of: "ChainChoice"
    exporting: "Exporting"
    regions_of: "Regions"
    alignment_of: "Aligning"
    sessions: "Sessions"
    superimposing: "Superimposing"

    def __init__(self) -> None:
        super().__init__()
        self.setWindowTitle("surfcmp")
        self.setAcceptDrops(True)
        self.resize(1360, 900)
        self.banner = Banner()
        self.dialogs = Dialogs(self)
        self.empty = EmptyState()
        self.grid = ViewGrid(
            [
                self.tr("Surface 1"),
                self.tr("Surface 2"),
                self.tr("United triangulation"),
                self.tr("Difference"),
            ]
        )
        self.pages = QStackedWidget()
        self.pages.addWidget(self.empty)
        self.pages.addWidget(self.grid)
        middle = QWidget()
        column = QVBoxLayout(middle)
        column.setContentsMargins(UNIT, UNIT, 0, UNIT)
        column.setSpacing(UNIT)
        column.addWidget(self.banner)
        column.addWidget(self.pages, 1)
        self.setCentralWidget(middle)
        self.toolbar = Toolbar()
        self.toolbar.setObjectName("toolbar")
        self.addToolBar(self.toolbar)
        self.measures = MeasuresPanel()
        self.scale = ScalePanel()
        self.docks = Docks(self)
        self.docks.add("measures", self.tr("Measures"), self.measures)
        self.regions = RegionsPanel()
        self.docks.add("regions", self.tr("Regions"), self.regions)
        self.chains = ChainsPanel()
        self.docks.add("chains", self.tr("Chains"), self.chains)
        self.probes = ProbesPanel()
        self.docks.add("probes", self.tr("Places"), self.probes)
        upper = self.docks.all[:]
        self.section = SectionPanel()
        self.alignment = AlignmentPanel()
        self.options = OptionsPanel()
        self.docks.add("scale", self.tr("Scale"), self.scale)
        self.docks.add("section", self.tr("Section"), self.section)
        self.docks.add("alignment", self.tr("Alignment"), self.alignment)
        self.docks.add("options", self.tr("Options"), self.options)
        lower = self.docks.all[len(upper) :]
        self.status = QLabel()
        self.status.setContentsMargins(UNIT, 0, 0, 0)
        self.progress = ProgressStrip()
        self.statusBar().addWidget(self.status, 1)
        self.statusBar().addPermanentWidget(self.progress)
        self.statusBar().setSizeGripEnabled(False)
        self.docks.arrange(upper, lower)
        self.display = Display(self.grid)
        self.actions_of = Actions(self, self.display, self.grid, self.docks, self.measures)
        self.display.change(dark=settings.dark_wanted())
        self.dress(self.display.state.dark)
        geometry, arrangement = settings.window_layout()
        self.restoreGeometry(geometry)
        self.restoreState(arrangement)
        self.ended = True

    def start(self) -> None:
        """Load the core and tie it to the window, which is on the screen by then."""
        from app.controllers.aligning import Aligning
        from app.controllers.captions import Captions
        from app.controllers.chain_choice import ChainChoice
        from app.controllers.colour_range import Scaling
        from app.controllers.exporting import Exporting
        from app.controllers.front import Front
        from app.controllers.marking import Regions
        from app.controllers.opening import Opening
        from app.controllers.probing import Places
        from app.controllers.saving import Sessions
        from app.controllers.sectioning import Section
        from app.controllers.superimposing import Superimposing
        from app.controllers.work import Work
        from app.controllers.workbench import Workbench

        gc.disable()
        self.display.warm_up()
        display, telling = self.display, self.banner
        self.workbench = workbench = Workbench(display)
        self.sessions = Sessions(workbench, display, telling, self.dialogs)
        self.opening = Opening(workbench, telling, self.dialogs, self.sessions.open)
        self.scaling = Scaling(workbench, display, self.scale)
        self.places = Places(display, self.probes)
        self.chains_of = ChainChoice(workbench, display, self.chains)
        self.regions_of = Regions(workbench, display, self.regions, telling, self.dialogs)
        self.alignment_of = Aligning(workbench, display, self.alignment, self.regions_of, telling)
        self.superimposing = Superimposing(
            workbench, display, SuperimpositionPanel(), _view_of_both, telling, self.dialogs
        )
        captions = Captions(display, self.grid.frames)
        self.exporting = Exporting(workbench, display, self.grid, captions, telling, self.dialogs)
        self._tied = (
            captions,
            Section(display, self.section),
            Front(workbench, display, self, self.toolbar, self.measures, telling),
            Work(
                workbench,
                self.opening,
                self.toolbar,
                self.empty,
                self.options,
                self.progress,
                telling,
            ),
        )
        self.actions_of.tie(
            workbench,
            self.opening,
            self.sessions,
            self.exporting,
            self.places,
            self.superimposing,
        )
        workbench.compared.connect(collect_garbage)
        workbench.failed.connect(collect_garbage)

    def show_views(self, there: bool) -> None:
        """Show the views, or what to do where there is nothing to view."""
        page = self.grid if there else self.empty
        if self.pages.currentWidget() is not page:
            self.pages.setCurrentWidget(page)
            if there:
                self.grid.setFocus()

    def show_heading(self, title: str, summary: str) -> None:
        """Show what is compared, and in short what came of it."""
        self.setWindowTitle(title)
        self.status.setText(summary)

    def dress(self, dark: bool) -> None:
        """Put on the dark or the light theme."""
        colours = theme(dark)
        app = QApplication.instance()
        assert isinstance(app, QApplication)
        app.setPalette(qt_palette(colours))
        app.setStyleSheet(style_sheet(colours))
        self.grid.dress(colours)
        self.measures.dress(colours)

    @property
    def runners(self) -> "tuple[Runner, ...]":
        """All that can be at work beside the window."""
        return (
            self.workbench.runner,
            self.exporting.runner,
            self.alignment_of.runner,
            self.sessions.saving,
            self.sessions.opening,
        )

    @override
    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if event.mimeData().hasUrls():
            event.acceptProposedAction()

    @override
    def dropEvent(self, event: QDropEvent) -> None:
        paths = [Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()]
        event.acceptProposedAction()
        self.opening.take(paths)

    @override
    def closeEvent(self, event: QCloseEvent) -> None:
        settings.remember_layout(self.saveGeometry(), self.saveState())
        self.hide()
        self.superimposing.close()
        for runner in self.runners:
            runner.stop()
        self.ended = self.display.close(CLOSING_SECONDS)
        for runner in self.runners:
            self.ended &= runner.wait(CLOSING_SECONDS if self.ended else 0.0)
        self.sessions.close()  # when nothing is unpacked any longer
        super().closeEvent(event)


def _view_of_both(panel: SuperimpositionPanel) -> "SceneView":
    """Make the view of both scans; what it needs is loaded only now."""
    from app.views.both_scans import SuperimpositionView

    return SuperimpositionView(panel)


def collect_garbage(_: object) -> None:
    """Begin to look for garbage; what is loaded by now is none.

    While all is being loaded nothing is to be found, and each look would make the window late.
    """
    if not gc.isenabled():
        gc.freeze()
        gc.enable()


def run(paths: list[Path]) -> int:
    """Show the window with these files, or with the sample pair; return the exit status."""
    app = QApplication.instance() or QApplication(sys.argv[:1])
    assert isinstance(app, QApplication)
    app.setApplicationName("surfcmp")
    app.setStyle("Fusion")
    window = MainWindow()
    window.show()
    app.processEvents()  # the window is seen while the core is loaded
    window.start()
    if paths or not window.sessions.offer_recovery():
        window.opening.begin(paths)
    status = app.exec()
    end_children()
    if not window.ended:  # a kernel or a picture cannot be stopped half way; all is saved
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)
    return status
