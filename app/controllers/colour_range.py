"""Ties the colours' range and the tolerances to their panel."""

from dataclasses import replace

from PySide6.QtCore import QObject

from app.controllers.display import Display
from app.controllers.workbench import Workbench
from app.model.view_state import ScaleChoice
from app.panels.scale_panel import ScalePanel


class Scaling(QObject):
    """What the user chooses of the scale; tolerances are the document's, the rest the view's."""

    def __init__(self, workbench: Workbench, display: Display, panel: ScalePanel) -> None:
        super().__init__()
        self._workbench = workbench
        self._display = display
        self._panel = panel
        panel.brushed.connect(lambda brush: display.change(brush=brush))
        panel.changed.connect(self.choose)
        panel.fit_asked.connect(self.fit)
        display.changed.connect(self._show)
        self._show()

    def choose(self, scale: ScaleChoice) -> None:
        """Put another scale in force."""
        document = self._workbench.document.asking(tolerances=scale.tolerances)
        self._workbench.set_document(document, scale=scale)

    def fit(self) -> None:
        """Fit the range to the differences; it stays there afterwards."""
        display = self._display
        if display.content is not None:
            limit = display.content.distributions.fitting_end
            display.change(scale=replace(display.state.scale, limit=limit, pinned=True))

    def _show(self) -> None:
        self._panel.show_state(self._display.content, self._display.state, self._display.unit)
