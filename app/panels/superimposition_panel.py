"""How both scans are drawn in one scene: opacity, fade, the plane that cuts them."""

from dataclasses import replace

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QFormLayout,
    QGridLayout,
    QLabel,
    QSizePolicy,
    QSlider,
    QVBoxLayout,
)

from app.look.texts import QT_TRANSLATE_NOOP
from app.look.theme import UNIT
from app.model.superimposition import Cut, Style, Superimposition
from app.panels.widgets import ChoiceButton, Panel, quiet_label, tool_button

STEPS = 100
STYLES: dict[object, str] = {
    Style.SOLID: QT_TRANSLATE_NOOP("SuperimpositionPanel", "Solid"),
    Style.WIRE: QT_TRANSLATE_NOOP("SuperimpositionPanel", "Wire"),
    Style.POINTS: QT_TRANSLATE_NOOP("SuperimpositionPanel", "Nodes"),
}
CUTS: dict[object, str] = {
    None: QT_TRANSLATE_NOOP("SuperimpositionPanel", "No cut"),
    0: QT_TRANSLATE_NOOP("SuperimpositionPanel", "Across x"),
    1: QT_TRANSLATE_NOOP("SuperimpositionPanel", "Across y"),
}
SIDES = {
    "front": QT_TRANSLATE_NOOP("SuperimpositionPanel", "Front"),
    "left": QT_TRANSLATE_NOOP("SuperimpositionPanel", "Left"),
    "right": QT_TRANSLATE_NOOP("SuperimpositionPanel", "Right"),
    "three-quarter": QT_TRANSLATE_NOOP("SuperimpositionPanel", "Three-quarter"),
    "below": QT_TRANSLATE_NOOP("SuperimpositionPanel", "Below"),
}


def _slider(name: str) -> QSlider:
    slider = QSlider(Qt.Orientation.Horizontal)
    slider.setRange(0, STEPS)
    slider.setAccessibleName(name)
    slider.setToolTip(name)
    return slider


class SuperimpositionPanel(Panel):
    """Each change is told as a whole `Superimposition`."""

    changed = Signal(object)
    view_asked = Signal(str)
    measure_asked = Signal(bool)
    picture_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._state = Superimposition()
        names = (self.tr("Surface 1"), self.tr("Surface 2"))
        self.opacities = [_slider(self.tr("Opacity of {}").format(name.lower())) for name in names]
        styles = {key: self.tr(text) for key, text in STYLES.items()}
        self.styles = [ChoiceButton(styles) for _ in names]
        self.heatmaps = [QCheckBox(self.tr("Difference as colour")) for _ in names]
        self.fade = _slider(self.tr("Fade from surface 1 to surface 2; the space bar swaps them"))
        self.axis = ChoiceButton({key: self.tr(text) for key, text in CUTS.items()})
        self.place = _slider(self.tr("Where the plane cuts"))
        self.before = QCheckBox(self.tr("Surface 2 before it was moved"))
        self.perspective = QCheckBox(self.tr("Perspective"))
        self.measure = tool_button(self.tr("Ruler and angle"))
        self.measure.setCheckable(True)
        self.measure.setToolTip(
            self.tr("Click two places for a distance, a third one for the angle at the second")
        )
        self.picture = tool_button(self.tr("Save picture…"))
        self.reading = QLabel()
        self.reading.setWordWrap(True)
        self.reading.setMinimumHeight(12 * UNIT)
        self.reading.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._arrange(names)
        for k in range(2):
            self.opacities[k].valueChanged.connect(
                lambda value, k=k: self._dress(k, opacity=value / STEPS)
            )
            self.styles[k].chosen.connect(lambda style, k=k: self._dress(k, style=style))
            self.heatmaps[k].toggled.connect(lambda on, k=k: self._dress(k, heatmap=on))
        self.fade.valueChanged.connect(lambda value: self._change(fade=value / STEPS))
        self.axis.chosen.connect(self._cut)
        self.place.valueChanged.connect(self._slide)
        self.before.toggled.connect(lambda on: self._change(before=on))
        self.perspective.toggled.connect(lambda on: self._change(perspective=on))
        self.measure.toggled.connect(self.measure_asked)
        self.picture.clicked.connect(self.picture_asked)
        self.show_state(self._state, moved=False)

    def _arrange(self, names: tuple[str, str]) -> None:
        form = QFormLayout()
        form.setHorizontalSpacing(UNIT)
        form.setVerticalSpacing(UNIT)
        for k, name in enumerate(names):
            heading = quiet_label(name)
            heading.setProperty("kind", "heading")
            form.addRow(heading)
            form.addRow(self.tr("Opacity"), self.opacities[k])
            form.addRow(self.tr("Drawn as"), self.styles[k])
            form.addRow(self.heatmaps[k])
        heading = quiet_label(self.tr("Both"))
        heading.setProperty("kind", "heading")
        form.addRow(heading)
        form.addRow(self.tr("Fade"), self.fade)
        form.addRow(self.tr("Plane"), self.axis)
        form.addRow(self.place)
        form.addRow(self.before)
        form.addRow(self.perspective)
        sides = QGridLayout()
        sides.setSpacing(UNIT // 2)
        self.sides = {}
        for number, (view, text) in enumerate(SIDES.items()):
            self.sides[view] = button = tool_button(self.tr(text))
            button.clicked.connect(lambda _=False, v=view: self.view_asked.emit(v))
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            row, across = divmod(number, 3)
            width = 2 if row == 0 else 3  # three, and under them two
            sides.addWidget(button, row, width * across, 1, width)
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * UNIT, 2 * UNIT, 2 * UNIT, 2 * UNIT)
        column.setSpacing(2 * UNIT)
        column.addLayout(form)
        column.addLayout(sides)
        column.addWidget(self.measure)
        column.addWidget(self.picture)
        column.addWidget(self.reading)

    def show_state(self, state: Superimposition, *, moved: bool) -> None:
        """Show how the scans are drawn; `moved`: surface 2 was moved onto surface 1."""
        self._state = state
        self.before.setEnabled(moved)
        widgets = [*self.opacities, *self.heatmaps, self.fade, self.place, self.before]
        blockers = [QSignalBlocker(widget) for widget in (*widgets, self.perspective)]
        for k, coat in enumerate(state.coats):
            self.opacities[k].setValue(round(coat.opacity * STEPS))
            self.styles[k].show_choice(coat.style)
            self.heatmaps[k].setChecked(coat.heatmap)
        self.fade.setValue(round(state.fade * STEPS))
        self.axis.show_choice(None if state.cut is None else state.cut.axis)
        self.place.setEnabled(state.cut is not None)
        if state.cut is not None:
            self.place.setValue(round(state.cut.share * STEPS))
        self.before.setChecked(state.before)
        self.perspective.setChecked(state.perspective)
        del blockers

    def read(self, text: str) -> None:
        """Show what is read off the scene."""
        self.reading.setText(text)

    def _change(self, **changes: object) -> None:
        self.changed.emit(replace(self._state, **changes))  # type: ignore[arg-type]

    def _dress(self, surface: int, **changes: object) -> None:
        coat = replace(self._state.coats[surface], **changes)  # type: ignore[arg-type]
        self.changed.emit(self._state.dressed(surface, coat))

    def _cut(self, axis: int | None) -> None:
        self._change(cut=None if axis is None else Cut(axis, self.place.value() / STEPS or 0.5))

    def _slide(self, value: int) -> None:
        if self._state.cut is not None:
            self._change(cut=replace(self._state.cut, share=value / STEPS))
