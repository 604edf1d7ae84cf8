"""Keeps the places whose labels stay, and tells what is read off there."""

from PySide6.QtCore import QObject

from app.controllers.display import Display
from app.panels.probes_panel import ProbesPanel
from app.scene.pick import reading_at


class Places(QObject):
    """Ties the picked place and the kept ones to their panel."""

    def __init__(self, display: Display, panel: ProbesPanel) -> None:
        super().__init__()
        self._display = display
        self._panel = panel
        panel.keep_asked.connect(self.keep)
        panel.remove_asked.connect(self.remove)
        panel.clear_asked.connect(lambda: display.change(probes=()))
        display.changed.connect(self._show)

    def keep(self) -> None:
        """Let the label of the picked place stay."""
        state = self._display.state
        if state.picked is not None:
            self._display.change(probes=(*state.probes, state.picked), picked=None)

    def remove(self, number: int) -> None:
        """Take the label of a kept place away."""
        probes = self._display.state.probes
        self._display.change(probes=probes[:number] + probes[number + 1 :])

    def _show(self) -> None:
        content, state = self._display.content, self._display.state
        if content is not None:
            comparison = content.comparison
            kept = [reading_at(comparison, place) for place in state.probes]
            picked = reading_at(comparison, state.picked) if state.picked else None
            self._panel.show_readings(kept, picked, self._display.unit)
