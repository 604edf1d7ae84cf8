"""The chains as a table: click one and the views fly there."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, override

import numpy as np
from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt, Signal
from PySide6.QtGui import QColor, QImage
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QTableView,
    QVBoxLayout,
)

from app.look.numerals import three, with_unit
from app.look.texts import QT_TRANSLATE_NOOP
from app.look.theme import UNIT, tabular
from app.model.view_state import ChainsBy
from app.panels.widgets import ChoiceButton, Panel, quiet_label

if TYPE_CHECKING:
    from app.scene.chain_table import ChainTable
    from surfcmp_core.colours.maps import Colours

Index = QModelIndex | QPersistentModelIndex
LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
BY: dict[object, str] = {
    ChainsBy.ROLE: QT_TRANSLATE_NOOP("ChainsPanel", "Role: rings, longer chains, open ones"),
    ChainsBy.LENGTH: QT_TRANSLATE_NOOP("ChainsPanel", "Length"),
    ChainsBy.MEAN: QT_TRANSLATE_NOOP("ChainsPanel", "Mean |d|"),
    ChainsBy.ORDER: QT_TRANSLATE_NOOP("ChainsPanel", "Order in which they were found"),
}
RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


class ChainModel(QAbstractTableModel):
    """Rows in the order the user sorts them."""

    def __init__(self) -> None:
        super().__init__()
        self._table: ChainTable | None = None
        self._order = np.zeros(0, dtype=np.intp)
        self._colours = np.zeros((0, 3), dtype=np.uint8)
        self._unit = ""
        self._sorted = (2, True)
        """By which column, and whether the largest come first."""

    def set_table(self, table: ChainTable, unit: str) -> None:
        """Show other chains, in their own order."""
        self.beginResetModel()
        self._table, self._unit = table, unit
        self._order = np.arange(len(table.closed))
        self.endResetModel()

    def set_colours(self, colours: Colours) -> None:
        """Show the chains' colours in the views, (C, 3)."""
        self._colours = colours
        rows = len(self._order)
        if rows:
            self.dataChanged.emit(self.index(0, 0), self.index(rows - 1, 0))

    def chain(self, row: int) -> int:
        """Return the number of the chain in a row."""
        return int(self._order[row])

    def row(self, chain: int) -> int:
        """Return the row of a chain."""
        return int(np.flatnonzero(self._order == chain)[0])

    @override
    def rowCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(self._order)

    @override
    def columnCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(self._names())

    @override
    def headerData(self, section: int, orientation: Qt.Orientation, role: int = 0) -> Any:
        if orientation != Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return LEFT if section == 1 else RIGHT
        if role == Qt.ItemDataRole.DisplayRole:
            mark = {self._sorted[0]: " ▾" if self._sorted[1] else " ▴"}
            return self._names()[section] + mark.get(section, "")
        if role == Qt.ItemDataRole.ToolTipRole:
            return self._tips()[section]
        return None

    def _names(self) -> list[str]:
        return [
            self.tr("Chain"),
            self.tr("Kind"),
            self.tr("Length"),
            self.tr("Area"),
            self.tr("Mean |d|"),
            self.tr("Share %"),
        ]

    def _tips(self) -> list[str]:
        return [
            self.tr("Number of the chain and its colour in the third view"),
            self.tr("Closed: comes back to its start; ring: round a node; open: ends at the hull"),
            self.tr("Length of the chain in triangles"),
            self.tr("Area of its compared triangles"),
            self.tr("Mean of |d| over them"),
            self.tr("Its part of the whole volume between the surfaces"),
        ]

    @override
    def data(self, index: Index, role: int = 0) -> Any:
        if self._table is None:
            return None
        chain = self.chain(index.row())
        if role == Qt.ItemDataRole.DisplayRole:
            return self._text(chain, index.column())
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return LEFT if index.column() == 1 else RIGHT
        if (
            role == Qt.ItemDataRole.DecorationRole
            and index.column() == 0
            and chain < len(self._colours)
        ):
            swatch = QImage(10, 10, QImage.Format.Format_RGB32)
            swatch.fill(QColor(*self._colours[chain].tolist()))
            return swatch
        return None

    def _text(self, chain: int, column: int) -> str:
        table = self._table
        assert table is not None
        match column:
            case 0:
                return str(chain)
            case 1:
                if table.ring[chain]:
                    return self.tr("ring")
                return self.tr("closed") if table.closed[chain] else self.tr("open")
            case 2:
                return str(table.triangles[chain])
            case 3:
                return three(table.area[chain])
            case 4:
                return three(table.mean_abs[chain])
            case _:
                return three(100 * table.share[chain])

    @override
    def sort(self, column: int, order: Qt.SortOrder = Qt.SortOrder.AscendingOrder) -> None:
        if self._table is None or column < 0:
            return
        table, self._sorted = self._table, (column, order == Qt.SortOrder.DescendingOrder)
        keys = [
            np.arange(len(table.closed)),
            table.closed,
            table.triangles,
            table.area,
            table.mean_abs,
            table.share,
        ][column].astype(np.float64)
        if order == Qt.SortOrder.DescendingOrder:
            keys = -keys
        self.beginResetModel()
        self._order = np.argsort(keys, kind="stable")
        self.endResetModel()


