"""What lies over a view's picture: the colour bar, the legend, the length bar."""

from dataclasses import replace
from typing import override

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from app.look.numerals import short, thousands
from app.look.texts import QT_TRANSLATE_NOOP
from app.look.theme import UNIT, Theme, tabular
from app.scene.furniture import ColourBar, Swatch
from app.scene.ticks import round_down
from surfcmp_core.colours.maps import Rgb

BAR_WIDTH = 14.0


class Overlay(QWidget):
    """Lets the mouse through to the view below."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        font = tabular(self.font())
        font.setPointSizeF(font.pointSizeF() * 0.9)
        self.setFont(font)
        self._theme: Theme | None = None

    def dress(self, theme: Theme) -> None:
        """Take the colours of a theme."""
        self._theme = theme
        self.update()

    def _begin(self) -> QPainter:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        return painter

    def _text(self) -> QColor:
        return QColor(self._theme.text if self._theme else "black")

    def _plate(self, painter: QPainter, opacity: float = 0.88) -> None:
        ground = QColor(self._theme.panel if self._theme else "white")
        ground.setAlphaF(opacity)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(ground)
        painter.drawRoundedRect(QRectF(self.rect()), 6, 6)


class ColourBarOverlay(Overlay):
    """The scale of the heatmap, upright, with what lies beyond its ends and no data."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._bar: ColourBar | None = None
        self._caption = ""

    def show_bar(self, bar: ColourBar | None, caption: str, no_data: str) -> None:
        """Show a scale under its caption, unit included; None hides it."""
        self._bar, self._caption, self._no_data = bar, caption, no_data
        self.setVisible(bar is not None)
        self.resize(self.sizeHint())
        self.update()

    @override
    def sizeHint(self) -> QSize:
        metrics = QFontMetricsF(self.font())
        texts = [short(value) for _, value in self._bar.ticks] if self._bar else [""]
        labels = BAR_WIDTH + UNIT + max(metrics.horizontalAdvance(text) for text in texts)
        widest = max(labels, metrics.horizontalAdvance(self._caption))
        widest = max(widest, BAR_WIDTH + UNIT + metrics.horizontalAdvance(self._no_data))
        return QSize(round(widest + 2.5 * UNIT), self.height())

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        if self._bar is None:
            return
        painter = self._begin()
        self._plate(painter)
        metrics = QFontMetricsF(self.font())
        line = metrics.height()
        left, top = UNIT + 2.0, UNIT + 0.0
        painter.setPen(self._text())
        painter.drawText(QPointF(left, top + metrics.ascent()), self._caption)
        top += line + UNIT
        bottom = self.height() - UNIT - line - UNIT
        end = 0.8 * BAR_WIDTH
        if self._bar.above:
            self._end(painter, left, top, end, self._bar.above, up=True)
            top += end + 2
        if self._bar.below:
            self._end(painter, left, bottom - end, end, self._bar.below, up=False)
            bottom -= end + 2
        self._ramp(painter, QRectF(left, top, BAR_WIDTH, bottom - top))
        painter.setPen(self._text())
        for place, value in self._bar.ticks:
            y = bottom - place * (bottom - top)
            painter.drawLine(QPointF(left + BAR_WIDTH, y), QPointF(left + BAR_WIDTH + UNIT / 2, y))
            middle = y + (metrics.ascent() - metrics.descent()) / 2
            painter.drawText(QPointF(left + BAR_WIDTH + UNIT, middle), short(value))
        y = self.height() - UNIT - line
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(*self._bar.no_data))
        painter.drawRoundedRect(QRectF(left, y + 2, BAR_WIDTH, line - 4), 2, 2)
        painter.setPen(self._text())
        painter.drawText(QPointF(left + BAR_WIDTH + UNIT, y + metrics.ascent()), self._no_data)

    def _ramp(self, painter: QPainter, box: QRectF) -> None:
        assert self._bar is not None
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        painter.setPen(Qt.PenStyle.NoPen)
        count = len(self._bar.colours)
        for k, colour in enumerate(self._bar.colours.tolist()):
            y0 = round(box.bottom() - (k + 1) * box.height() / count)
            y1 = round(box.bottom() - k * box.height() / count)
            painter.fillRect(QRectF(box.left(), y0, box.width(), y1 - y0), QColor(*colour))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)

    def _end(
        self, painter: QPainter, x: float, y: float, size: float, colour: Rgb, up: bool
    ) -> None:
        """Draw the triangle that stands for everything beyond an end."""
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(*colour))
        foot, tip = (y + size, y) if up else (y, y + size)
        painter.drawPolygon(
            [QPointF(x, foot), QPointF(x + BAR_WIDTH, foot), QPointF(x + BAR_WIDTH / 2, tip)]
        )


