"""Named regions: drawn over the views, each with its weight and its own measures."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QModelIndex, Qt, Signal
from PySide6.QtWidgets import (
    QHBoxLayout,
    QHeaderView,
    QMenu,
    QToolButton,
    QTreeWidgetItem,
    QVBoxLayout,
)

from app.look.icons import dot
from app.look.numerals import four, short, with_unit
from app.look.theme import UNIT
from app.model.tool import Tool
from app.panels.widgets import NumberBox, NumberTree, Panel, quiet_label, tool_button

if TYPE_CHECKING:
    from app.jobs.region_measures import RegionMeasures
    from surfcmp_core.measures.measures import Measures


COLOURS = (
    (213, 94, 0),
    (0, 114, 178),
    (0, 158, 115),
    (204, 121, 167),
    (230, 159, 0),
    (86, 180, 233),
)
"""Of regions, in the order in which they are drawn (Okabe and Ito's, told apart by all)."""


class RegionsPanel(Panel):
    """The list of regions, and the tools that draw them."""

    tool_asked = Signal(object)
    renamed = Signal(int, str)
    weighed = Signal(int, float)
    coloured = Signal(int, object)
    """Number and colour (r, g, b); None: any other."""
    remove_asked = Signal(int)
    save_asked = Signal()
    load_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.lasso = tool_button(self.tr("Lasso"), self.tr("Draw around a region in any view (L)"))
        self.brush = tool_button(self.tr("Brush"), self.tr("Paint a region in any view (B)"))
        self.radius = NumberBox()
        self.radius.setMaximumWidth(7 * UNIT)
        self.radius.setToolTip(self.tr("Radius of the brush"))
        self.radius.setAccessibleName(self.tr("Radius of the brush"))
        for button, tool in ((self.lasso, Tool.LASSO), (self.brush, Tool.BRUSH)):
            button.setCheckable(True)
            button.clicked.connect(lambda on, t=tool: self.tool_asked.emit(t if on else Tool.LOOK))
        self.take = tool_button(
            self.tr("Take away"),
            self.tr("Lasso and brush take away from the selected region (or hold Shift)"),
        )
        self.take.setCheckable(True)
        self.new = tool_button(
            self.tr("New"), self.tr("The next stroke of the brush begins a new region"), plain=True
        )
        self.new.clicked.connect(self._let_go)
        self.colour = tool_button(
            self.tr("Colour") + " ▾", self.tr("Another colour for the region"), plain=True
        )
        self.colour.setStyleSheet("QToolButton::menu-indicator { image: none; }")
        self.colour.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.colour.setMenu(self._colours())
        self.save = tool_button(self.tr("Save…"), self.tr("Save the regions"), plain=True)
        self.save.clicked.connect(self.save_asked)
        self.load = tool_button(self.tr("Load…"), self.tr("Load regions"), plain=True)
        self.load.clicked.connect(self.load_asked)
        self.remove = tool_button(self.tr("Remove"), self.tr("Remove the region"), plain=True)
        self.remove.clicked.connect(lambda: self.remove_asked.emit(self.selected))
        heads = [self.tr("Region"), "µ", self.tr("Area"), self.tr("Mean |d|"), "P95"]
        self.tree = NumberTree(self.tr("Regions"), heads)
        header = self.tree.header()
        for column, width in ((1, 4), (2, 8), (3, 8), (4, 8)):
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.Fixed)
            header.resizeSection(column, width * UNIT)
        self.tree.itemChanged.connect(self._edited)
        self.tree.itemSelectionChanged.connect(self._enable)
        self.hint = quiet_label()
        self.hint.setWordWrap(True)
        self.hint.setText(self._invitation())
        self._count = 0
        self._lay_out()
        self._enable()

    def _colours(self) -> QMenu:
        menu = QMenu(self)
        names = (
            self.tr("Vermilion"),
            self.tr("Blue"),
            self.tr("Green"),
            self.tr("Pink"),
            self.tr("Orange"),
            self.tr("Light blue"),
        )
        for colour, name in zip(COLOURS, names, strict=True):
            action = menu.addAction(dot(colour), name)
            action.triggered.connect(lambda _=False, c=colour: self.coloured.emit(self.selected, c))
        other = menu.addAction(self.tr("Another…"))
        other.triggered.connect(lambda _=False: self.coloured.emit(self.selected, None))
        return menu

    def _lay_out(self) -> None:
        tools = QHBoxLayout()
        tools.setSpacing(UNIT)
        for widget in (self.lasso, self.brush, self.radius, self.take):
            tools.addWidget(widget)
        tools.addStretch(1)
        keeping = QHBoxLayout()
        keeping.setSpacing(UNIT // 2)
        for widget in (self.new, self.colour, self.remove):
            keeping.addWidget(widget)
        keeping.addStretch(1)
        for widget in (self.load, self.save):
            keeping.addWidget(widget)
        column = QVBoxLayout(self)
        column.setContentsMargins(UNIT, UNIT, UNIT, UNIT)
        column.setSpacing(UNIT)
        column.addLayout(tools)
        column.addWidget(self.tree, 1)
        column.addWidget(self.hint)
        column.addLayout(keeping)

    @property
    def selected(self) -> int:
        """The number of the selected region; -1 for none."""
        row = self.tree.currentIndex().row()
        return row if row < self._count else -1

    def show_tool(self, tool: Tool) -> None:
        """Show which tool is in hand."""
        self.lasso.setChecked(tool is Tool.LASSO)
        self.brush.setChecked(tool is Tool.BRUSH)

    def show_regions(
        self, found: Sequence[RegionMeasures], whole: Measures | None, unit: str
    ) -> None:
        """Show the regions, the rest and the whole."""
        selected, before = self.tree.currentIndex().row(), self._count
        self.tree.blockSignals(True)
        self.tree.clear()
        self._count = sum(part.region is not None for part in found)
        head = self.tree.headerItem()
        for column, power in ((2, 2), (3, 1), (4, 1)):
            head.setToolTip(column, self.tr("in {}").format(with_unit(1.0, power, unit)[1]))
        for part in found:
            self._add(part)
        if found and whole is not None:
            self._add_row(self.tr("Whole"), "", whole)
        if self._count:
            known = 0 <= selected < self._count <= before
            row = selected if known else self._count - 1  # a new region is the selected one
            self.tree.setCurrentIndex(self.tree.model().index(row, 0))
        self.tree.blockSignals(False)
        text = self.tr("Area in {}, mean and 95th percentile in {}; the parts add up.").format(
            with_unit(1.0, 2, unit)[1], unit
        )
        self.hint.setText(text if found else self._invitation())
        self._enable()

    def _invitation(self) -> str:
        return self.tr(
            "Draw around a region, or paint it. Its measures stand here; all parts add up to the"
            " whole."
        )

    def _let_go(self) -> None:
        self.tree.setCurrentIndex(QModelIndex())
        self._enable()

    def _enable(self) -> None:
        self.save.setEnabled(self._count > 0)
        for button in (self.remove, self.colour, self.new):
            button.setEnabled(self.selected >= 0)

    def _add(self, part: RegionMeasures) -> None:
        if part.region is None:
            self._add_row(self.tr("Rest"), "1", part.measures)
            return
        item = self._add_row(part.region.name, short(part.region.weight), part.measures)
        item.setIcon(0, dot(part.region.colour))
        item.setFlags(item.flags() | Qt.ItemFlag.ItemIsEditable)

    def _add_row(self, name: str, weight: str, measures: Measures | None) -> QTreeWidgetItem:
        texts = [name, weight]
        for key in ("area_compared", "mean_abs", "p95"):
            value = None if measures is None else getattr(measures, key)
            texts.append(four(math.nan if value is None else value))
        return self.tree.add_row(texts)

    def _edited(self, item: QTreeWidgetItem, column: int) -> None:
        row = self.tree.indexOfTopLevelItem(item)
        if row >= self._count:
            return
        if column == 0:
            self.renamed.emit(row, item.text(0).strip())
        elif column == 1:
            try:
                weight = float(item.text(1).replace(",", "."))
            except ValueError:
                weight = -1.0
            self.weighed.emit(row, weight)
