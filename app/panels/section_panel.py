"""The profiles of both surfaces along a line, and their difference."""

from __future__ import annotations

from typing import TYPE_CHECKING, override

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Signal
from PySide6.QtGui import QColor, QGuiApplication, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QHBoxLayout, QVBoxLayout

from app.look.theme import UNIT, theme
from app.model.tool import Tool
from app.panels.plot import Plot
from app.panels.widgets import Panel, quiet_label, tool_button
from app.scene.quiet_colours import palette
from app.scene.ticks import padded

if TYPE_CHECKING:
    from app.scene.profile import Profile

HEIGHTS = (150, 110)


class Curves(Plot):
    """Curves over one axis; gaps where there is no data."""

    def __init__(self, height: int) -> None:
        super().__init__(height)
        self._along: NDArray[np.float64] = np.zeros(0)
        self._curves: list[tuple[NDArray[np.float64], QColor]] = []

    def show_curves(
        self, along: NDArray[np.float64], curves: list[tuple[NDArray[np.float64], QColor]]
    ) -> None:
        """Show values over the distance from the start."""
        self._along, self._curves = along, curves
        self.update()

    @override
    def draw(self, painter: QPainter) -> None:
        for values, colour in self._curves:
            painter.setPen(QPen(colour, 1.8))
            known = np.isfinite(values)
            for part in np.split(np.arange(len(values)), np.flatnonzero(~known)):
                part = part[known[part]]
                if len(part) > 1:
                    points = zip(self._along[part].tolist(), values[part].tolist(), strict=True)
                    painter.drawPolyline(QPolygonF([QPointF(self.to_screen(*p)) for p in points]))


class SectionPanel(Panel):
    """Two plots under each other, on one axis."""

    tool_asked = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.line = tool_button(self.tr("Draw a line"), self.tr("Draw a line over any view (S)"))
        self.line.setCheckable(True)
        self.line.clicked.connect(
            lambda on: self.tool_asked.emit(Tool.SECTION if on else Tool.LOOK)
        )
        self.copy = tool_button(self.tr("Copy"), self.tr("Copy the profile as a table"), plain=True)
        self.copy.clicked.connect(lambda: QGuiApplication.clipboard().setText(self.table()))
        self.text = quiet_label()
        self.heights, self.difference = (Curves(height) for height in HEIGHTS)
        self.heights.setAccessibleName(self.tr("Heights of both surfaces along the line"))
        self.difference.setAccessibleName(self.tr("Difference along the line"))
        row = QHBoxLayout()
        row.setSpacing(UNIT)
        row.addWidget(self.line)
        row.addStretch(1)
        row.addWidget(self.copy)
        self.text.setWordWrap(True)
        column = QVBoxLayout(self)
        column.setContentsMargins(UNIT, UNIT, UNIT, UNIT)
        column.setSpacing(UNIT)
        column.addLayout(row)
        column.addWidget(self.text)
        column.addWidget(self.heights)
        column.addWidget(self.difference)
        column.addStretch(1)
        self._profile: Profile | None = None
        self._unit = ""
        self.show_profile(None, "", False)

    def show_tool(self, tool: Tool) -> None:
        """Show which tool is in hand."""
        self.line.setChecked(tool is Tool.SECTION)

    def show_profile(self, profile: Profile | None, unit: str, dark: bool) -> None:
        """Show a profile; None where no line is drawn."""
        self._profile, self._unit = profile, unit
        some = profile is not None and len(profile.along) > 1
        for widget in (self.heights, self.difference):
            widget.setVisible(some)
        self.copy.setEnabled(some)
        if profile is None or not some:
            text = self.tr("Draw a line across the surfaces.")
            self.text.setText(text if profile is None else self.tr("No surface under the line."))
            return
        colours, quiet = theme(dark), palette(dark)
        span = (0.0, float(profile.along[-1]))
        both = np.concatenate([profile.z1, profile.z2])
        axis = self.tr("along the line, {}").format(unit)
        self.heights.set_axes(span, padded(both), (axis, f"z, {unit}"), colours)
        strong = [
            QColor(*colour).darker(100 if dark else 150)
            for colour in (quiet.surface_1, quiet.surface_2)
        ]
        self.heights.show_curves(profile.along, [(profile.z1, strong[0]), (profile.z2, strong[1])])
        names = (self.tr("surface 1"), self.tr("surface 2"))
        self.heights.set_key(list(zip(names, strong, strict=True)))
        d = profile.difference
        self.difference.set_axes(span, padded(np.append(d, 0.0)), (axis, f"d, {unit}"), colours)
        self.difference.show_curves(profile.along, [(d, QColor(colours.accent))])
        plots = (self.heights, self.difference)
        for plot in plots:
            plot.margin = 0.0
        wide = max(plot.area.left() for plot in plots)
        for plot in plots:
            plot.margin = wide
        largest = float(np.nanmax(np.abs(d))) if np.isfinite(d).any() else float("nan")
        self.text.setText(
            self.tr("{:.4g} {} long, largest |d| {:.3g} {}").format(span[1], unit, largest, unit)
        )

    def table(self) -> str:
        """Return the profile as tab-separated columns: distance, z1, z2, d."""
        if self._profile is None:
            return ""
        profile = self._profile
        columns = np.column_stack([profile.along, profile.z1, profile.z2, profile.difference])
        head = "\t".join(f"{name} ({self._unit})" for name in ("distance", "z1", "z2", "d"))
        return "\n".join([head, *("\t".join(map(repr, row)) for row in columns.tolist())]) + "\n"
