"""A panel's dock: has a title where nothing else says its name."""

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QDockWidget, QMainWindow, QScrollArea, QWidget

from app.theme import UNIT


class Dock(QDockWidget):
    """Can be moved, undocked and closed; behind tabs the tab is its title and its handle."""

    def __init__(self, name: str, title: str, panel: QWidget, window: QMainWindow) -> None:
        super().__init__(title, window)
        self._window = window
        self._bare = QWidget()  # takes no place
        self.setObjectName(name)
        scroll = QScrollArea()  # a small screen must not be too small for any panel
        scroll.setWidgetResizable(True)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setMinimumSize(40 * UNIT, 14 * UNIT)
        scroll.setWidget(panel)
        self.setWidget(scroll)

    def settle(self) -> None:
        """Show a title unless it stands behind tabs."""
        tabbed = bool(self._window.tabifiedDockWidgets(self))
        bar = self._bare if tabbed and not self.isFloating() else None
        if self.titleBarWidget() is not bar:
            self.setTitleBarWidget(bar)  # type: ignore[arg-type]


class Docks:
    """All docks of a window, and how they stood at first."""

    def __init__(self, window: QMainWindow) -> None:
        self._window = window
        self.all: list[Dock] = []
        self._soon = QTimer(window, singleShot=True, interval=0)
        self._soon.timeout.connect(self._settle)

    def add(self, name: str, title: str, panel: QWidget) -> Dock:
        """Dock a panel at the right."""
        dock = Dock(name, title, panel, self._window)
        self._window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
        for moved in (dock.topLevelChanged, dock.dockLocationChanged, dock.visibilityChanged):
            moved.connect(lambda _: self._soon.start())
        self.all.append(dock)
        return dock

    def _settle(self) -> None:
        for dock in self.all:
            dock.settle()
