"""Ties the line of a section to the profiles along it."""

from PySide6.QtCore import QObject

from app.controllers.display import Display
from app.panels.section_panel import SectionPanel
from app.scene.profile import profile_of


class Section(QObject):
    """Shows the profiles of both surfaces along the line drawn."""

    def __init__(self, display: Display, panel: SectionPanel) -> None:
        super().__init__()
        self._display = display
        self._panel = panel
        panel.tool_asked.connect(display.use)
        display.tool_changed.connect(panel.show_tool)
        display.changed.connect(self._show)
        self._show()

    def _show(self) -> None:
        content, state = self._display.content, self._display.state
        profile = None
        if content is not None and state.section is not None:
            profile = content.once(profile_of, content.comparison, state.section, content.geometry)
        self._panel.show_profile(profile, self._display.unit, state.dark)