class ChainsPanel(Panel):
    """All chains of T."""

    chosen = Signal(object)
    """The number of a chain, or None."""
    colours_asked = Signal(object)
    """ChainsBy."""

    def __init__(self) -> None:
        super().__init__()
        self.model = ChainModel()
        self.table = QTableView()
        self.table.setModel(self.model)
        self.table.setAccessibleName(self.tr("Chains"))
        font = tabular(self.table.font())
        font.setPointSizeF(font.pointSizeF() * 0.92)
        self.table.setFont(font)
        self.table.horizontalHeader().setFont(font)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.table.setShowGrid(False)
        self.table.verticalHeader().hide()
        self.table.verticalHeader().setDefaultSectionSize(3 * UNIT)
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        header.setResizeContentsPrecision(0)  # only the rows to be seen
        for number in (0, 1, 2):
            header.setSectionResizeMode(number, QHeaderView.ResizeMode.ResizeToContents)
        header.setDefaultAlignment(RIGHT)
        header.setSortIndicator(2, Qt.SortOrder.DescendingOrder)
        self.table.setSortingEnabled(True)
        header.setSortIndicatorShown(False)  # it would lie over the name
        self.table.selectionModel().currentRowChanged.connect(self._row_changed)
        self.table.clicked.connect(self._row_changed)
        self.summary = quiet_label()
        self.summary.setWordWrap(True)
        self.by = ChoiceButton({key: self.tr(text) for key, text in BY.items()})
        self.by.chosen.connect(self.colours_asked)
        row = QHBoxLayout()
        row.setSpacing(UNIT)
        row.addWidget(quiet_label(self.tr("Colour by")))
        row.addWidget(self.by, 1)
        column = QVBoxLayout(self)
        column.setContentsMargins(UNIT, UNIT // 2, UNIT, UNIT)
        column.setSpacing(UNIT)
        column.addLayout(row)
        column.addWidget(self.table, 1)
        column.addWidget(self.summary)

    def show_colours(self, by: ChainsBy, colours: Colours) -> None:
        """Show what the chains are coloured by."""
        self.by.show_choice(by)
        self.model.set_colours(colours)

    def show_chains(self, table: ChainTable, unit: str) -> None:
        """Show the chains of a comparison."""
        self.model.set_table(table, unit)
        areas = with_unit(1.0, 2, unit)[1]
        text = self.tr("Areas in {}, means in {}. Click a chain to fly there; Esc shows all again.")
        if not len(table.closed):
            text = self.tr("There are no chains: no triangle lies between the two grids.")
        self.summary.setText(text.format(areas, unit))
        header = self.table.horizontalHeader()
        self.model.sort(header.sortIndicatorSection(), header.sortIndicatorOrder())

    def _row_changed(self, index: QModelIndex) -> None:
        if index.isValid():
            self.chosen.emit(self.model.chain(index.row()))
