"""Moves surface 2 onto surface 1 and keeps account of how."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject

from app.controllers.asking import Telling
from app.controllers.display import Display
from app.controllers.marking import Regions
from app.controllers.workbench import Workbench
from app.jobs.comparing import Compared
from app.jobs.region_measures import region_mask
from app.jobs.runner import Runner
from app.model.landmark import Landmark, Point
from app.model.tool import Tool
from app.panels.alignment_panel import AlignmentPanel
from surfcmp_core.alignment import best_fit, fit_landmarks
from surfcmp_core.alignment.fit import FIT_KEYS
from surfcmp_core.comparing.options import NOT_MOVED, Matrix, Motion
from surfcmp_core.compiled.linear_algebra import applied, composed, dots, inverse, rotation
from surfcmp_core.errors import InputError
from surfcmp_core.measures.measures import Measures
from surfcmp_core.surface.together import carried
from surfcmp_core.system.progress import Progress

if TYPE_CHECKING:
    from surfcmp_core.alignment import Alignment as Found

_DIGITS = 14
"""Of the tangent by which surface 2 is turned: fewer than libraries differ in."""


class Aligning(QObject):
    """Landmarks, best fit and nudges; each is a step of the history."""

    def __init__(
        self,
        workbench: Workbench,
        display: Display,
        panel: AlignmentPanel,
        regions: Regions,
        telling: Telling,
    ) -> None:
        super().__init__()
        self._workbench = workbench
        self._display = display
        self._panel = panel
        self._regions = regions
        self._telling = telling
        self.runner = Runner()
        self.runner.finished.connect(self._move)
        self.runner.failed.connect(telling.tell)
        self._before: Measures | None = None
        panel.tool_asked.connect(display.use)
        panel.fit_asked.connect(self.best_fit)
        panel.landmarks_asked.connect(self.fit_landmarks)
        panel.clear_asked.connect(self.clear)
        panel.reset_asked.connect(lambda: self._move(NOT_MOVED))
        panel.nudged.connect(self.nudge)
        display.tool_changed.connect(panel.show_tool)
        display.landmark_picked.connect(self.add_landmark)
        workbench.compared.connect(self._compared)
        display.changed.connect(self._landmarks_changed)
        self._marked: tuple[Landmark, ...] = ()
        panel.show_pairs(self.pairs)
        self._show()

    @property
    def pairs(self) -> tuple[Landmark, ...]:
        """The landmarks."""
        return self._display.state.landmarks

    def add_landmark(self, surface: int, point: NDArray[np.float64]) -> None:
        """Take a place on a surface, in the comparison's coordinates."""
        shown = self._workbench.shown
        if shown is None:
            return

        to_file = inverse(to_comparison(shown)[surface - 1])
        place = applied(to_file, point[None])[0]
        found: Point = (float(place[0]), float(place[1]), float(place[2]))
        last = self.pairs[-1] if self.pairs and not self.pairs[-1].complete else None
        pair = replace(last or Landmark(), **{("one", "two")[surface - 1]: found})
        pairs = (*(self.pairs[:-1] if last else self.pairs), pair)
        self._display.change(landmarks=pairs)

    def _landmarks_changed(self) -> None:
        if self.pairs is not self._marked:
            self._show_landmarks()

    def _show_landmarks(self) -> None:
        self._marked = self.pairs
        shown, marks = self._workbench.shown, []
        if shown is not None:
            from surfcmp_core.compiled.linear_algebra import applied

            motions = to_comparison(shown)
            for k, pair in enumerate(self.pairs, 1):
                for view, point in enumerate((pair.one, pair.two)):
                    if point is not None:
                        place = applied(motions[view], np.array([point]))[0]
                        marks.append((view, place, str(k)))
        self._display.set_landmarks(marks)
        self._panel.show_pairs(self.pairs)

    def clear(self) -> None:
        """Forget the landmarks."""
        self._display.change(landmarks=())

    def fit_landmarks(self) -> None:
        """Move surface 2 so that its landmarks come nearest to those of 1."""
        shown = self._workbench.shown
        whole = [(pair.one, pair.two) for pair in self.pairs if pair.one and pair.two]
        try:
            found = fit_landmarks([one for one, _ in whole], [two for _, two in whole])
        except InputError as error:
            self._telling.tell(str(error))
            return
        scale = 1.0 if shown is None else float(shown.comparison.surfaces[0].scale)
        # landmarks are where file 1 counts them
        self._move(_motion(found, found.matrix, "landmarks", scale))
        self._display.use(Tool.LOOK)

    def best_fit(self, on_region: bool) -> None:
        """Move surface 2 by iterated closest points, from where it lies."""
        shown, selected = self._workbench.shown, self._regions.selected
        if shown is None:
            return
        if on_region and selected < 0:
            self._telling.tell(self.tr("Draw a region first, or select one"), "note")
            return
        number = selected if on_region else None

        def work(progress: Progress) -> Motion:
            return best_fit_of(shown, number, progress)

        self.runner.start(work)

    def nudge(self, axis: str, step: float) -> None:
        """Shift surface 2 by `step`, or turn it around the middle of the comparison."""
        shown = self._workbench.shown
        if shown is None:
            return

        frame = to_comparison(shown)[0]  # axes are those one sees
        turn = np.eye(4)
        if len(axis) == 1:
            turn["xyz".index(axis), 3] = step
        else:
            k = "xyz".index(axis[1])
            half = [1.0, 0.0, 0.0, 0.0]
            half[k + 1] = round(math.tan(math.radians(step) / 2.0), _DIGITS)
            turn[:3, :3] = rotation(half)
            centre = shown.content.geometry.origin
            turn[:3, 3] = centre - dots(turn[:3, :3], centre)
        old = np.array(self._workbench.document.motion.matrix)
        matrix = composed(inverse(frame), turn, frame, old)
        method = self._workbench.document.motion.method
        words = (
            "by hand" if method in {"none", "by hand"} else f"{method.split(',')[0]}, then by hand"
        )
        self._move(Motion(_matrix(matrix), words))

    def _move(self, motion: Motion) -> None:
        workbench = self._workbench
        if workbench.shown is not None:
            self._before = workbench.shown.comparison.measures
        workbench.set_document(workbench.document.asking(align=motion))

    def _compared(self, result: Compared) -> None:
        if result.document.motion == NOT_MOVED:
            self._before = None
        self._show_landmarks()
        self._show()

    def _show(self) -> None:
        shown = self._workbench.shown
        now = None if shown is None else shown.comparison.measures
        motion = NOT_MOVED if shown is None else shown.document.motion
        self._panel.show_motion(motion, self._before, now, self._workbench.unit)


