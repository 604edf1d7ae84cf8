"""The line under the menus: the two inputs, flat or relief, what the heatmap shows."""

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor, QIcon, QPainter, QPixmap
from PySide6.QtWidgets import (
    QButtonGroup,
    QComboBox,
    QHBoxLayout,
    QPushButton,
    QSizePolicy,
    QToolBar,
    QWidget,
)

from app.model.view_state import Heatmap, ViewState
from app.panels.widgets import tool_button
from app.scene.colour_maps import Rgb
from app.scene.palette import palette

HEATMAPS = {
    Heatmap.SIGNED: "Signed difference",
    Heatmap.ABSOLUTE: "Absolute difference",
    Heatmap.REPRESENTATIVE: "Difference, both grids only",
    Heatmap.TRUST: "Trust map",
    Heatmap.HEIGHT_1: "Height of 1",
    Heatmap.HEIGHT_2: "Height of 2",
}


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
        self.swap = tool_button("⇄", self.tr("Exchange surfaces 1 and 2"), plain=True)
        self.swap.clicked.connect(self.swap_asked)
        self.addWidget(self.surfaces[0])
        self.addWidget(self.swap)
        self.addWidget(self.surfaces[1])
        gap = QWidget()
        gap.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.addWidget(gap)
        self.addWidget(self._relief_switch())
        self.heatmap = QComboBox()
        self.heatmap.setAccessibleName(self.tr("What the heatmap shows"))
        for kind, text in HEATMAPS.items():
            self.heatmap.addItem(self.tr(text), kind)
        self.heatmap.activated.connect(
            lambda row: self.heatmap_chosen.emit(Heatmap(self.heatmap.itemData(row)))
        )
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
        self.heatmap.setCurrentIndex(list(HEATMAPS).index(state.heatmap))
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


def dot(colour: Rgb) -> QIcon:
    """Return a round patch of a colour."""
    pixmap = QPixmap(24, 24)
    pixmap.fill(QColor(0, 0, 0, 0))
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QColor(0, 0, 0, 60))
    painter.setBrush(QColor(*colour))
    painter.drawEllipse(4, 4, 16, 16)
    painter.end()
    return QIcon(pixmap)
