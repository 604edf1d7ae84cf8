"""Draws regions, weighs them, keeps them."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QGuiApplication

from app.controllers.asking import Asking, Telling
from app.controllers.display import Display
from app.controllers.workbench import Workbench
from app.jobs.comparing import Compared
from app.model.document import Document
from app.model.region import Region, Stroke
from app.model.session_text import regions_from, regions_text, write
from app.model.tool import Tool
from app.panels.regions_panel import COLOURS, RegionsPanel
from surfcmp_core.errors import InputError
from surfcmp_core.system.whole_files import OutputError

FINEST = 0.1
"""A brush's path is kept to this share of its radius."""
TAKING_KEYS = Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.AltModifier


class Regions(QObject):
    """Each stroke, name, colour and weight is a step of the history."""

    def __init__(
        self,
        workbench: Workbench,
        display: Display,
        panel: RegionsPanel,
        telling: Telling,
        asking: Asking,
    ) -> None:
        super().__init__()
        self._workbench = workbench
        self._display = display
        self._panel = panel
        self._telling = telling
        self._asking = asking
        panel.tool_asked.connect(display.use)
        panel.renamed.connect(lambda k, name: self._change(k, name=name or self._name()))
        panel.weighed.connect(self._weigh)
        panel.coloured.connect(self.colour)
        panel.remove_asked.connect(self.remove)
        panel.save_asked.connect(self._ask_save)
        panel.load_asked.connect(self._ask_load)
        panel.radius.changed.connect(display.set_brush)
        display.tool_changed.connect(panel.show_tool)
        display.path_drawn.connect(self.draw)
        workbench.compared.connect(self._compared)
        self._sized = False

    @property
    def document(self) -> Document:
        """The document in force."""
        return self._workbench.document

    @property
    def selected(self) -> int:
        """The number of the selected region; -1 for none."""
        selected = self._panel.selected
        return selected if selected < len(self.document.regions) else -1

    def draw(self, tool: Tool, path: tuple[tuple[float, float], ...]) -> None:
        """Take in a path: of the lasso, of the brush, or of a section.

        A brush adds to the selected region; each lasso is a region of its own. With the key
        Shift or Alt held, or "Take away" on, both take away from the selected region.
        """
        takes = self._panel.take.isChecked()
        takes |= bool(QGuiApplication.keyboardModifiers() & TAKING_KEYS)
        if tool is Tool.LASSO and len(path) > 2:
            self._add(Stroke(path, takes=takes), fresh=not takes)
        elif tool is Tool.BRUSH and path:
            radius = self._panel.radius.value
            self._add(Stroke(thinned(path, FINEST * radius), radius, takes), fresh=False)
        elif tool is Tool.SECTION and len(path) > 1:
            self._display.change(section=(*path[0], *path[-1]))

    def remove(self, number: int) -> None:
        """Remove a region."""
        regions = self.document.regions
        if 0 <= number < len(regions):
            self._set(regions[:number] + regions[number + 1 :])

    def colour(self, number: int, colour: tuple[int, int, int] | None) -> None:
        """Give a region a colour; None asks for it."""
        if colour is None:
            old = self.document.regions[number].colour
            colour = self._asking.colour(self.tr("Colour of the region"), old)
            if colour is None:
                return
        self._change(number, colour=colour)

    def save(self, path: Path) -> None:
        """Save the regions, completely or not at all."""
        try:
            write(path, regions_text(self.document.regions))
        except OutputError as error:
            self._telling.tell(str(error))

    def load(self, path: Path) -> None:
        """Add the regions of a file."""
        try:
            found = regions_from(path.read_text(encoding="utf-8"), path.name)
        except (OSError, UnicodeDecodeError) as error:
            self._telling.tell(self.tr("{}: cannot be read ({})").format(path.name, error))
        except InputError as error:
            self._telling.tell(str(error))
        else:
            self._set(self.document.regions + found)

    def _add(self, stroke: Stroke, fresh: bool) -> None:
        """Add a stroke to the selected region, or begin a `fresh` one with it."""
        regions, selected = list(self.document.regions), self.selected
        if stroke.takes and selected < 0:
            self._telling.tell(self.tr("Select the region to take away from"), "note")
            return
        if fresh or selected < 0:
            colour = COLOURS[len(regions) % len(COLOURS)]
            regions.append(Region(self._name(), colour, strokes=(stroke,)))
        else:
            old = regions[selected]
            regions[selected] = replace(old, strokes=(*old.strokes, stroke))
        self._set(tuple(regions))

    def _name(self) -> str:
        names = {region.name for region in self.document.regions}
        k = 1
        while self.tr("Region {}").format(k) in names:
            k += 1
        return self.tr("Region {}").format(k)

    def _weigh(self, number: int, weight: float) -> None:
        if weight >= 0:
            self._change(number, weight=weight)
        elif self._workbench.shown is not None:
            self._compared(self._workbench.shown)

    def _change(self, number: int, **changes: object) -> None:
        regions = list(self.document.regions)
        regions[number] = replace(regions[number], **changes)  # type: ignore[arg-type]
        self._set(tuple(regions))

    def _set(self, regions: tuple[Region, ...]) -> None:
        self._workbench.set_document(replace(self.document, regions=regions))

    def _compared(self, result: Compared) -> None:
        panel, unit = self._panel, self._workbench.unit
        panel.show_regions(result.regions, result.comparison.measures, unit)
        if not self._sized:
            size = result.content.geometry.high - result.content.geometry.low
            radius = float(f"{0.05 * max(size[:2]):.1g}")
            panel.radius.show_value(radius)
            self._display.set_brush(radius)
            self._sized = True

    def _ask_save(self) -> None:
        path, _ = self._asking.place(self.tr("Save the regions"), "regions.json", "*.json")
        if path is not None:
            self.save(path)

    def _ask_load(self) -> None:
        path = self._asking.file(self.tr("Load regions"), kinds="*.json")
        if path is not None:
            self.load(path)


def thinned(path: tuple[tuple[float, float], ...], step: float) -> tuple[tuple[float, float], ...]:
    """Return the path without places that lie nearer than `step` to the one before."""
    kept = [path[0]]
    for place in path[1:]:
        if (place[0] - kept[-1][0]) ** 2 + (place[1] - kept[-1][1]) ** 2 >= step * step:
            kept.append(place)
    return (*kept, path[-1]) if path[-1] != kept[-1] else tuple(kept)
