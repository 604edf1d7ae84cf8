"""Ties what came of a comparison to the window's frame: title, pages, status, theme."""

from typing import Protocol

from PySide6.QtCore import QObject

from app.controllers.asking import Telling
from app.controllers.display import Display
from app.controllers.workbench import Workbench
from app.jobs.comparing import Compared
from app.look.numerals import thousands
from app.panels.measures_panel import MeasuresPanel
from app.panels.toolbar import Toolbar


class Frame(Protocol):
    """The window around views and panels."""

    def dress(self, dark: bool) -> None:
        """Put on the dark or the light theme."""

    def show_views(self, there: bool) -> None:
        """Show the views, or what to do where there is nothing to view."""

    def show_heading(self, title: str, summary: str) -> None:
        """Show what is compared, and in short what came of it."""


class Front(QObject):
    """Shows what is compared and the result in short, and the choices of the toolbar."""

    def __init__(
        self,
        workbench: Workbench,
        display: Display,
        frame: Frame,
        toolbar: Toolbar,
        measures: MeasuresPanel,
        telling: Telling,
    ) -> None:
        super().__init__()
        self._workbench = workbench
        self._display = display
        self._frame = frame
        self._toolbar = toolbar
        self._measures = measures
        self._telling = telling
        self._dark: bool | None = None
        toolbar.relief_chosen.connect(lambda on: display.change(relief=on))
        toolbar.heatmap_chosen.connect(lambda kind: display.change(heatmap=kind))
        workbench.changed.connect(lambda: frame.show_views(workbench.shown is not None))
        workbench.compared.connect(self._compared)
        display.changed.connect(self._show)
        self._show()

    def _compared(self, result: Compared) -> None:
        self._frame.show_views(True)
        comparison = result.content.comparison  # with the regions' weights
        self._measures.show_measures(comparison.measures, self._workbench.unit)
        names = " – ".join(path.name for path in result.document.paths if path)
        self._frame.show_heading(f"{names} – surfcmp", self._summary(result))
        if warnings := comparison.warnings:
            self._telling.tell("\n".join(warnings), "note")

    def _show(self) -> None:
        state = self._display.state
        self._toolbar.show_state(state)
        if state.dark != self._dark:
            self._dark = state.dark
            self._frame.dress(state.dark)

    def _summary(self, result: Compared) -> str:
        comparison, counts = result.content.comparison, result.content.counts
        measures = comparison.measures
        parts = [
            self.tr("{} + {} nodes").format(
                thousands(counts["nodes_1"]), thousands(counts["nodes_2"])
            ),
            self.tr("{} triangles, {} compared").format(
                thousands(counts["triangles_united"]), thousands(counts["triangles_compared"])
            ),
            self.tr("{} chains").format(thousands(counts["chains"])),
            self.tr("coverage {:.1f} % of 1, {:.1f} % of 2").format(
                100 * measures.coverage_1, 100 * measures.coverage_2
            ),
        ]
        dropped = sum(sum(surface.dropped.values()) for surface in comparison.surfaces)
        merged = sum(grid.merged for grid in comparison.grids)
        if dropped:
            parts.append(self.tr("{} nodes dropped").format(thousands(dropped)))
        if merged:
            parts.append(self.tr("{} nodes merged").format(thousands(merged)))
        parts.append(self._workbench.unit)
        return "   ·   ".join(parts)
