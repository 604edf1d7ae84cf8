"""What is written over and around the views: titles, legends, the colours' scale, lengths."""

from collections.abc import Sequence

from PySide6.QtCore import QObject

from app.controllers.display import Display
from app.look.numerals import thousands
from app.model.view_state import Heatmap, ViewState
from app.panels.toolbar import heatmap_name
from app.scene.furniture import colour_bar, legend
from app.views.titled_view import ViewFrame


class Captions(QObject):
    """Keeps the words of the four views in step with what they show."""

    def __init__(self, display: Display, frames: Sequence[ViewFrame]) -> None:
        super().__init__()
        self._display = display
        self._frames = frames
        display.changed.connect(self._show)
        display.shown.connect(lambda _: self._measure())

    def explain(self, state: ViewState) -> None:
        """Show the scale and the legends of a state over the views."""
        content, unit = self._display.content, self._display.unit
        if content is None:
            return
        bar = colour_bar(content.comparison, state)
        for view, frame in enumerate(self._frames):
            swatches = legend(content, state, view)
            frame.explain(bar if view == 3 else None, unit, self.tr("no data"), swatches)

    def _show(self) -> None:
        content, state = self._display.content, self._display.state
        if content is None:
            return
        names = [surface.name for surface in content.comparison.surfaces]
        triangles = thousands(content.counts["triangles_united"])
        texts = [
            (self.tr("Surface 1"), names[0]),
            (self.tr("Surface 2"), names[1]),
            (self.tr("United triangulation"), self.tr("{} triangles").format(triangles)),
            (heatmap_name(state.heatmap), self._sense(state.heatmap)),
        ]
        for frame, (name, fact) in zip(self._frames, texts, strict=True):
            frame.title.set_texts(name, fact)
        self.explain(state)
        self._measure()

    def _sense(self, heatmap: Heatmap) -> str:
        if heatmap is Heatmap.SIGNED:
            return self.tr("1 above 2 is positive")
        if heatmap is Heatmap.REPRESENTATIVE:
            return self.tr("where both grids have nodes")
        return ""

    def _measure(self) -> None:
        height = self._display.seen.height
        for frame in self._frames:
            frame.measure(height / max(frame.canvas.height(), 1), self._display.unit)
