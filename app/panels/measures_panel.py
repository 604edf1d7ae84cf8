"""The measures: the three people report first, then all of them."""

from __future__ import annotations

from dataclasses import asdict, replace
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QGuiApplication
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFrame,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
)

from app.look.numerals import three, with_unit
from app.look.texts import of_core
from app.look.theme import LIGHT, UNIT, Theme, tabular
from app.panels.widgets import Panel

if TYPE_CHECKING:
    from surfcmp_core.measures.measures import Measures
    from surfcmp_core.report.meanings import Line

KEY = int(Qt.ItemDataRole.UserRole)


class Card(QFrame):
    """One number, large."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("card")
        self._name = QLabel()
        self._name.setProperty("kind", "quiet")
        self.value = QLabel()
        font = tabular(self.value.font())
        font.setPointSizeF(font.pointSizeF() * 1.3)
        font.setWeight(font.Weight.DemiBold)
        self.value.setFont(font)
        column = QVBoxLayout(self)
        column.setContentsMargins(UNIT, UNIT // 2 + 2, UNIT, UNIT // 2 + 2)
        column.setSpacing(0)
        column.addWidget(self._name)
        self.hide()
        column.addWidget(self.value)

    def show_number(self, name: str, value: str, unit: str, tip: str) -> None:
        """Show a number and its unit."""
        self.show()
        self._name.setText(name)
        self.value.setText(f"{value} {unit}".strip())
        self.setToolTip(tip)


def _values(measures: Measures) -> dict[str, Any]:
    """Return the measures under their keys; those of the exact reading in a dictionary apart."""
    values = asdict(replace(measures, exact=None))
    del values["exact"]
    return values if measures.exact is None else {**values, "exact": _values(measures.exact)}


class MeasuresPanel(Panel):
    """Every measure with its unit; what it means stands in the tooltip."""

    def __init__(self) -> None:
        super().__init__()
        self.cards = [Card() for _ in range(3)]
        row = QHBoxLayout()
        row.setSpacing(UNIT)
        for card in self.cards:
            row.addWidget(card, 1)
        self.tree = QTreeWidget(columnCount=3)
        self.tree.setHeaderHidden(True)
        self.tree.setRootIsDecorated(False)
        self.tree.setAccessibleName(self.tr("Measures"))
        self.tree.setIndentation(0)
        self.tree.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.tree.setItemsExpandable(False)
        header = self.tree.header()
        header.setStretchLastSection(False)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(1, QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(2, QHeaderView.ResizeMode.ResizeToContents)
        self.copy = QPushButton(self.tr("Copy as table"))
        self.copy.clicked.connect(self.copy_table)
        self.copy.setEnabled(False)
        foot = QHBoxLayout()
        foot.addStretch(1)
        foot.addWidget(self.copy)
        column = QVBoxLayout(self)
        column.setContentsMargins(UNIT + 4, UNIT + 4, UNIT + 4, UNIT + 4)
        column.setSpacing(UNIT)
        column.addLayout(row)
        column.addWidget(self.tree, 1)
        column.addLayout(foot)
        self._lines: list[Line] = []
        self._unit = ""
        self._notes: dict[str, str] = {}
        self._theme = LIGHT

    def show_measures(self, measures: Measures, unit: str) -> None:
        """Show all numbers of a comparison in `unit` (empty where nobody knows it)."""
        from surfcmp_core.report.meanings import NOTES, lines

        self._unit, self._notes = unit, NOTES
        self._lines = lines(_values(measures), unit)
        self.copy.setEnabled(True)
        self._fill_cards()
        self._fill_tree()

    def dress(self, theme: Theme) -> None:
        """Take the colours of a theme."""
        self._theme = theme
        self._fill_tree()

    def _fill_tree(self) -> None:
        self.tree.clear()
        group = ""
        for line in self._lines:
            if line.group != group:
                group = line.group
                self._add_heading(group)
            self._add_line(line)

    def value(self, key: str) -> str:
        """Return the text that stands beside a measure, without its unit."""
        for k in range(self.tree.topLevelItemCount()):
            item = self.tree.topLevelItem(k)
            if item is not None and item.data(0, KEY) == key:
                return item.text(1)
        raise KeyError(key)

    def table(self) -> str:
        """Return all measures as a table of tab-separated columns: key, value, unit, meaning.

        Values stand in full, as the .json result has them.
        """
        rows = ["\t".join((self.tr("measure"), self.tr("value"), self.tr("unit"), ""))]
        for line in self._lines:
            _, unit = with_unit(1.0, line.power, self._unit)
            value = line.value if line.value is None or line.power else 100 * line.value
            rows.append("\t".join((line.name, repr(value), unit, self._sentence(line))))
        return "\n".join(rows) + "\n"

    def copy_table(self) -> None:
        """Put the table on the clipboard."""
        QGuiApplication.clipboard().setText(self.table())

    def _fill_cards(self) -> None:
        nodal = [line for line in self._lines if line.group == line.meaning.group]
        within = [line for line in nodal if line.tolerance]
        by_name = {line.name: line for line in nodal}
        chosen = [by_name["mean_abs"], by_name["p95"], *within[len(within) // 2 :][:1]]
        for card, line in zip(self.cards, chosen, strict=False):
            _, unit = with_unit(line.value, line.power, self._unit)
            number = float("nan") if line.value is None else line.value
            value = three(number if line.power else 100 * number)
            name = self._name(line)
            if line in within:
                name = self.tr("Within {}").format(line.tolerance)
            card.show_number(name, value, unit, self._sentence(line))

    def _name(self, line: Line) -> str:
        return of_core(line.meaning.name).format(line.tolerance)

    def _sentence(self, line: Line) -> str:
        """Return what a measure means."""
        return of_core(line.meaning.text).format(line.tolerance)

    def _add_heading(self, group: str) -> None:
        item = QTreeWidgetItem([of_core(group)])
        item.setForeground(0, QColor(self._theme.quiet))
        item.setTextAlignment(0, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignBottom)
        item.setSizeHint(0, QSize(0, 3 * UNIT + 4))
        item.setFlags(Qt.ItemFlag.ItemIsEnabled)
        if group in self._notes:
            item.setToolTip(0, of_core(self._notes[group]))
        self.tree.addTopLevelItem(item)
        item.setFirstColumnSpanned(True)

    def _add_line(self, line: Line) -> None:
        value, unit = with_unit(line.value, line.power, self._unit)
        item = QTreeWidgetItem([self._name(line), value, unit])
        item.setSizeHint(0, QSize(0, 2 * UNIT + 6))
        item.setForeground(2, QColor(self._theme.quiet))
        item.setData(0, KEY, line.name)
        item.setTextAlignment(1, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        item.setFont(1, tabular(self.tree.font()))
        text = self._sentence(line)
        text = text[0].upper() + text[1:] + "."
        if line.group in self._notes:
            text += " " + of_core(self._notes[line.group])
        for column in range(3):
            item.setToolTip(column, text)
        self.tree.addTopLevelItem(item)
