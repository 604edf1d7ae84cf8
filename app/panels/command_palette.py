"""Type what you want to do: every action by its name."""

from collections.abc import Sequence
from typing import override

from PySide6.QtCore import QEvent, QObject, QSize, Qt
from PySide6.QtGui import QAction, QKeyEvent
from PySide6.QtWidgets import (
    QDialog,
    QHeaderView,
    QLineEdit,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.look.theme import UNIT

ACTION = int(Qt.ItemDataRole.UserRole)


class CommandPalette(QDialog):
    """A line to type in, and the actions whose names hold all the words."""

    def __init__(self, parent: QWidget, actions: Sequence[QAction]) -> None:
        super().__init__(parent, Qt.WindowType.Popup)
        self.setAccessibleName(self.tr("Command palette"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._actions = [action for action in actions if action.isEnabled()]
        self.line = QLineEdit()
        self.line.setPlaceholderText(self.tr("What do you want to do?"))
        self.list = QTreeWidget()
        self.list.setColumnCount(2)
        self.list.setHeaderHidden(True)
        self.list.setRootIsDecorated(False)
        self.list.setUniformRowHeights(True)
        self.list.setIndentation(0)
        self.list.setAccessibleName(self.tr("Actions"))
        self.list.header().setStretchLastSection(False)
        self.list.header().setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        self.list.header().setSectionResizeMode(1, QHeaderView.ResizeMode.ResizeToContents)
        column = QVBoxLayout(self)
        column.setContentsMargins(UNIT, UNIT, UNIT, UNIT)
        column.setSpacing(UNIT)
        column.addWidget(self.line)
        column.addWidget(self.list)
        self.resize(56 * UNIT, 45 * UNIT)
        self.line.textChanged.connect(self._search)
        self.line.returnPressed.connect(self._run)
        self.line.installEventFilter(self)
        self.list.itemActivated.connect(self._run)
        self.list.itemClicked.connect(self._run)
        self._search("")

    def _search(self, text: str) -> None:
        words = text.casefold().split()
        self.list.clear()
        for action in self._actions:
            name = plain(action)
            if all(word in name.casefold() for word in words):
                keys = action.shortcut().toString(action.shortcut().SequenceFormat.NativeText)
                item = QTreeWidgetItem([name, keys])
                item.setData(0, ACTION, action)
                item.setSizeHint(0, QSize(0, 3 * UNIT + 2))
                self.list.addTopLevelItem(item)
        self._go_to(0)

    def _go_to(self, row: int) -> None:
        last = self.list.topLevelItemCount() - 1
        self.list.setCurrentIndex(self.list.model().index(min(max(row, 0), last), 0))

    def _run(self) -> None:
        item = self.list.currentItem()
        action = item.data(0, ACTION) if item is not None else None
        self.close()
        if action is not None:
            action.trigger()

    @override
    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            step = {Qt.Key.Key_Down: 1, Qt.Key.Key_Up: -1}.get(Qt.Key(event.key()), 0)
            if step:
                self._go_to(self.list.currentIndex().row() + step)
                return True
        return super().eventFilter(watched, event)


def plain(action: QAction) -> str:
    """Return an action's name without the mark of its key and without dots."""
    return action.text().replace("&", "").removesuffix("…")
