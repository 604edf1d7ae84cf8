"""Carries what changed to the widgets that show it."""

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from app import settings
from app.jobs.comparing import Compared
from app.model.view_state import Heatmap, Scale, ViewState
from app.numbers import thousands
from app.panels.toolbar import heatmap_name
from app.scene.chain_table import chain_box
from app.scene.content import Content
from app.scene.distribution import fitting_limit
from app.scene.furniture import colour_bar, legend
from app.scene.pick import reading_at
from app.scene.section import profile_of
from surfcmp_core.comparison import Comparison
from surfcmp_core.report.document import unit_of

if TYPE_CHECKING:
    from app.window import MainWindow


class Showing(QObject):
    """Ties the session and the display to the window's parts."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        session, display, toolbar = window.session, window.display, window.toolbar
        session.changed.connect(self._session_changed)
        session.compared.connect(self._compared)
        session.failed.connect(window.banner.tell)
        session.runner.progressed.connect(window.progress.tell)
        window.progress.cancel_asked.connect(session.runner.cancel)
        display.changed.connect(self._state_changed)
        display.shown.connect(lambda _: self._measure_views())
        toolbar.surface_asked.connect(lambda n: window.opening.open_one(n))
        toolbar.swap_asked.connect(lambda: window.opening.swap_surfaces())
        toolbar.relief_chosen.connect(lambda on: display.change(relief=on))
        toolbar.heatmap_chosen.connect(lambda kind: display.change(heatmap=kind))
        window.scale.brushed.connect(lambda brush: display.change(brush=brush))
        window.chains.chosen.connect(self._fly)
        window.probes.keep_asked.connect(self.keep_probe)
        window.probes.remove_asked.connect(self._remove_probe)
        window.probes.clear_asked.connect(lambda: display.change(probes=()))
        window.scale.changed.connect(self._scale_chosen)
        window.scale.fit_asked.connect(self._fit)
        window.section.tool_asked.connect(display.use)
        display.tool_changed.connect(window.section.show_tool)
        window.options.changed.connect(session.set_document)
        window.empty.open_asked.connect(self._open_missing)
        window.empty.sample_asked.connect(lambda: window.opening.open_sample())
        self._dark: bool | None = None
        self._fitted: tuple[Path | None, Path | None] = (None, None)
        self._session_changed()
        self._state_changed()

    @property
    def unit(self) -> str:
        """The length unit of the numbers."""
        shown = self._window.session.shown
        if shown is None:
            return ""
        return unit_of(shown.comparison)

    def _session_changed(self) -> None:
        window, session = self._window, self._window.session
        busy = session.runner.busy
        window.toolbar.show_paths(session.document.paths)
        window.actions_of.show_steps(session.history.undoable, session.history.redoable)
        window.actions_of.swap.setEnabled(session.document.complete)
        window.empty.tell(session.document.paths, busy)
        window.options.show_document(session.document)
        window.pages.setCurrentWidget(window.grid if session.shown else window.empty)
        if not busy:
            window.progress.hide()
        elif not window.progress.isVisible():
            window.progress.begin()
            window.banner.hide()

    def _compared(self, result: Compared) -> None:
        window, content = self._window, result.content
        comparison = content.comparison
        scale = replace(window.display.state.scale, tolerances=result.document.options.tolerances)
        if not scale.pinned and result.document.paths != self._fitted:
            scale = replace(scale, limit=fitting_limit(content.distributions.absolute))
        self._fitted = one, two = result.document.paths
        if one and two:
            settings.remember_pair((one, two))
        window.display.change(scale=scale)
        if window.pages.currentWidget() is not window.grid:
            window.pages.setCurrentWidget(window.grid)
            window.grid.setFocus()
        window.measures.show_measures(comparison.measures, self.unit)
        window.chains.show_chains(content.chains, self.unit)
        window.status.setText(self._summary(content))
        window.display.unit = self.unit
        window.display.set_content(content)
        names = " – ".join(path.name for path in result.document.paths if path)
        window.setWindowTitle(f"{names} – surfcmp")
        if comparison.warnings:
            window.banner.tell("\n".join(comparison.warnings), "note")

    def _summary(self, content: Content) -> str:
        comparison, counts = content.comparison, content.counts
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
        parts.append(self.unit)
        return "   ·   ".join(parts)

    def _state_changed(self) -> None:
        window, state = self._window, self._window.display.state
        if state.dark != self._dark:
            self._dark = state.dark
            window.dress(state.dark)
        window.toolbar.show_state(state)
        content = window.display.content
        window.scale.show_state(content, state, self.unit)
        profile = None
        if content is not None and state.section is not None:
            profile = profile_of(content.comparison, state.section, content.geometry)
        window.section.show_profile(profile, self.unit, state.dark)
        if window.display.content is None:
            return
        comparison, counts = window.display.content.comparison, window.display.content.counts
        names = [surface.name for surface in comparison.surfaces]
        heatmap = heatmap_name(state.heatmap)
        texts = [
            (self.tr("Surface 1"), names[0]),
            (self.tr("Surface 2"), names[1]),
            (
                self.tr("United triangulation"),
                self.tr("{} triangles").format(thousands(counts["triangles_united"])),
            ),
            (heatmap, self._sense(state.heatmap)),
        ]
        for frame, (name, fact) in zip(window.grid.frames, texts, strict=True):
            frame.title.set_texts(name, fact)
        self.explain(state)
        self._measure_views()
        self._show_probes(comparison, state)

    def explain(self, state: ViewState) -> None:
        """Show the scale and the legends of a state over the views."""
        content = self._window.display.content
        if content is None:
            return
        bar = colour_bar(content.comparison, state)
        for view, frame in enumerate(self._window.grid.frames):
            swatches = legend(content.counts, state, view)
            frame.explain(bar if view == 3 else None, self.unit, self.tr("no data"), swatches)

    def _show_probes(self, comparison: Comparison, state: ViewState) -> None:
        kept = [reading_at(comparison, place) for place in state.probes]
        picked = reading_at(comparison, state.picked) if state.picked else None
        self._window.probes.show_readings(kept, picked, self.unit)

    def keep_probe(self) -> None:
        """Let the label of the picked place stay."""
        display = self._window.display
        if display.state.picked is not None:
            probes = (*display.state.probes, display.state.picked)
            display.change(probes=probes, picked=None)

    def _remove_probe(self, number: int) -> None:
        display = self._window.display
        probes = display.state.probes
        display.change(probes=probes[:number] + probes[number + 1 :])

    def _fly(self, chain: int) -> None:
        display = self._window.display
        content = display.content
        if content is not None:
            display.change(chain=chain)
            display.look_at(*chain_box(content.comparison, content.geometry, chain))

    def _sense(self, heatmap: Heatmap) -> str:
        if heatmap is Heatmap.SIGNED:
            return self.tr("1 above 2 is positive")
        if heatmap is Heatmap.REPRESENTATIVE:
            return self.tr("where both grids have nodes")
        return ""

    def _measure_views(self) -> None:
        height = self._window.display.seen.height
        for frame in self._window.grid.frames:
            frame.measure(height / max(frame.canvas.height(), 1), self.unit)

    def _scale_chosen(self, scale: Scale) -> None:
        session = self._window.session
        options = replace(session.document.options, tolerances=scale.tolerances)
        session.set_document(replace(session.document, options=options), scale=scale)

    def _fit(self) -> None:
        display = self._window.display
        if display.content is not None:
            limit = fitting_limit(display.content.distributions.absolute)
            display.change(scale=replace(display.state.scale, limit=limit, pinned=True))

    def _open_missing(self) -> None:
        paths = self._window.session.document.paths
        if any(paths) and not all(paths):
            self._window.opening.open_one(1 if paths[0] is None else 2)
        else:
            self._window.opening.open_both()
