"""Both scans in one scene, in a window of its own; the only widget that VTK draws into itself."""

from typing import Any, override

from PySide6.QtCore import QEvent, QObject, QPointF, Qt, QTimer, Signal, SignalInstance
from PySide6.QtGui import QImage, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QHBoxLayout, QVBoxLayout, QWidget
from pyvistaqt import QtInteractor

from app.drawing.skins import SuperimposedScene
from app.look.theme import UNIT
from app.scene.superimposed import Superimposed

Place = tuple[float, float, float]

HOVER_MILLISECONDS = 60
CLICK_PIXELS = 4.0
"""A press that moves less than this is a click."""


class SuperimpositionView(QWidget):
    """A scene that one turns with the mouse, and a panel beside it.

    Made when it is first wanted; `close_for_good` before the application ends.
    """

    flickered = Signal()
    pointed = Signal(object)
    """(surface, triangle, place in the scene) under the pointer, or None."""
    clicked = Signal(object)
    """The same, where the mouse was pressed."""

    def __init__(self, panel: QWidget) -> None:
        super().__init__()
        self.setWindowTitle(self.tr("Both scans in one scene"))
        self.setObjectName("panel")
        make: Any = QtInteractor  # whose signature its wrapper hides
        self.interactor = make(self, auto_update=False, multi_samples=0, lighting="none")
        self.scene = SuperimposedScene(self.interactor)
        self.interactor.add_axes(color="gray")  # legible on either ground
        self._seen = False
        self._hover = QTimer(self, singleShot=True, interval=HOVER_MILLISECONDS)
        self._hover.timeout.connect(lambda: self._tell(self.pointed))
        self._at = QPointF()
        self._pressed: QPointF | None = None
        self.interactor.installEventFilter(self)
        self.interactor.setMouseTracking(True)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(0)
        row.addWidget(self.interactor, 1)
        side = QVBoxLayout()
        side.addWidget(panel)
        side.addStretch(1)
        row.addLayout(side)
        panel.setFixedWidth(34 * UNIT)
        self.resize(120 * UNIT, 80 * UNIT)

    def show_scene(self, scene: Superimposed) -> None:
        """Show a scene; the first one from the front."""
        self.scene.show(scene)
        if not self._seen:
            self.scene.look("front")
            self._seen = True
        self.interactor.render()

    def look(self, view: str) -> None:
        """Look from a standard side."""
        self.scene.look(view)
        self.interactor.render()

    def mark(self, places: list[Place]) -> None:
        """Mark places, and the way from each to the next."""
        self.scene.mark(places)
        self.interactor.render()

    def nearest(self, surface: int, place: Place) -> Place:
        """Return the place of a scan that is nearest to one in the scene."""
        return self.scene.nearest(surface, place)

    def raise_up(self) -> None:
        """Show the window, in front of others."""
        self.show()
        self.raise_()
        self.activateWindow()
        self.interactor.setFocus()

    def is_seen(self) -> bool:
        """Whether the window is on the screen."""
        return self.isVisible()

    def picture(self) -> QImage:
        """Return what is seen."""
        seen: QImage = self.interactor.grabFramebuffer()
        return seen

    def close_for_good(self) -> None:
        """Give back what the graphics hold."""
        self._hover.stop()
        self.interactor.removeEventFilter(self)
        self.interactor.close()
        self.close()

    @override
    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Space:
            self.flickered.emit()
        elif event.key() == Qt.Key.Key_Escape:
            self.close()
        else:
            super().keyPressEvent(event)

    @override
    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            self.keyPressEvent(event)  # VTK's own keys would close windows and change styles
            return True
        if isinstance(event, QMouseEvent):
            self._follow(event)
        return super().eventFilter(watched, event)

    def _follow(self, event: QMouseEvent) -> None:
        kind, self._at = event.type(), event.position()
        if kind == QEvent.Type.MouseMove and not event.buttons():
            self._hover.start()
        elif kind == QEvent.Type.MouseMove and self._pressed is not None:
            self.scene.sketch(moving=True)
        elif kind == QEvent.Type.MouseButtonPress:
            self._pressed = event.position()
        elif kind == QEvent.Type.MouseButtonRelease and self._pressed is not None:
            way = event.position() - self._pressed
            self._pressed = None
            self.scene.sketch(moving=False)
            self.interactor.render()
            if way.manhattanLength() < CLICK_PIXELS:
                self._tell(self.clicked)

    def _tell(self, signal: SignalInstance) -> None:
        ratio = self.interactor.devicePixelRatioF()
        right = self._at.x() * ratio
        up = (self.interactor.height() - 1 - self._at.y()) * ratio
        signal.emit(self.scene.pick(right, up))
