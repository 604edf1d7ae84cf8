"""The four views side by side; any of them can fill the place."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import override

from PySide6.QtCore import Qt
from PySide6.QtGui import QIcon, QImage, QKeyEvent
from PySide6.QtWidgets import QGridLayout, QWidget

from app.drawing.studio import Pictures
from app.look.theme import UNIT, Theme, theme
from app.views.titled_view import ViewFrame


class ViewGrid(QWidget):
    """Two rows of two views."""

    def __init__(self, names: Sequence[str]) -> None:
        super().__init__()
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName(self.tr("Views"))
        self.pressed: Callable[[int, bool], bool] | None = None
        """Told each key and whether Shift is down; says whether the key means anything."""
        self.frames = [ViewFrame(k + 1, name) for k, name in enumerate(names)]
        self._layout = layout = QGridLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(UNIT)
        for k, frame in enumerate(self.frames):
            layout.addWidget(frame, k // 2, k % 2)
        self.fill(None)

    @override
    def keyPressEvent(self, event: QKeyEvent) -> None:
        shifted = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if self.pressed is None or not self.pressed(event.key(), shifted):
            super().keyPressEvent(event)

    def fill(self, view: int | None) -> None:
        """Let one view have all the place; None shows the four."""
        for k, frame in enumerate(self.frames):
            frame.setVisible(view is None or view == k)
        for line in range(2):
            self._layout.setRowStretch(line, int(view is None or view // 2 == line))
            self._layout.setColumnStretch(line, int(view is None or view % 2 == line))

    def dress(self, colours: Theme) -> None:
        """Take the colours of a theme."""
        for frame in self.frames:
            frame.dress(colours)

    def sizes(self) -> tuple[tuple[int, int, int], ...]:
        """View, width and height in device pixels, of each visible view."""
        return tuple(
            (k, *frame.canvas.pixels())
            for k, frame in enumerate(self.frames)
            if frame.isVisibleTo(self)
        )

    @contextmanager
    def holding(self, images: dict[int, QImage], colours: Theme) -> Iterator[None]:
        """Hold other pictures, and no buttons, for as long as the block runs."""
        icon = self.frames[0].title.button.icon()
        before = {view: self.frames[view].canvas.image for view in images}
        for view, image in images.items():
            self.frames[view].canvas.show_image(image, colours)
            self.frames[view].title.button.setIcon(QIcon())
        try:
            yield
        finally:
            for view, old in before.items():
                self.frames[view].canvas.show_image(old, colours)
                self.frames[view].title.button.setIcon(icon)

    def show_pictures(self, pictures: Pictures) -> None:
        """Put finished pictures on the canvases."""
        colours = theme(pictures.wish.state.dark)
        for view, image in pictures.images.items():
            self.frames[view].canvas.show_image(image, colours)
