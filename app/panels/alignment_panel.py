"""Moving surface 2 onto surface 1: landmarks, best fit, nudges; and what it changed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QGridLayout,
    QHBoxLayout,
    QPushButton,
    QVBoxLayout,
)

from app.look.numerals import four
from app.look.texts import QT_TRANSLATE_NOOP
from app.look.theme import UNIT
from app.model.tool import Tool
from app.panels.widgets import NumberBox, NumberTree, Panel, quiet_label, tool_button
from surfcmp_core.comparing.options import NOT_MOVED, Motion

if TYPE_CHECKING:
    from app.model.landmark import Landmark
    from surfcmp_core.measures.measures import Measures


METHODS = (
    QT_TRANSLATE_NOOP("AlignmentPanel", "landmarks"),
    QT_TRANSLATE_NOOP("AlignmentPanel", "by hand"),
    QT_TRANSLATE_NOOP("AlignmentPanel", "then by hand"),
    QT_TRANSLATE_NOOP("AlignmentPanel", "best fit (ICP)"),
    QT_TRANSLATE_NOOP("AlignmentPanel", "best fit (ICP) on the overlap"),
    QT_TRANSLATE_NOOP("AlignmentPanel", "best fit (ICP) on a region"),
)
"""How motions are told of in results; several stand with a comma between them."""


class AlignmentPanel(Panel):
    """Pairs of landmarks, buttons, and the residuals before and after."""

    tool_asked = Signal(object)
    fit_asked = Signal(bool)
    """Best fit; whether on the selected region only."""
    landmarks_asked = Signal()
    clear_asked = Signal()
    reset_asked = Signal()
    nudged = Signal(str, float)
    """Axis ("x", "y", "z": shift; "rx", "ry", "rz": turn) and step: length or degrees."""

    def __init__(self) -> None:
        super().__init__()
        self.on_region = QCheckBox(self.tr("on the selected region"))
        self.fit = QPushButton(self.tr("Best fit"))
        self.fit.setToolTip(self.tr("Move surface 2 by iterated closest points (ICP)"))
        self.fit.clicked.connect(lambda: self.fit_asked.emit(self.on_region.isChecked()))
        self.reset = tool_button(
            self.tr("As in the files"), self.tr("Take every motion back"), plain=True
        )
        self.reset.clicked.connect(self.reset_asked)
        self.pick = QPushButton(self.tr("Pick landmarks"))
        self.pick.setToolTip(self.tr("Click the same places on surface 1 and on 2"))
        self.pick.setCheckable(True)
        self.pick.clicked.connect(
            lambda on: self.tool_asked.emit(Tool.LANDMARK if on else Tool.LOOK)
        )
        self.use = QPushButton(self.tr("Fit landmarks"))
        self.use.clicked.connect(self.landmarks_asked)
        self.clear = tool_button(self.tr("Clear"), self.tr("Forget the landmarks"), plain=True)
        self.clear.clicked.connect(self.clear_asked)
        self.pairs = quiet_label()
        self.pairs.setWordWrap(True)
        self.step = NumberBox()
        self.step.setMaximumWidth(8 * UNIT)
        self.step.setToolTip(self.tr("Step of a nudge: length, or degrees"))
        self.step.setAccessibleName(self.tr("Step of a nudge"))
        self.table = NumberTree(
            self.tr("What the motion changed"),
            [self.tr("Measure"), self.tr("Before"), self.tr("Now")],
        )
        self.method = quiet_label()
        self.method.setWordWrap(True)
        self._lay_out()

    def _lay_out(self) -> None:
        first = QHBoxLayout()
        first.setSpacing(UNIT)
        first.addWidget(self.fit)
        first.addWidget(self.on_region)
        first.addStretch(1)
        first.addWidget(self.reset)
        second = QHBoxLayout()
        second.setSpacing(UNIT)
        second.addWidget(self.pick)
        second.addWidget(self.use)
        second.addStretch(1)
        second.addWidget(self.clear)
        column = QVBoxLayout(self)
        column.setContentsMargins(UNIT, UNIT, UNIT, UNIT)
        column.setSpacing(UNIT)
        column.addLayout(first)
        column.addLayout(second)
        column.addWidget(self.pairs)
        column.addLayout(self._nudges())
        column.addWidget(self.method)
        column.addWidget(self.table, 1)

    def _nudges(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setSpacing(0)
        grid.addWidget(quiet_label(self.tr("Nudge by")), 0, 0)
        grid.addWidget(self.step, 1, 0)
        names = {
            "x": self.tr("Shift along x"),
            "y": self.tr("Shift along y"),
            "z": self.tr("Shift along z"),
            "rx": self.tr("Turn around x, in degrees"),
            "ry": self.tr("Turn around y, in degrees"),
            "rz": self.tr("Turn around z, in degrees"),
        }
        for k, (axis, name) in enumerate(names.items()):
            for row, sign in enumerate((1, -1)):
                text = f"{'+' if sign > 0 else '−'}{axis.replace('r', '↻')}"
                button = tool_button(text, name, plain=True)
                button.setProperty("kind", "small")
                button.clicked.connect(
                    lambda _=False, a=axis, s=sign: self.nudged.emit(a, s * self.step.value)
                )
                grid.addWidget(button, row, k + 1)
        grid.setColumnStretch(len(names) + 1, 1)
        return grid

    def show_tool(self, tool: Tool) -> None:
        """Show which tool is in hand."""
        self.pick.setChecked(tool is Tool.LANDMARK)

    def show_pairs(self, pairs: tuple[Landmark, ...]) -> None:
        """Show how many landmarks there are, and what is missing."""
        whole = sum(pair.complete for pair in pairs)
        self.use.setEnabled(whole >= 3)
        self.clear.setEnabled(bool(pairs))
        if not pairs:
            text = self.tr("At least three pairs, not in one line.")
        elif not pairs[-1].complete:
            missing = 1 if pairs[-1].one is None else 2
            text = self.tr("Now click the same place on surface {}.").format(missing)
        else:
            text = self.tr("{} pairs of landmarks.").format(whole)
        self.pairs.setText(text)

    def show_motion(
        self, motion: Motion, before: Measures | None, now: Measures | None, unit: str
    ) -> None:
        """Show how surface 2 was moved, and what that changed."""
        self.reset.setEnabled(motion != NOT_MOVED)
        if motion == NOT_MOVED:
            self.method.setText(self.tr("Surface 2 lies as in its file."))
        else:
            ways = [self.tr(way) for way in motion.method.split(", ")]
            text = self.tr("Moved: {}").format(", ".join(ways))
            if motion.residual is not None:
                text += self.tr("; residual {:.3g} {}, {} pairs").format(
                    motion.residual, unit, motion.pairs
                )
            self.method.setText("\n".join([text, *_said(motion, unit)]))
        self.table.clear()
        if now is None:
            return
        for key, name in (
            ("mean_abs", self.tr("Mean |d|")),
            ("rms", self.tr("RMS")),
            ("p95", self.tr("95th percentile")),
            ("mean_signed", self.tr("Signed mean")),
        ):
            values = [
                "–" if m is None else f"{four(getattr(m, key))} {unit}" for m in (before, now)
            ]
            self.table.add_row([name, *values])


def _said(motion: Motion, unit: str) -> list[str]:
    """Return what a fit says of itself, as in the reports, and its doubts."""
    from surfcmp_core.report.provenance import fit_rows

    if not motion.fit:
        return []
    rows = fit_rows({"method": motion.method} | motion.fit, unit)
    return [*(f"{name}: {text}" for name, text in rows[2:]), *motion.fit["doubts"]]
