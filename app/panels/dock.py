"""A panel's dock: has a title where nothing else says its name."""

from collections.abc import Sequence
from typing import override

from PySide6.QtCore import QByteArray, QEvent, QObject, QSize, Qt, QTimer
from PySide6.QtWidgets import QDockWidget, QMainWindow, QScrollArea, QTabWidget, QWidget

from app.look.theme import UNIT


class Shaft(QScrollArea):
    """As wide as its panel needs, but as low as a small screen needs."""

    def __init__(self, panel: QWidget) -> None:
        super().__init__()
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setWidget(panel)
        self._panel = panel

    @override
    def minimumSizeHint(self) -> QSize:
        bar = self.verticalScrollBar().sizeHint().width()
        wide = self._panel.minimumSizeHint().width() + bar
        return QSize(max(wide, 40 * UNIT), 14 * UNIT)

    @override
    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()
        return super().eventFilter(watched, event)


class Dock(QDockWidget):
    """Can be moved, undocked and closed; behind tabs the tab is its title and its handle."""

    def __init__(self, name: str, title: str, panel: QWidget, window: QMainWindow) -> None:
        super().__init__(title, window)
        self._window = window
        self._bare = QWidget()  # takes no place
        self.setObjectName(name)
        self.setWidget(Shaft(panel))

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
        self._first = QByteArray()
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

    def arrange(self, *groups: Sequence[Dock]) -> None:
        """Put each group of panels behind one row of tabs; their names stand there."""
        window, option = self._window, QMainWindow.DockOption
        window.setDockOptions(
            option.AllowTabbedDocks | option.AllowNestedDocks | option.GroupedDragging
        )
        window.setTabPosition(Qt.DockWidgetArea.RightDockWidgetArea, QTabWidget.TabPosition.North)
        for group in groups:
            for dock in group[1:]:
                window.tabifyDockWidget(group[0], dock)
            group[0].raise_()
        heads = [group[0] for group in groups]
        window.resizeDocks(heads, [376] * len(heads), Qt.Orientation.Horizontal)
        self._first = window.saveState()

    def arrange_as_at_first(self) -> None:
        """Put all panels back where they were at the first start."""
        self._window.restoreState(self._first)

    def _settle(self) -> None:
        for dock in self.all:
            dock.settle()
