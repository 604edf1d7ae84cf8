"""A small plot with axes: the ground of the histogram and of the section."""

from typing import override

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.look.numerals import short
from app.look.theme import LIGHT, UNIT, Theme, tabular
from app.scene.ticks import ticks


class Plot(QWidget):
    """Values on two axes; subclasses draw into `area` with `to_screen`."""

    def __init__(self, height: int) -> None:
        super().__init__()
        self._height = height
        self.setMinimumHeight(2 * height // 3)
        self.setMaximumHeight(2 * height)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        font = tabular(self.font())
        font.setPointSizeF(font.pointSizeF() * 0.9)
        self.setFont(font)
        self._theme = LIGHT
        self._x = (0.0, 1.0)
        self._y = (0.0, 1.0)
        self._captions = ("", "")
        self._key: list[tuple[str, QColor]] = []
        self.margin = 0.0
        """Least room for numbers at the left: plots under each other share theirs."""

    @override
    def sizeHint(self) -> QSize:
        return QSize(40 * UNIT, self._height)

    def set_axes(
        self,
        x: tuple[float, float],
        y: tuple[float, float],
        captions: tuple[str, str],
        theme: Theme,
    ) -> None:
        """Set the ranges and captions of the axes."""
        self._x, self._y, self._captions, self._theme = x, y, captions, theme
        self.update()

    def set_key(self, key: list[tuple[str, QColor]]) -> None:
        """Name the colours of curves, above them."""
        self._key = key
        self.update()

    @property
    def area(self) -> QRectF:
        """Where the values are drawn."""
        metrics = QFontMetricsF(self.font())
        labels = [metrics.horizontalAdvance(short(value)) for value in self._ticks(self._y, 4)]
        left = max(self.margin, max(labels, default=0.0) + UNIT)
        top = metrics.height() + UNIT / 2
        bottom = metrics.height() + UNIT / 2
        return QRectF(left, top, self.width() - left - UNIT, self.height() - top - bottom)

    def to_screen(self, x: float, y: float) -> QPointF:
        """Return where a pair of values is drawn."""
        area = self.area
        (x0, x1), (y0, y1) = self._x, self._y
        return QPointF(
            area.left() + (x - x0) / (x1 - x0) * area.width(),
            area.bottom() - (y - y0) / (y1 - y0) * area.height(),
        )

    def x_at(self, position: QPointF) -> float:
        """Return the value of the horizontal axis at a place of the widget, within the axis."""
        area = self.area
        share = min(max((position.x() - area.left()) / area.width(), 0.0), 1.0)
        return self._x[0] + share * (self._x[1] - self._x[0])

    @staticmethod
    def _ticks(span: tuple[float, float], most: int) -> list[float]:
        return ticks(span[0], span[1], most)

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        if not any(self._captions):  # nothing to show yet
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._draw_axes(painter)
        painter.setClipRect(self.area.adjusted(-1, -1, 1, 1))
        self.draw(painter)

    def draw(self, painter: QPainter) -> None:
        """Draw the values."""

    def _draw_axes(self, painter: QPainter) -> None:
        area, metrics = self.area, QFontMetricsF(self.font())
        quiet, line = QColor(self._theme.quiet), QPen(QColor(self._theme.line), 1)
        for value in self._ticks(self._y, 4):
            y = self.to_screen(self._x[0], value).y()
            painter.setPen(line)
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y))
            box = QRectF(0, y - metrics.height() / 2, area.left() - UNIT / 2, metrics.height())
            painter.setPen(quiet)
            right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
            painter.drawText(box, right, short(value))
        for value in self._ticks(self._x, 7):
            x = self.to_screen(value, self._y[0]).x()
            wide = metrics.horizontalAdvance(short(value))
            left = min(max(x - wide / 2, 0.0), self.width() - wide)
            painter.setPen(quiet)
            painter.drawText(QPointF(left, self.height() - metrics.descent()), short(value))
        painter.setPen(quiet)
        painter.drawText(QPointF(area.left(), metrics.ascent()), self._captions[1])
        wide = metrics.horizontalAdvance(self._captions[0])
        painter.drawText(QPointF(area.right() - wide, metrics.ascent()), self._captions[0])
        x = area.left() + metrics.horizontalAdvance(self._captions[1]) + 2 * UNIT
        for name, colour in self._key:
            y = metrics.ascent() - metrics.xHeight() / 2
            painter.setPen(QPen(colour, 2.5))
            painter.drawLine(QPointF(x, y), QPointF(x + 1.5 * UNIT, y))
            painter.setPen(quiet)
            painter.drawText(QPointF(x + 2 * UNIT, metrics.ascent()), name)
            x += 4 * UNIT + metrics.horizontalAdvance(name)
