"""The line under the menus: the two inputs, flat or relief, what the heatmap shows."""

from pathlib import Path

from PySide6.QtCore import QCoreApplication, QSize, Qt, Signal
from PySide6.QtWidgets import (
    QButtonGroup,
    QHBoxLayout,
    QPushButton,
    QSizePolicy,
    QToolBar,
    QWidget,
)

from app.look.icons import dot, icon
from app.look.texts import QT_TRANSLATE_NOOP
from app.look.theme import theme
from app.model.view_state import Heatmap, ViewState
from app.panels.widgets import ChoiceButton, tool_button
from app.scene.quiet_colours import palette

HEATMAPS = {
    Heatmap.SIGNED: QT_TRANSLATE_NOOP("Toolbar", "Signed difference"),
    Heatmap.ABSOLUTE: QT_TRANSLATE_NOOP("Toolbar", "Absolute difference"),
    Heatmap.REPRESENTATIVE: QT_TRANSLATE_NOOP("Toolbar", "Difference, both grids only"),
    Heatmap.TRUST: QT_TRANSLATE_NOOP("Toolbar", "Trust map"),
    Heatmap.HEIGHT_1: QT_TRANSLATE_NOOP("Toolbar", "Height of 1"),
    Heatmap.HEIGHT_2: QT_TRANSLATE_NOOP("Toolbar", "Height of 2"),
}


def heatmap_name(heatmap: Heatmap) -> str:
    """Return what a heatmap is called."""
    return QCoreApplication.translate("Toolbar", HEATMAPS[heatmap])


class Toolbar(QToolBar):
    """What is used all the time."""

    surface_asked = Signal(int)
    """The user wants another file as surface 1 or 2."""
    swap_asked = Signal()
    relief_chosen = Signal(bool)
    heatmap_chosen = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.setWindowTitle(self.tr("Main toolbar"))
        self.setMovable(False)
        self.surfaces = [QPushButton(), QPushButton()]
        for number, button in enumerate(self.surfaces, 1):
            button.setMaximumWidth(260)
            button.setToolTip(self.tr("Open another file as surface {}").format(number))
            button.clicked.connect(lambda _=False, n=number: self.surface_asked.emit(n))
        self.swap = tool_button("", self.tr("Exchange surfaces 1 and 2"), plain=True)
        self.swap.setIconSize(QSize(16, 16))
        self.swap.clicked.connect(self.swap_asked)
        self.addWidget(self.surfaces[0])
        self.addWidget(self.swap)
        self.addWidget(self.surfaces[1])
        gap = QWidget()
        gap.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.addWidget(gap)
        self.addWidget(self._relief_switch())
        self.heatmap = ChoiceButton({kind: heatmap_name(kind) for kind in HEATMAPS})
        self.heatmap.setToolTip(self.tr("What the fourth view shows"))
        self.heatmap.chosen.connect(self.heatmap_chosen)
        self.addWidget(self.heatmap)

    def _relief_switch(self) -> QWidget:
        switch = QWidget()
        row = QHBoxLayout(switch)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(0)
        group = QButtonGroup(switch)
        self.map = tool_button(self.tr("Map"), self.tr("Seen straight from above (M)"))
        tip = self.tr("With heights; turn with the left button (M)")
        self.relief = tool_button(self.tr("Relief"), tip)
        for button, segment in ((self.map, "first"), (self.relief, "last")):
            button.setCheckable(True)
            button.setProperty("segment", segment)
            group.addButton(button)
            row.addWidget(button)
        self.relief.clicked.connect(lambda: self.relief_chosen.emit(True))
        self.map.clicked.connect(lambda: self.relief_chosen.emit(False))
        return switch

    def show_state(self, state: ViewState) -> None:
        """Show the view state."""
        self.relief.setChecked(state.relief)
        self.map.setChecked(not state.relief)
        self.heatmap.show_choice(state.heatmap)
        self.swap.setIcon(icon("swap", theme(state.dark).text))
        quiet = palette(state.dark)
        for button, colour in zip(self.surfaces, (quiet.surface_1, quiet.surface_2), strict=True):
            button.setIcon(dot(colour))

    def show_paths(self, paths: tuple[Path | None, Path | None]) -> None:
        """Show what is open."""
        for number, (button, path) in enumerate(zip(self.surfaces, paths, strict=True), 1):
            name = path.name if path else self.tr("Open surface {}…").format(number)
            room = button.fontMetrics()
            button.setText(room.elidedText(name, Qt.TextElideMode.ElideMiddle, 200))
            button.setAccessibleName(self.tr("Surface {}: {}").format(number, name))
        self.swap.setEnabled(all(paths))
