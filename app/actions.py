"""What the user can do, under menus and shortcuts."""

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu

from app import settings
from app.controllers.display import Display
from app.look.texts import QT_TRANSLATE_NOOP
from app.model.history import Change
from app.model.tool import Tool
from app.panels.command_palette import CommandPalette
from app.panels.dock import Docks
from app.panels.help import HelpDialog, HelpPages
from app.panels.measures_panel import MeasuresPanel
from app.scene.scene import VIEWS
from app.views.four_views import ViewGrid

if TYPE_CHECKING:  # the menus are on the screen before the core is loaded
    from app.controllers.exporting import Exporting
    from app.controllers.opening import Opening
    from app.controllers.probing import Places
    from app.controllers.saving import Sessions
    from app.controllers.superimposing import Superimposing
    from app.controllers.workbench import Workbench

KINDS = {
    ".html": QT_TRANSLATE_NOOP("Actions", "Report as a page"),
    ".pdf": QT_TRANSLATE_NOOP("Actions", "Report on paper"),
    ".png": QT_TRANSLATE_NOOP("Actions", "Map of the difference"),
    ".csv": QT_TRANSLATE_NOOP("Actions", "Triangles as a table"),
    ".vtp": QT_TRANSLATE_NOOP("Actions", "Mesh with values for ParaView"),
    ".ply": QT_TRANSLATE_NOOP("Actions", "Mesh with values"),
    ".npz": QT_TRANSLATE_NOOP("Actions", "Arrays for NumPy"),
    ".json": QT_TRANSLATE_NOOP("Actions", "Result as data"),
}
"""What can be exported, by ending."""


