"""Ties the table of chains to the views."""

from PySide6.QtCore import QObject

from app.controllers.display import Display
from app.controllers.workbench import Workbench
from app.jobs.comparing import Compared
from app.panels.chains_panel import ChainsPanel
from app.scene.chain_colours import chain_colours
from app.scene.chain_table import chain_box


class ChainChoice(QObject):
    """A chosen chain stands out, and is flown to."""

    def __init__(self, workbench: Workbench, display: Display, panel: ChainsPanel) -> None:
        super().__init__()
        self._workbench = workbench
        self._display = display
        self._panel = panel
        panel.chosen.connect(self.fly_to)
        panel.colours_asked.connect(lambda by: display.change(chains_by=by))
        workbench.compared.connect(self._show)
        display.changed.connect(self._colour)

    def fly_to(self, chain: int) -> None:
        """Let one chain stand out, and look at it."""
        content = self._display.content
        if content is not None:
            self._display.change(chain=chain)
            self._display.look_at(*chain_box(content.comparison, content.geometry, chain))

    def _colour(self) -> None:
        content, state = self._display.content, self._display.state
        if content is not None:
            by, end, dark = state.chains_by, state.colours.end, state.dark
            colours = content.once(chain_colours, content.chains, by, end, dark=dark)
            self._panel.show_colours(by, colours)

    def _show(self, result: Compared) -> None:
        self._panel.show_chains(result.content.chains, self._workbench.unit)
