"""The colours' range: fixed until it is changed here; and how the differences lie in it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QGridLayout, QHBoxLayout, QLabel, QLineEdit, QPushButton

from app.look.numerals import short
from app.look.texts import QT_TRANSLATE_NOOP
from app.look.theme import UNIT
from app.model.view_state import ScaleChoice, ViewState
from app.panels.histogram import Histogram, distribution
from app.panels.widgets import ChoiceButton, NumberBox, Panel, quiet_label

if TYPE_CHECKING:
    from app.scene.content import Content

PRESETS: dict[object, str] = {
    (0.5, 1.0, 2.0): QT_TRANSLATE_NOOP("ScalePanel", "Face: 0.5, 1, 2"),
    (2.0,): QT_TRANSLATE_NOOP("ScalePanel", "Planned and achieved jaw: 2"),
    (0.1, 0.2, 0.5): QT_TRANSLATE_NOOP("ScalePanel", "Dental: 0.1, 0.2, 0.5"),
}
"""Tolerances in mm that are usual in the clinic."""


class ScalePanel(Panel):
    """Histogram, limit, bands, tolerances and brush."""

    changed = Signal(object)
    """ScaleChoice: what the user chose."""
    brushed = Signal(object)
    """The range that lights up, or None."""
    fit_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._scale = ScaleChoice()
        self.histogram = Histogram()
        self.histogram.tolerance_moved.connect(self._tolerance_moved)
        self.histogram.brushed.connect(self.brushed)
        self.beyond = quiet_label()
        self.limit = NumberBox()
        self.limit.setAccessibleName(self.tr("Largest difference with a colour of its own"))
        self.limit.changed.connect(lambda value: self._choose(limit=value, pinned=True))
        self.fit = QPushButton(self.tr("Fit"))
        self.fit.setToolTip(self.tr("Fit the range to these surfaces; it stays there afterwards"))
        self.fit.clicked.connect(self.fit_asked)
        self.banded = QCheckBox(self.tr("Bands"))
        self.banded.setToolTip(self.tr("One colour between tolerances in place of a ramp"))
        self.banded.toggled.connect(lambda on: self._choose(banded=on))
        self.tolerances = QLineEdit()
        self.tolerances.setAccessibleName(self.tr("Tolerances, separated by spaces"))
        self.tolerances.editingFinished.connect(self._tolerances_typed)
        self.presets = ChoiceButton({key: self.tr(text) for key, text in PRESETS.items()})
        self.presets.setText("▾")
        self.presets.setToolTip(self.tr("Usual tolerances"))
        self.presets.setAccessibleName(self.tr("Usual tolerances"))
        self.presets.chosen.connect(lambda key: self._choose(tolerances=key, banded=True))
        self._unit = QLabel()
        self._lay_out()

    def _lay_out(self) -> None:
        grid = QGridLayout(self)
        grid.setContentsMargins(UNIT + 4, UNIT, UNIT + 4, UNIT + 4)
        grid.setHorizontalSpacing(UNIT)
        grid.setVerticalSpacing(UNIT)
        grid.addWidget(self.histogram, 0, 0, 1, 2)
        grid.addWidget(self.beyond, 1, 0, 1, 2)
        rows = (
            (self.tr("Range ±"), (self.limit, self._unit, self.fit)),
            (self.tr("Tolerances"), (self.tolerances, self.presets, self.banded)),
        )
        for k, (name, widgets) in enumerate(rows, 2):
            row = QHBoxLayout()
            row.setSpacing(UNIT)
            for widget in widgets:
                row.addWidget(widget, 1 if widget is widgets[0] else 0)
            grid.addWidget(QLabel(name), k, 0)
            grid.addLayout(row, k, 1)
        grid.setColumnStretch(1, 1)
        grid.setRowStretch(0, 3)
        grid.setRowStretch(4, 1)

    def show_state(self, content: Content | None, state: ViewState, unit: str) -> None:
        """Show the scale in force."""
        self._scale = state.scale
        self._unit.setText(unit)
        self.limit.show_value(state.scale.limit)
        self.banded.blockSignals(True)
        self.banded.setChecked(state.scale.banded)
        self.banded.blockSignals(False)
        if not self.tolerances.isModified():
            self.tolerances.setText("  ".join(short(value) for value in state.scale.tolerances))
        if content is None:
            return
        scale = state.colours
        found = distribution(content, state)
        if state.brush is not None:
            share = 100 * found.within(*state.brush)
            text = self.tr("{:.1f} % of the area lies in {} to {} {}").format(
                share, short(round(state.brush[0], 6)), short(round(state.brush[1], 6)), unit
            )
        else:
            share = 100 * (1 - found.within(scale.low, scale.end))
            text = self.tr("{:.1f} % of the area lies beyond the range").format(share)
        self.beyond.setText(text)
        self.histogram.show_content(content, state, unit)

    def _tolerance_moved(self, number: int, value: float) -> None:
        moved = list(self._scale.tolerances)
        moved[number] = float(f"{value:.3g}")
        if moved[number] > 0:
            self._choose(tolerances=tuple(sorted(set(moved))))

    def _tolerances_typed(self) -> None:
        self.tolerances.setModified(False)
        chosen = parse_tolerances(self.tolerances.text())
        self._choose(tolerances=chosen or self._scale.tolerances)

    def _choose(self, **changes: float | bool | tuple[float, ...]) -> None:
        self._scale = replace(self._scale, **changes)  # type: ignore[arg-type]
        self.changed.emit(self._scale)


def parse_tolerances(text: str) -> tuple[float, ...]:
    """Return the positive numbers in `text`, ascending, each once; none where it has others."""
    try:
        values = sorted({float(word) for word in text.replace(";", " ").split()})
    except ValueError:
        return ()
    return tuple(values) if values and values[0] > 0 else ()
