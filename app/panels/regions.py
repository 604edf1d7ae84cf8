"""Named regions: drawn on the map, each with its weight and its own measures."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QHBoxLayout,
    QHeaderView,
    QTreeWidgetItem,
    QVBoxLayout,
)

from app.icons import dot
from app.model.tool import Tool
from app.numbers import four, short, with_unit
from app.panels.widgets import NumberBox, NumberTree, Panel, quiet_label, tool_button
from app.theme import UNIT

if TYPE_CHECKING:
    from app.jobs.regions import RegionMeasures
    from surfcmp_core.measures.measures import Measures


class RegionsPanel(Panel):
    """The list of regions, and the tools that draw them."""

    tool_asked = Signal(object)
    renamed = Signal(int, str)
    weighed = Signal(int, float)
    remove_asked = Signal(int)
    save_asked = Signal()
    load_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.lasso = tool_button(self.tr("Lasso"), self.tr("Draw around a region on the map (L)"))
        self.brush = tool_button(self.tr("Brush"), self.tr("Paint a region on the map (B)"))
        self.radius = NumberBox()
        self.radius.setMaximumWidth(7 * UNIT)
        self.radius.setToolTip(self.tr("Radius of the brush"))
        self.radius.setAccessibleName(self.tr("Radius of the brush"))
        for button, tool in ((self.lasso, Tool.LASSO), (self.brush, Tool.BRUSH)):
            button.setCheckable(True)
            button.clicked.connect(lambda on, t=tool: self.tool_asked.emit(t if on else Tool.LOOK))
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
        self.hint = quiet_label(
            self.tr("Draw around a region. Its measures stand here; all parts add up to the whole.")
        )
        self.hint.setWordWrap(True)
        self._lay_out()
        self._count = 0

    def _lay_out(self) -> None:
        tools = QHBoxLayout()
        tools.setSpacing(UNIT)
        for widget in (self.lasso, self.brush, self.radius):
            tools.addWidget(widget)
        tools.addStretch(1)
        keeping = QHBoxLayout()
        keeping.setSpacing(UNIT // 2)
        keeping.addStretch(1)
        for widget in (self.remove, self.load, self.save):
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
        selected = self.selected
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
            row = selected if 0 <= selected < self._count else self._count - 1
            self.tree.setCurrentIndex(self.tree.model().index(row, 0))
        self.tree.blockSignals(False)
        self.hint.setVisible(not found)
        for button in (self.remove, self.save):
            button.setEnabled(self._count > 0)

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