def to_comparison(shown: Compared) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return what leads from the places of 1 and of 2, as file 1 counts, to the comparison's.

    As file 1 counts: in its unit and axes, as motions are.
    """
    comparison = shown.comparison
    from_file = comparison.surfaces[0].from_file
    return composed(comparison.frame, from_file), composed(comparison.transform, from_file)


def best_fit_of(shown: Compared, number: int | None, progress: Progress) -> Motion:
    """Return how 2 comes nearest to 1 from where it lies, on a region by number or on all."""
    surfaces = shown.comparison.surfaces
    first = surfaces[0]
    masks: list[NDArray[np.bool_] | None] = [None, None]
    if number is not None:
        region = shown.document.regions[number]
        comparison = shown.comparison
        for k, motion in enumerate((comparison.frame, comparison.transform)):
            points = applied(motion, surfaces[k].points)
            masks[k] = region_mask(points[:, 0], points[:, 1], region)
    found = best_fit(
        *surfaces,
        start=carried(np.array(shown.document.motion.matrix), first.scale, first.turned),
        region_1=masks[0],
        region_2=masks[1],
        progress=progress,
    )
    names = {
        "icp": "best fit (ICP)",
        "icp overlap": "best fit (ICP) on the overlap",
        "icp region": "best fit (ICP) on a region",
    }
    method = names.get(found.method, found.method)
    matrix = carried(found.matrix, 1 / first.scale, first.turned)
    return _motion(found, matrix, method)


def _motion(found: "Found", matrix: NDArray[np.float64], method: str, scale: float = 1.0) -> Motion:
    """Keep what a fit says of itself, its lengths times `scale`."""
    record = found.record()
    lengths = {key: record[key] * scale for key in ("rms_kept", "rms_region", "shifted")}
    marks = [{**mark, "residual": mark["residual"] * scale} for mark in record["landmarks"]]
    fit = {key: record[key] for key in FIT_KEYS} | lengths | {"landmarks": marks}
    fixed = {key: tuple(part) if isinstance(part, list) else part for key, part in fit.items()}
    return Motion(_matrix(matrix), method, lengths["rms_kept"], found.inliers, fixed)


def _matrix(array: NDArray[np.float64]) -> Matrix:
    return tuple((float(a), float(b), float(c), float(d)) for a, b, c, d in array)
