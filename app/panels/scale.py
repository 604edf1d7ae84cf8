"""The colours' range: fixed until it is changed here."""

from dataclasses import replace

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
)

from app.model.view_state import Scale
from app.numbers import short
from app.panels.widgets import NumberBox, Panel
from app.theme import UNIT


class ScalePanel(Panel):
    """Limit, bands and tolerances."""

    changed = Signal(object)
    """Scale: what the user chose."""
    fit_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._scale = Scale()
        self.limit = NumberBox()
        self.limit.setAccessibleName(self.tr("Largest difference with a colour of its own"))
        self.limit.changed.connect(self._limit_chosen)
        self.fit = QPushButton(self.tr("Fit"))
        self.fit.setToolTip(self.tr("Fit the range to these surfaces; it stays there afterwards"))
        self.fit.clicked.connect(self.fit_asked)
        self.banded = QCheckBox(self.tr("Bands"))
        self.banded.setToolTip(self.tr("One colour between tolerances in place of a ramp"))
        self.banded.toggled.connect(lambda on: self._choose(banded=on))
        self.tolerances = QLineEdit()
        self.tolerances.setAccessibleName(self.tr("Tolerances, separated by spaces"))
        self.tolerances.editingFinished.connect(self._tolerances_chosen)
        self._unit = QLabel()
        grid = QGridLayout(self)
        grid.setContentsMargins(UNIT + 4, UNIT // 2, UNIT + 4, UNIT + 4)
        grid.setHorizontalSpacing(UNIT)
        grid.setVerticalSpacing(UNIT)
        grid.addWidget(QLabel(self.tr("Range ±")), 0, 0)
        row = QHBoxLayout()
        row.setSpacing(UNIT)
        row.addWidget(self.limit, 1)
        row.addWidget(self._unit)
        row.addWidget(self.fit)
        grid.addLayout(row, 0, 1)
        grid.addWidget(QLabel(self.tr("Tolerances")), 1, 0)
        second = QHBoxLayout()
        second.setSpacing(UNIT)
        second.addWidget(self.tolerances, 1)
        second.addWidget(self.banded)
        grid.addLayout(second, 1, 1)
        grid.setColumnStretch(1, 1)
        grid.setRowStretch(2, 1)

    def show_scale(self, scale: Scale, unit: str) -> None:
        """Show the scale in force."""
        self._scale = scale
        self._unit.setText(unit)
        self.limit.show_value(scale.limit)
        self.banded.blockSignals(True)
        self.banded.setChecked(scale.banded)
        self.banded.blockSignals(False)
        if not self.tolerances.hasFocus():
            self.tolerances.setText("  ".join(short(value) for value in scale.tolerances))

    def _limit_chosen(self, value: float) -> None:
        self._choose(limit=value, pinned=True)

    def _tolerances_chosen(self) -> None:
        chosen = parse_tolerances(self.tolerances.text())
        if chosen:
            self._choose(tolerances=chosen)
        else:
            self.tolerances.setText("  ".join(short(value) for value in self._scale.tolerances))

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