class Actions(QObject):
    """The menus of a window, and what stands behind them.

    They are there before the core is loaded; until `tie` nothing can be done with them.
    """

    _workbench: "Workbench"
    _opening: "Opening"
    _sessions: "Sessions"
    _exporting: "Exporting"
    _places: "Places"
    _superimposing: "Superimposing"

    def __init__(
        self,
        window: QMainWindow,
        display: Display,
        grid: ViewGrid,
        docks: Docks,
        measures: MeasuresPanel,
    ) -> None:
        super().__init__(window)
        self._window = window
        self._display = display
        self._grid = grid
        self.all: list[QAction] = []
        bar = window.menuBar()
        file = bar.addMenu(self.tr("&File"))
        self._add(file, self.tr("&Open two surfaces…"), lambda: self._opening.open_both(), "Ctrl+O")
        self._add(file, self.tr("Open surface &1…"), lambda: self._opening.open_one(1), "Ctrl+1")
        self._add(file, self.tr("Open surface &2…"), lambda: self._opening.open_one(2), "Ctrl+2")
        self._add(file, self.tr("Open the &sample faces"), lambda: self._opening.open_sample())
        self.recent = file.addMenu(self.tr("&Recent"))
        self.recent.aboutToShow.connect(self._list_recent)
        file.addSeparator()
        self._add(file, self.tr("&Save the session"), lambda: self._sessions.save_again(), "Ctrl+S")
        elsewhere = self.tr("Save the session as…")
        self._add(file, elsewhere, lambda: self._sessions.ask_save(), "Ctrl+Shift+S")
        self._add(file, self.tr("Open a session…"), lambda: self._sessions.ask_open())
        self.export = file.addMenu(self.tr("&Export"))
        report = self.tr("Report as a page and on paper (.html, .pdf)…")
        self._add(self.export, report, lambda: self._exporting.ask_report(), "Ctrl+P")
        for ending, name in KINDS.items():
            text = f"{self.tr(name)} ({ending})…"
            self._add(self.export, text, partial(self._export, ending))
        for density in (2, 4):
            views = self.tr("Picture of the views, {} × the screen (.png)…").format(density)
            self._add(self.export, views, partial(self._export_views, density))
        self.export.addSeparator()
        self.hide = self._add(self.export, self.tr("Hide names and paths"), self._hide_names)
        self.hide.setCheckable(True)
        self.hide.setChecked(settings.names_hidden())
        file.addSeparator()
        self._add(file, self.tr("&Quit"), window.close, "Ctrl+Q")
        edit = bar.addMenu(self.tr("&Edit"))
        self.undo = self._add(edit, self.tr("&Undo"), lambda: self._workbench.undo(), "Ctrl+Z")
        self.redo = self._add(
            edit, self.tr("&Redo"), lambda: self._workbench.redo(), "Ctrl+Shift+Z"
        )
        edit.addSeparator()
        self.swap = self._add(
            edit, self.tr("&Exchange surfaces"), lambda: self._opening.swap_surfaces(), "Ctrl+E"
        )
        self._add(edit, self.tr("&Copy measures as table"), measures.copy_table)
        self.cancel = self._add(edit, self.tr("&Stop, or let go"), self.stop, "Esc")
        self.view_menu = bar.addMenu(self.tr("&View"))
        names = [frame.canvas.accessibleName() for frame in grid.frames]
        for view in range(VIEWS):
            text = self.tr("Only {}").format(names[view].lower())
            self._add(self.view_menu, text, partial(self._fill, view), str(view + 1))
        self._add(self.view_menu, self.tr("All four views"), lambda: self._fill(None), "0")
        both = self.tr("Both scans in one scene")
        self._add(self.view_menu, both, lambda: self._superimposing.open(), "5")
        self.view_menu.addSeparator()
        self._add(self.view_menu, self.tr("Map or relief"), self.toggle_relief, "M")
        self._add(self.view_menu, self.tr("Show everything"), display.go_home, "Home")
        above = self.tr("Look from above")
        self._add(self.view_menu, above, display.look_from_above, "T")
        self._add(self.view_menu, self.tr("Triangles' sides"), self.toggle_edges, "E")
        self._add(self.view_menu, self.tr("Dark or light"), self.toggle_dark, "Ctrl+D")
        keep = self.tr("Keep the label")
        self._add(self.view_menu, keep, lambda: self._places.keep(), "K")
        self.view_menu.addSeparator()
        tools = ((Tool.LOOK, "V"), (Tool.LASSO, "L"), (Tool.BRUSH, "B"), (Tool.SECTION, "S"))
        names_of = {
            Tool.LOOK: self.tr("Look around"),
            Tool.LASSO: self.tr("Draw around a region"),
            Tool.BRUSH: self.tr("Paint a region"),
            Tool.SECTION: self.tr("Draw a section"),
        }
        for tool, keys in tools:
            self._add(self.view_menu, names_of[tool], partial(display.use, tool), keys)
        self.view_menu.addSeparator()
        panels = self.view_menu.addMenu(self.tr("Panels"))
        for dock in docks.all:
            panels.addAction(dock.toggleViewAction())
        panels.addSeparator()
        self._add(panels, self.tr("Panels as at first"), docks.arrange_as_at_first)
        about = bar.addMenu(self.tr("&Help"))
        self._add(about, self.tr("&Guide"), self.show_guide, "F1")
        self._add(about, self.tr("&Keys and mouse"), self.show_shortcuts, "?")
        self._add(about, self.tr("&Find an action…"), self.show_palette, "Ctrl+K")
        self._add(about, self.tr("&About"), self.show_about)

    def tie(
        self,
        workbench: "Workbench",
        opening: "Opening",
        sessions: "Sessions",
        exporting: "Exporting",
        places: "Places",
        superimposing: "Superimposing",
    ) -> None:
        """Let the actions act."""
        self._workbench = workbench
        self._opening = opening
        self._sessions = sessions
        self._exporting = exporting
        self._places = places
        self._superimposing = superimposing
        workbench.changed.connect(self._follow)
        self._follow()

    def _follow(self) -> None:
        history = self._workbench.history
        self.show_steps(history.undoable, history.redoable)
        self.swap.setEnabled(self._workbench.document.complete)

    def show_steps(self, undoable: Change | None, redoable: Change | None) -> None:
        """Say what undo takes back and what redo does again."""
        names = self._change_names()
        undo, redo = self.tr("&Undo {}"), self.tr("&Redo {}")
        for action, text, change in ((self.undo, undo, undoable), (self.redo, redo, redoable)):
            action.setEnabled(change is not None)
            action.setText(text.format(names[change] if change else "").rstrip())

    def _change_names(self) -> dict[Change, str]:
        return {
            Change.SURFACES: self.tr("opening"),
            Change.MOTION: self.tr("alignment"),
            Change.OPTIONS: self.tr("option"),
            Change.REGIONS: self.tr("region"),
            Change.PAINT: self.tr("painting"),
            Change.REGION_NAME: self.tr("name of a region"),
            Change.REGION_COLOUR: self.tr("colour of a region"),
            Change.REGION_WEIGHT: self.tr("weight of a region"),
            Change.SCALE: self.tr("scale"),
            Change.HEATMAP: self.tr("choice of the map"),
            Change.EDGES: self.tr("triangles' sides"),
            Change.PROBES: self.tr("label"),
            Change.SECTION: self.tr("section"),
            Change.LANDMARKS: self.tr("landmark"),
            Change.VIEW: self.tr("view"),
        }

    def stop(self) -> None:
        """Stop comparing; where nothing runs, let go of what is picked, chosen or brushed."""
        if self._workbench.runner.busy:
            self._workbench.runner.cancel()
        else:
            self._display.use(Tool.LOOK)
            self._display.change(chain=None, picked=None, brush=None)

    def show_palette(self) -> None:
        """Let the user type what to do."""
        window = self._window
        palette = CommandPalette(window, self.all)
        corner = window.mapToGlobal(window.rect().center())
        palette.move(corner.x() - palette.width() // 2, corner.y() - palette.height() // 2)
        palette.show()
        palette.line.setFocus()

    def show_guide(self) -> None:
        """Open the guide, with pictures of what is shown now."""
        frames = self._grid.frames if self._display.content else []
        pictures = [frame.canvas.grab().toImage() for frame in frames]
        self._help(self.tr("Guide"), HelpPages().guide(pictures))

    def show_shortcuts(self) -> None:
        """Open the list of keys."""
        self._help(self.tr("Keys and mouse"), HelpPages().shortcuts(self.all))

    def show_about(self) -> None:
        """Say what the program is."""
        self._help(self.tr("About"), HelpPages().about())

    def _help(self, title: str, page: str) -> None:
        HelpDialog(self._window, title, page).show()

    def _list_recent(self) -> None:
        self.recent.clear()
        for pair in settings.recent_pairs():
            action = self.recent.addAction(" – ".join(path.name for path in pair))
            action.setToolTip("\n".join(map(str, pair)))
            action.triggered.connect(lambda _=False, p=pair: self._workbench.open(p))
        if self.recent.isEmpty():
            self.recent.addAction(self.tr("Nothing yet")).setEnabled(False)
        else:
            self.recent.addSeparator()
            forget = self.recent.addAction(self.tr("Forget these"))
            forget.triggered.connect(lambda _=False: settings.forget_pairs())

    def _export(self, ending: str) -> None:
        self._exporting.ask(ending)

    def _export_views(self, density: int) -> None:
        self._exporting.ask_views(density)

    def _hide_names(self) -> None:
        settings.hide_names(self.hide.isChecked())

    def _fill(self, view: int | None) -> None:
        self._display.change(filled=view)

    def toggle_relief(self) -> None:
        """Switch."""
        self._display.change(relief=not self._display.state.relief)

    def toggle_edges(self) -> None:
        """Switch."""
        self._display.change(edges=not self._display.state.edges)

    def toggle_dark(self) -> None:
        """Switch."""
        dark = not self._display.state.dark
        settings.remember_dark(dark)
        self._display.change(dark=dark)

    def _add(self, menu: QMenu, text: str, work: Callable[[], object], keys: str = "") -> QAction:
        action = QAction(text, self._window)
        action.triggered.connect(lambda: work())
        if keys:
            action.setShortcut(QKeySequence(keys))
        menu.addAction(action)
        self.all.append(action)
        return action
