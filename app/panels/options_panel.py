"""What is compared, and how: every option that changes the numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QFormLayout, QLineEdit

from app.look.texts import QT_TRANSLATE_NOOP
from app.look.theme import UNIT
from app.panels.widgets import ChoiceButton, Panel, quiet_label

if TYPE_CHECKING:
    from app.model.document import Document

DOMAINS: dict[object, str] = {
    "data": QT_TRANSLATE_NOOP("OptionsPanel", "Where both have data"),
    "hull": QT_TRANSLATE_NOOP("OptionsPanel", "Inside both hulls"),
    "plane": QT_TRANSLATE_NOOP("OptionsPanel", "The whole plane"),
}
DUPLICATES: dict[object, str] = {
    "refuse": QT_TRANSLATE_NOOP("OptionsPanel", "Refuse"),
    "mean": QT_TRANSLATE_NOOP("OptionsPanel", "Take the mean"),
    "max": QT_TRANSLATE_NOOP("OptionsPanel", "Take the highest"),
    "min": QT_TRANSLATE_NOOP("OptionsPanel", "Take the lowest"),
}
UNITS: dict[object, str] = {
    "": QT_TRANSLATE_NOOP("OptionsPanel", "As the files say"),
    "mm": "mm",
    "cm": "cm",
    "m": "m",
    "um": "µm",
    "in": "in",
    "ft": "ft",
    "us-ft": "us-ft",
}
VIEWS: dict[object, str] = {
    "z": QT_TRANSLATE_NOOP("OptionsPanel", "Along z, as in the files"),
    "auto": QT_TRANSLATE_NOOP("OptionsPanel", "Found from the surfaces"),
}


class OptionsPanel(Panel):
    """A form; each change compares anew."""

    changed = Signal(object)
    """Document."""

    def __init__(self) -> None:
        super().__init__()
        self._document: Document | None = None
        self.domain = self._choice(DOMAINS, "domain")
        self.duplicates = self._choice(DUPLICATES, "duplicates")
        self.unit = ChoiceButton({key: self.tr(text) for key, text in UNITS.items()})
        self.unit.chosen.connect(lambda unit: self._option(unit=unit or None))
        self.project = ChoiceButton({key: self.tr(text) for key, text in VIEWS.items()})
        self.project.chosen.connect(lambda view: self._option(project=view))
        self.max_edge = QLineEdit()
        self.max_edge.setPlaceholderText(self.tr("from the spacing of the nodes"))
        self.max_edge.setAccessibleName(self.tr("Longest side over which a cloud has data"))
        self.max_edge.setToolTip(
            self.tr("A cloud has data only in triangles with no longer side; inf: everywhere")
        )
        self.max_edge.editingFinished.connect(self._max_edge_typed)
        self.exact = QCheckBox(self.tr("Also exactly, over both triangulations"))
        self.exact.setToolTip(
            self.tr("Integrates over the overlay of T1 and T2; takes several times as long")
        )
        self.exact.toggled.connect(lambda on: self._option(exact=on))
        form = QFormLayout(self)
        form.setContentsMargins(UNIT + 4, UNIT, UNIT + 4, UNIT)
        form.setHorizontalSpacing(2 * UNIT)
        form.setVerticalSpacing(UNIT)
        form.addRow(self.tr("Compare"), self.domain)
        form.addRow(self.tr("Longest side"), self.max_edge)
        form.addRow(self.tr("Equal (x, y)"), self.duplicates)
        form.addRow(self.tr("Seen"), self.project)
        form.addRow(self.tr("Unit"), self.unit)
        form.addRow(self.tr("Integrate"), self.exact)
        note = quiet_label(self.tr("Each change compares anew; Undo takes it back."))
        note.setWordWrap(True)
        form.addRow(note)

    def show_document(self, document: Document) -> None:
        """Show the options in force."""
        self._document = document
        options = document.options
        self.domain.show_choice(options.domain)
        self.duplicates.show_choice(options.duplicates)
        self.unit.show_choice(options.unit or "")
        self.project.show_choice(options.project if options.project in VIEWS else "z")
        if not self.max_edge.isModified():
            limit = options.max_edge
            self.max_edge.setText("" if limit is None else f"{limit:g}")
        self.exact.blockSignals(True)
        self.exact.setChecked(options.exact)
        self.exact.blockSignals(False)

    def _choice(self, texts: dict[object, str], option: str) -> ChoiceButton:
        button = ChoiceButton({key: self.tr(text) for key, text in texts.items()})
        button.chosen.connect(lambda key: self._option(**{option: key}))
        return button

    def _option(self, **changes: object) -> None:
        if self._document is not None:
            self.changed.emit(self._document.asking(**changes))

    def _max_edge_typed(self) -> None:
        self.max_edge.setModified(False)
        text = self.max_edge.text().strip().replace(",", ".")
        try:
            value = float(text) if text else None
        except ValueError:
            value = -1.0
        if value is None or value > 0:
            self._option(max_edge=value)
        if self._document is not None:
            self.show_document(self._document)
