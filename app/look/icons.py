"""The few icons, drawn in the colour of the text around them."""

from collections.abc import Callable

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QIcon, QPainter, QPen, QPixmap, QPolygonF

SIZE = 16
DENSITY = 3


def icon(name: str, colour: str) -> QIcon:
    """Return the icon called `name`: fill, restore, close or swap."""
    pixmap = QPixmap(SIZE * DENSITY, SIZE * DENSITY)
    pixmap.setDevicePixelRatio(DENSITY)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    pen = QPen(QColor(colour), 1.4)
    pen.setCapStyle(Qt.PenCapStyle.RoundCap)
    pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
    painter.setPen(pen)
    DRAWINGS[name](painter)
    painter.end()
    return QIcon(pixmap)


def dot(colour: tuple[int, int, int]) -> QIcon:
    """Return a round patch of a colour."""
    pixmap = QPixmap(SIZE * DENSITY, SIZE * DENSITY)
    pixmap.setDevicePixelRatio(DENSITY)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QColor(0, 0, 0, 60))
    painter.setBrush(QColor(*colour))
    painter.drawEllipse(QRectF(3, 3, 10, 10))
    painter.end()
    return QIcon(pixmap)


def _corners(painter: QPainter, out: float, bend: float) -> None:
    for sx in (-1, 1):
        for sy in (-1, 1):
            ends = [(sx * bend, sy * out), (sx * out, sy * out), (sx * out, sy * bend)]
            painter.drawPolyline(QPolygonF([QPointF(8 + x, 8 + y) for x, y in ends]))


def _fill(painter: QPainter) -> None:
    _corners(painter, 5.0, 2.0)


def _restore(painter: QPainter) -> None:
    _corners(painter, 2.0, 5.0)


def _close(painter: QPainter) -> None:
    painter.drawLine(QPointF(4.5, 4.5), QPointF(11.5, 11.5))
    painter.drawLine(QPointF(11.5, 4.5), QPointF(4.5, 11.5))


def _swap(painter: QPainter) -> None:
    for y, tip, tail in ((5.5, 13.0, 3.0), (10.5, 3.0, 13.0)):
        painter.drawLine(QPointF(tail, y), QPointF(tip, y))
        back = 2.6 if tip < tail else -2.6
        head = [(tip + back, y - 2.4), (tip, y), (tip + back, y + 2.4)]
        painter.drawPolyline(QPolygonF([QPointF(*place) for place in head]))


DRAWINGS: dict[str, Callable[[QPainter], None]] = {
    "fill": _fill,
    "restore": _restore,
    "close": _close,
    "swap": _swap,
}