LEGEND = (
    QT_TRANSLATE_NOOP("LegendOverlay", "only nodes of 1 (clouts)"),
    QT_TRANSLATE_NOOP("LegendOverlay", "only nodes of 2 (clouts)"),
    QT_TRANSLATE_NOOP("LegendOverlay", "closed chains: {}"),
    QT_TRANSLATE_NOOP("LegendOverlay", "open chains: {}"),
    QT_TRANSLATE_NOOP("LegendOverlay", "rings round one node: {}"),
    QT_TRANSLATE_NOOP("LegendOverlay", "longer closed chains: {}"),
    QT_TRANSLATE_NOOP("LegendOverlay", "chains, short to long: {}"),
    QT_TRANSLATE_NOOP("LegendOverlay", "chains by their mean |d|: {}"),
    QT_TRANSLATE_NOOP("LegendOverlay", "chains, first to last found: {}"),
    QT_TRANSLATE_NOOP("LegendOverlay", "only shared nodes"),
    QT_TRANSLATE_NOOP("LegendOverlay", "rests on both grids"),
    QT_TRANSLATE_NOOP("LegendOverlay", "on grid 1 only"),
    QT_TRANSLATE_NOOP("LegendOverlay", "on grid 2 only"),
    QT_TRANSLATE_NOOP("LegendOverlay", "not compared"),
)
"""All texts of legends, for those who translate."""


class LegendOverlay(Overlay):
    """Colours and what they mean, line by line."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._swatches: tuple[Swatch, ...] = ()

    def show_legend(self, swatches: tuple[Swatch, ...]) -> None:
        """Show these lines; none hides the legend."""
        self._swatches = tuple(
            replace(swatch, text=self.tr(swatch.text).format(thousands(swatch.count or 0)))
            for swatch in swatches
        )
        self.setVisible(bool(swatches))
        self.resize(self.sizeHint())
        self.update()

    @override
    def sizeHint(self) -> QSize:
        metrics = QFontMetricsF(self.font())
        texts = [metrics.horizontalAdvance(swatch.text) for swatch in self._swatches]
        width = 2 * UNIT + 3.5 * UNIT + UNIT + max(texts, default=0)
        return QSize(round(width), round(2 * UNIT + len(texts) * self._line()))

    def _line(self) -> float:
        return QFontMetricsF(self.font()).height() + UNIT / 2

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = self._begin()
        self._plate(painter)
        metrics = QFontMetricsF(self.font())
        for k, swatch in enumerate(self._swatches):
            y = UNIT + k * self._line() + UNIT / 4
            width = 3.5 * UNIT / len(swatch.colours)
            painter.setPen(Qt.PenStyle.NoPen)
            for i, colour in enumerate(swatch.colours):
                painter.setBrush(QColor(*colour))
                painter.drawRect(QRectF(UNIT + i * width, y + 2, width, metrics.height() - 4))
            painter.setPen(self._text())
            painter.drawText(QPointF(5.5 * UNIT, y + metrics.ascent()), swatch.text)


class LengthBar(Overlay):
    """How long something on the picture is, in the unit of the input."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._length = 0.0
        self._unit = ""
        self._pixels = 0.0

    def show_length(self, per_pixel: float, unit: str) -> None:
        """Show a bar of a round length, about a hundred pixels wide."""
        self._length = round_down(110 * per_pixel)
        self._pixels = self._length / per_pixel if per_pixel else 0.0
        self._unit = unit
        metrics = QFontMetricsF(self.font())
        width = max(self._pixels, metrics.horizontalAdvance(self._label())) + 2 * UNIT
        self.resize(round(width), round(metrics.height() + 2 * UNIT))
        self.update()

    def _label(self) -> str:
        return f"{short(self._length)} {self._unit}".strip()

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = self._begin()
        self._plate(painter, 0.7)
        metrics = QFontMetricsF(self.font())
        left = float(UNIT)
        y = self.height() - UNIT
        text = self._text()
        painter.setPen(QPen(text, 1.5))
        painter.drawLine(QPointF(left, y), QPointF(left + self._pixels, y))
        for x in (left, left + self._pixels):
            painter.drawLine(QPointF(x, y - 3), QPointF(x, y + 3))
        painter.drawText(QPointF(left, UNIT / 2 + metrics.ascent()), self._label())
