"""Values at places the user picked; labels that stay on the surface."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QHBoxLayout,
    QHeaderView,
    QPushButton,
    QVBoxLayout,
)

from app.look.numerals import four
from app.look.theme import UNIT
from app.panels.widgets import NumberTree, Panel, quiet_label
from app.scene.pick import Reading


class ProbesPanel(Panel):
    """One row for each kept place, and the one picked now."""

    keep_asked = Signal()
    remove_asked = Signal(int)
    clear_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        heads = [self.tr("Place"), "x", "y", "z1", "z2", "d"]
        self.tree = NumberTree(self.tr("Values at places"), heads)
        header = self.tree.header()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        header.setMinimumSectionSize(5 * UNIT)
        self.hint = quiet_label(self.tr("Click a place on any surface to read its values."))
        self.hint.setWordWrap(True)
        self.keep = QPushButton(self.tr("Keep"))
        self.keep.setToolTip(self.tr("Let the label stay on the surface (K)"))
        self.keep.clicked.connect(self.keep_asked)
        self.remove = QPushButton(self.tr("Remove"))
        self.remove.clicked.connect(self._remove)
        self.clear = QPushButton(self.tr("Remove all"))
        self.clear.clicked.connect(self.clear_asked)
        buttons = QHBoxLayout()
        buttons.setSpacing(UNIT)
        buttons.addStretch(1)
        for button in (self.keep, self.remove, self.clear):
            buttons.addWidget(button)
        column = QVBoxLayout(self)
        column.setContentsMargins(UNIT, UNIT, UNIT, UNIT)
        column.setSpacing(UNIT)
        column.addWidget(self.hint)
        column.addWidget(self.tree, 1)
        column.addLayout(buttons)
        self.show_readings([], None, "")

    def _set_unit(self, unit: str) -> None:
        head = self.tree.headerItem()
        for column in range(1, 6):
            head.setToolTip(column, self.tr("in {}").format(unit) if unit else "")

    def show_readings(self, kept: list[Reading], picked: Reading | None, unit: str) -> None:
        """Show the kept places and the one picked now."""
        self._set_unit(unit)
        self.tree.clear()
        rows = [(str(k + 1), reading) for k, reading in enumerate(kept)]
        if picked is not None:
            rows.append((self.tr("now"), picked))
        for name, reading in rows:
            numbers = (
                reading.x,
                reading.y,
                reading.z1,
                reading.z2,
                reading.difference,
            )
            item = self.tree.add_row([name, *(four(number) for number in numbers)])
            item.setToolTip(
                5, self.tr("Mean of the triangle: {} {}").format(four(reading.mean_signed), unit)
            )
        self.hint.setVisible(not rows)
        self.keep.setEnabled(picked is not None)
        self.remove.setEnabled(bool(kept))
        self.clear.setEnabled(bool(kept))

    def _remove(self) -> None:
        row = self.tree.currentIndex().row()
        last = self.tree.topLevelItemCount() - 1 - self.keep.isEnabled()
        self.remove_asked.emit(min(row, last) if row >= 0 else last)
