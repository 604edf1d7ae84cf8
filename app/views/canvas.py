"""One view on the screen: shows its picture and tells what the mouse does over it."""

from dataclasses import dataclass
from typing import override

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QEnterEvent,
    QFontMetricsF,
    QImage,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPolygonF,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.look.theme import LIGHT, UNIT, Theme
from app.model.tool import Tool

CLICK_PIXELS = 4
"""A press that moved less is a click."""
WHEEL_STEP = 1.15


@dataclass(frozen=True, slots=True)
class Label:
    """A value that stands beside its place, in shares of the height from the middle."""

    right: float
    up: float
    text: str
    kept: bool
    corners: tuple[tuple[float, float], ...] = ()
    """Of its triangle, to be outlined."""


class _Top(QWidget):
    """Lies over the picture, the legend and the scale, and lets the mouse through."""

    def __init__(self, canvas: "Canvas") -> None:
        super().__init__(canvas)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._canvas = canvas

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        self._canvas.draw_over(QPainter(self))


class Canvas(QWidget):
    """Places on it are told in shares of its height from its middle, upwards positive."""

    turned = Signal(float, float)
    panned = Signal(float, float)
    zoomed = Signal(float, float, float)
    """Factor, and the place that stays."""
    clicked = Signal(float, float)
    drawn = Signal(object)
    """The places of a path, once the button is up."""
    filled = Signal()
    resized = Signal()

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setAccessibleName(name)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(160, 120)
        self._image: QImage | None = None
        self._theme = LIGHT
        self.labels: list[Label] = []
        self._press: QPointF | None = None
        self._last = QPointF()
        self._moved = False
        self.turning = True
        """The left button turns; else it slides the map."""
        self.tool = Tool.LOOK
        self.brush = 0.0
        """Radius of the brush, in shares of the height."""
        self._path: list[QPointF] = []
        self.hover: QPointF | None = None
        """Where the brush is."""
        self._top = _Top(self)

    @override
    def sizeHint(self) -> QSize:
        return QSize(480, 360)

    @property
    def image(self) -> QImage | None:
        """The picture it shows."""
        return self._image

    def show_image(self, image: QImage | None, theme: Theme) -> None:
        """Show a picture, stretched to the widget where their sizes differ."""
        self._image, self._theme = image, theme
        self.update()

    def show_labels(self, labels: list[Label]) -> None:
        """Lay labels over the picture."""
        self.labels = labels
        self._top.update()

    def pixels(self) -> tuple[int, int]:
        """Width and height in device pixels."""
        ratio = self.devicePixelRatioF()
        return max(round(self.width() * ratio), 1), max(round(self.height() * ratio), 1)

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(self._theme.view))
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        if self._image is not None:
            painter.drawImage(self._target(self._image), self._image)

    def draw_over(self, painter: QPainter) -> None:
        """Draw labels, and what the tool has drawn."""
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for label in self.labels:
            self._draw_label(painter, label)
        self._draw_path(painter)

    def _draw_label(self, painter: QPainter, label: Label) -> None:
        """Draw a dot on the place and its value beside it."""
        at = self.position(label.right, label.up)
        painter.setPen(QPen(QColor(self._theme.accent), 2))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawPolygon(QPolygonF([self.position(*corner) for corner in label.corners]))
        metrics = QFontMetricsF(self.font())
        wide = metrics.horizontalAdvance(label.text) + 1.5 * UNIT
        box = QRectF(at.x() + UNIT, at.y() - 3 * UNIT, wide, metrics.height() + UNIT / 2)
        ground = QColor(self._theme.panel if label.kept else self._theme.accent)
        text = QColor(self._theme.text if label.kept else self._theme.on_accent)
        painter.setPen(QPen(QColor(self._theme.text), 1))
        painter.drawLine(at, QPointF(box.left(), box.bottom() - 2))
        painter.setBrush(ground)
        painter.drawEllipse(at, 3.0, 3.0)
        painter.setPen(QPen(QColor(self._theme.line), 1))
        painter.drawRoundedRect(box, 4, 4)
        painter.setPen(text)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, label.text)

    def _draw_path(self, painter: QPainter) -> None:
        """Draw what the tool has drawn so far, and how large the brush is."""
        if self.hover is not None:
            painter.setPen(QPen(QColor(self._theme.accent), 1.5))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawEllipse(self.hover, *[self.brush * self.height()] * 2)
        if not self._path:
            return
        colour = QColor(self._theme.accent)
        pen = QPen(colour, 2)
        if self.tool is Tool.BRUSH:
            colour.setAlphaF(0.4)
            pen = QPen(colour, 2 * self.brush * self.height())
            pen.setCapStyle(Qt.PenCapStyle.RoundCap)
            pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
        painter.setPen(pen)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        if self.tool is Tool.SECTION:
            painter.drawLine(self._path[0], self._path[-1])
        elif len(self._path) == 1:
            painter.drawPoint(self._path[0])
        else:
            painter.drawPolyline(QPolygonF(self._path))

    def _target(self, image: QImage) -> QRectF:
        """Where the picture goes: its height fills the widget, its middle stays the middle."""
        width = self.height() * image.width() / image.height()
        return QRectF((self.width() - width) / 2, 0, width, self.height())

    @override
    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._top.resize(self.size())
        self._top.raise_()
        self.resized.emit()

    def _place(self, position: QPointF) -> tuple[float, float]:
        height = max(self.height(), 1)
        return (
            (position.x() - self.width() / 2) / height,
            (self.height() / 2 - position.y()) / height,
        )

    def position(self, right: float, up: float) -> QPointF:
        """Return where a point lies, given in shares of the height from the middle."""
        height = self.height()
        return QPointF(self.width() / 2 + right * height, height / 2 - up * height)

    @override
    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._press = self._last = event.position()
        self._moved = False
        if self.tool.draws and event.button() == Qt.MouseButton.LeftButton:
            self._path = [event.position()]
            self._top.update()

    @override
    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self.tool is Tool.BRUSH:
            self.hover = event.position()
            self._top.update()
        if self._press is None:
            return
        if self._path:
            self._path.append(event.position())
            self._top.update()
            return
        away = event.position() - self._press
        self._moved = self._moved or away.manhattanLength() >= CLICK_PIXELS
        if not self._moved:
            return
        step = event.position() - self._last
        self._last = event.position()
        right, up = step.x() / max(self.height(), 1), -step.y() / max(self.height(), 1)
        turner = Qt.MouseButton.RightButton if self.tool.draws else Qt.MouseButton.LeftButton
        shifted = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if event.buttons() & turner and self.turning and not shifted:
            self.turned.emit(right * 3.2, up * 3.2)
        else:
            self.panned.emit(right, up)

    @override
    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._press is None:
            return
        self._press = None
        if self._path:
            path, self._path = self._path, []
            self._top.update()
            self.drawn.emit([self._place(position) for position in path])
        elif not self._moved and event.button() == Qt.MouseButton.LeftButton:
            self.clicked.emit(*self._place(event.position()))

    @override
    def mouseDoubleClickEvent(self, _event: QMouseEvent) -> None:
        self._press = None
        if self.tool is not Tool.LOOK:
            return
        self.filled.emit()

    def take(self, tool: Tool) -> None:
        """Take a tool in hand."""
        self.tool = tool
        self.setMouseTracking(tool is Tool.BRUSH)  # its size follows the pointer
        self.hover = None
        self._top.update()
        self._shape_pointer()

    @override
    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.hover = None
        self._top.update()

    @override
    def enterEvent(self, event: QEnterEvent) -> None:
        super().enterEvent(event)
        self._shape_pointer()

    def _shape_pointer(self) -> None:
        if self.tool is not Tool.LOOK:
            self.setCursor(Qt.CursorShape.CrossCursor)
        elif self.turning:
            self.setCursor(Qt.CursorShape.ArrowCursor)
        else:
            self.setCursor(Qt.CursorShape.OpenHandCursor)

    @override
    def wheelEvent(self, event: QWheelEvent) -> None:
        notches = event.angleDelta().y() / 120
        self.zoomed.emit(WHEEL_STEP**notches, *self._place(event.position()))
