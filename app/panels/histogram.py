"""The histogram of the differences over the area, on the range of the colours."""

from __future__ import annotations

from typing import TYPE_CHECKING, override

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPen

from app.look.theme import theme
from app.model.view_state import ViewState
from app.panels.plot import Plot
from surfcmp_core.colours.scale import coloured

if TYPE_CHECKING:
    from app.scene.content import Content
    from app.scene.distribution import Distribution

BINS = 80
HEIGHT = 168
NEAR_PIXELS = 5
"""So near to a tolerance's line the mouse takes hold of it."""


class Histogram(Plot):
    """Bars in the heatmap's colours; drag a tolerance's line, or drag over a range to brush it."""

    tolerance_moved = Signal(int, float)
    """Which tolerance, and where it is now."""
    brushed = Signal(object)
    """The range (low, high), or None."""

    def __init__(self) -> None:
        super().__init__(HEIGHT)
        self.setMouseTracking(True)
        self.setAccessibleName(self.tr("Histogram of the differences by area"))
        self.setToolTip(
            self.tr("Drag over a range to light it up, click to let it go; drag a tolerance's line")
        )
        self._edges = np.array([0.0, 1.0])
        self._shares = np.zeros(1)
        self._colours = np.zeros((1, 3), dtype=np.uint8)
        self._lines: list[tuple[int, float]] = []
        self._brush: tuple[float, float] | None = None
        self._held: int | None = None
        self._from: float | None = None

    def show_content(self, content: Content, state: ViewState, unit: str) -> None:
        """Show the distribution of a comparison in the colours and range of `state`."""
        scale = state.colours
        low, high = scale.low, scale.end
        edges = np.linspace(low, high, BINS + 1)
        middles = (edges[1:] + edges[:-1]) / 2
        self._colours = coloured(middles, scale, (0, 0, 0))
        self._edges = edges
        self._shares = 100 * distribution(content, state).histogram(edges)
        signs = (1, -1) if scale.signed else (1,)
        tolerances = enumerate(state.scale.tolerances)
        self._lines = [(k, sign * value) for k, value in tolerances for sign in signs]
        self._brush = state.brush
        top = max(float(self._shares.max()), 1e-6) * 1.05
        captions = (unit, self.tr("% of the area"))
        self.set_axes((low, high), (0.0, top), captions, theme(state.dark))

    @override
    def draw(self, painter: QPainter) -> None:
        area = self.area
        edge = QPen(QColor(self._theme.quiet), 0.5)
        for k, share in enumerate(self._shares.tolist()):
            if share > 0:
                painter.setPen(edge)
                painter.setBrush(QColor(*self._colours[k].tolist()))
                corner = self.to_screen(float(self._edges[k]), share)
                foot = self.to_screen(float(self._edges[k + 1]), 0.0)
                painter.drawRect(QRectF(corner, foot))
        if self._brush is not None:
            tint = QColor(self._theme.accent)
            tint.setAlphaF(0.18)
            x0, x1 = (self.to_screen(value, 0.0).x() for value in self._brush)
            painter.fillRect(QRectF(x0, area.top(), x1 - x0, area.height()), tint)
        painter.setPen(QPen(QColor(self._theme.text), 1, Qt.PenStyle.DashLine))
        for _, value in self._lines:
            x = self.to_screen(value, 0.0).x()
            painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()))

    def _line_at(self, position: QPointF) -> int | None:
        for number, value in self._lines:
            if abs(self.to_screen(value, 0.0).x() - position.x()) <= NEAR_PIXELS:
                return number
        return None

    @override
    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._held = self._line_at(event.position())
        self._from = None if self._held is not None else self.x_at(event.position())

    @override
    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at = self.x_at(event.position())
        if self._held is not None and event.buttons():
            self._lines = [
                (k, float(np.copysign(at, value)) if k == self._held else value)
                for k, value in self._lines
            ]
            self.update()
        elif self._from is not None and event.buttons():
            self._brush = (min(self._from, at), max(self._from, at))
            self.brushed.emit(self._brush)
        else:
            near = self._line_at(event.position()) is not None
            shape = Qt.CursorShape.SizeHorCursor if near else Qt.CursorShape.CrossCursor
            self.setCursor(shape)

    @override
    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        at = self.x_at(event.position())
        if self._held is not None:
            self.tolerance_moved.emit(self._held, abs(at))
        elif self._from is not None:
            a, b = self.to_screen(self._from, 0.0), self.to_screen(at, 0.0)
            if abs(a.x() - b.x()) < NEAR_PIXELS:
                self.brushed.emit(None)
        self._held = self._from = None


def distribution(content: Content, state: ViewState) -> Distribution:
    """Return the distribution the histogram shows: signed with a signed heatmap, else absolute."""
    found = content.distributions
    return found.signed if state.colours.signed else found.absolute
