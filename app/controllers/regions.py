"""Draws regions, weighs them, keeps them."""

import json
from dataclasses import asdict, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject
from PySide6.QtWidgets import QFileDialog

from app.jobs.comparing import Compared
from app.model.document import Document
from app.model.region import Disc, Polygon, Region
from app.model.session_file import regions_from, write
from app.model.tool import Tool
from surfcmp_core.errors import InputError

if TYPE_CHECKING:
    from app.window import MainWindow

COLOURS = (
    (214, 39, 40),
    (31, 119, 180),
    (44, 160, 44),
    (148, 103, 189),
    (255, 127, 14),
    (23, 190, 207),
)


class Regions(QObject):
    """Each stroke, name and weight is a step of the history."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        panel = window.regions
        panel.tool_asked.connect(window.display.use)
        panel.renamed.connect(lambda k, name: self._change(k, name=name or self._name()))
        panel.weighed.connect(self._weigh)
        panel.remove_asked.connect(self.remove)
        panel.save_asked.connect(self._ask_save)
        panel.load_asked.connect(self._ask_load)
        panel.radius.changed.connect(window.display.set_brush)
        window.display.tool_changed.connect(panel.show_tool)
        window.display.path_drawn.connect(self.draw)
        window.session.compared.connect(self._compared)
        self._sized = False

    @property
    def document(self) -> Document:
        """The document in force."""
        return self._window.session.document

    def draw(self, tool: Tool, path: tuple[tuple[float, float], ...]) -> None:
        """Add a lasso's or a brush's path to the selected region, or to a new one."""
        if tool is Tool.LASSO and len(path) > 2:
            self._add(polygons=(path,), discs=())
        elif tool is Tool.BRUSH and path:
            radius = self._window.regions.radius.value
            self._add(polygons=(), discs=dabs(path, radius))
        elif tool is Tool.SECTION and len(path) > 1:
            self._window.display.change(section=(*path[0], *path[-1]))

    def remove(self, number: int) -> None:
        """Remove a region."""
        regions = self.document.regions
        if 0 <= number < len(regions):
            self._set(regions[:number] + regions[number + 1 :])

    def save(self, path: Path) -> None:
        """Save the regions, completely or not at all."""
        try:
            write(path, json.dumps([asdict(region) for region in self.document.regions], indent=1))
        except OSError as error:
            self._window.banner.tell(f"{path.name}: {error.strerror}")

    def load(self, path: Path) -> None:
        """Add the regions of a file."""
        try:
            found = regions_from(path.read_text(encoding="utf-8"), path.name)
        except (OSError, UnicodeDecodeError) as error:
            self._window.banner.tell(self.tr("{}: cannot be read ({})").format(path.name, error))
        except InputError as error:
            self._window.banner.tell(str(error))
        else:
            self._set(self.document.regions + found)

    def _add(self, polygons: tuple[Polygon, ...], discs: tuple[Disc, ...]) -> None:
        regions, selected = list(self.document.regions), self._window.regions.selected
        if not 0 <= selected < len(regions) or polygons:  # each lasso is a region of its own
            colour = COLOURS[len(regions) % len(COLOURS)]
            regions.append(Region(self._name(), colour, polygons=polygons, discs=discs))
        else:
            old = regions[selected]
            regions[selected] = replace(old, discs=old.discs + discs)
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
        elif self._window.session.shown is not None:
            self._compared(self._window.session.shown)

    def _change(self, number: int, **changes: object) -> None:
        regions = list(self.document.regions)
        regions[number] = replace(regions[number], **changes)  # type: ignore[arg-type]
        self._set(tuple(regions))

    def _set(self, regions: tuple[Region, ...]) -> None:
        self._window.session.set_document(replace(self.document, regions=regions))

    def _compared(self, result: Compared) -> None:
        panel, unit = self._window.regions, self._window.showing.unit
        panel.show_regions(result.regions, result.comparison.measures, unit)
        if not self._sized:
            size = result.content.geometry.high - result.content.geometry.low
            radius = float(f"{0.05 * max(size[:2]):.1g}")
            panel.radius.show_value(radius)
            self._window.display.set_brush(radius)
            self._sized = True

    def _ask_save(self) -> None:
        name = QFileDialog.getSaveFileName(
            self._window, self.tr("Save the regions"), "regions.json", "*.json"
        )[0]
        if name:
            self.save(Path(name))

    def _ask_load(self) -> None:
        name = QFileDialog.getOpenFileName(self._window, self.tr("Load regions"), "", "*.json")[0]
        if name:
            self.load(Path(name))


def dabs(path: tuple[tuple[float, float], ...], radius: float) -> tuple[Disc, ...]:
    """Return discs along a stroke, half a radius apart."""
    points = np.array(path, dtype=np.float64)
    steps = np.hypot(*np.diff(points, axis=0).T) if len(points) > 1 else np.zeros(0)
    along = np.concatenate([[0.0], np.cumsum(steps)])
    count = max(int(along[-1] / (radius / 2)) + 1, 1)
    places = np.linspace(0.0, along[-1], count)
    x, y = (np.interp(places, along, points[:, axis]) for axis in range(2))
    return tuple((float(a), float(b), radius) for a, b in zip(x, y, strict=True))
