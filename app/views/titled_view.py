"""One view: a title, and the canvas with what lies over it."""

from typing import override

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QToolButton, QVBoxLayout, QWidget

from app.look.icons import icon
from app.look.theme import UNIT, Theme
from app.scene.furniture import ColourBar, Swatch
from app.views.canvas import Canvas
from app.views.overlays import ColourBarOverlay, LegendOverlay, LengthBar

TITLE_HEIGHT = 4 * UNIT


class ViewTitle(QWidget):
    """The line over a view: its number and name, a fact on the right, a button to fill."""

    filled = Signal()

    def __init__(self, number: int) -> None:
        super().__init__()
        self.setObjectName("viewTitle")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setFixedHeight(TITLE_HEIGHT)
        self._name = QLabel()
        self._name.setObjectName("title")
        self.fact = QLabel()
        self.fact.setProperty("kind", "quiet")
        self.fact.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self.fact.setMinimumWidth(0)
        self.button = QToolButton()
        self.button.setProperty("kind", "plain")
        self.button.setToolTip(
            self.tr("Let this view fill the window, or give the place back ({})").format(number)
        )
        self.button.clicked.connect(self.filled)
        row = QHBoxLayout(self)
        row.setContentsMargins(UNIT + 4, 0, UNIT // 2, 0)
        row.setSpacing(UNIT)
        row.addWidget(self._name)
        row.addWidget(self.fact, 1)
        row.addWidget(self.button)

    @property
    def text(self) -> str:
        """The view's name."""
        return self._name.text()

    def set_texts(self, name: str, fact: str) -> None:
        """Show the view's name and a fact beside it."""
        self._name.setText(name)
        self.fact.setText(fact)

    @override
    def mouseDoubleClickEvent(self, _event: QMouseEvent) -> None:
        self.filled.emit()


class ViewFrame(QFrame):
    """A titled canvas."""

    def __init__(self, number: int, name: str) -> None:
        super().__init__()
        self.setObjectName("view")
        self.title = ViewTitle(number)
        self.canvas = Canvas(name)
        self.bar = ColourBarOverlay(self.canvas)
        self.legend = LegendOverlay(self.canvas)
        self.length = LengthBar(self.canvas)
        for overlay in (self.bar, self.legend, self.length):
            overlay.hide()
        column = QVBoxLayout(self)
        column.setContentsMargins(1, 1, 1, 1)
        column.setSpacing(0)
        column.addWidget(self.title)
        column.addWidget(self.canvas, 1)
        self.canvas.installEventFilter(self)

    def dress(self, theme: Theme) -> None:
        """Take the colours of a theme."""
        self.title.button.setIcon(icon("fill", theme.quiet))
        for overlay in (self.bar, self.legend, self.length):
            overlay.dress(theme)

    def explain(
        self, bar: ColourBar | None, caption: str, no_data: str, legend: tuple[Swatch, ...]
    ) -> None:
        """Show what explains the picture."""
        self.bar.show_bar(bar, caption, no_data)
        self.legend.show_legend(legend)
        self._arrange()

    def measure(self, per_pixel: float, unit: str) -> None:
        """Show how long a hundred pixels are; 0 hides it."""
        self.length.setVisible(per_pixel > 0)
        self.length.show_length(per_pixel, unit)
        self._arrange()

    @override
    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self._arrange()
        return super().eventFilter(watched, event)

    def _arrange(self) -> None:
        width, height = self.canvas.width(), self.canvas.height()
        tall = min(height - 2 * UNIT, 280)
        wide = self.bar.sizeHint().width() if self.bar.isVisibleTo(self.canvas) else 0
        self.bar.setGeometry(width - wide - UNIT, UNIT, wide, tall)
        self.legend.move(UNIT, UNIT)
        self.length.move(UNIT, height - self.length.height() - UNIT)
