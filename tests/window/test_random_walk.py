"""Actions in any order leave a window that works.

`SURFCMP_WALK=300` walks as many ways as one does before a release, and other ones each time.
"""

import faulthandler
import math
import os
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import ClassVar

import numpy as np
import pytest
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, rule, run_state_machine_as_test
from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QDialog
from pytestqt.exceptions import capture_exceptions

from app import settings as remembered
from app.drawing.renderer import Renderer
from app.drawing.studio import Pictures, Studio, Wish
from app.model.document import Document
from app.model.history import History
from app.model.tool import Tool
from app.model.view_state import Heatmap, ViewState
from app.panels.command_palette import plain
from app.panels.regions_panel import COLOURS
from app.scene.scene import Scene, scene_of
from app.window import MainWindow
from tests.window.builders import hills
from tests.window.conftest import PATIENCE

WALKS = int(os.environ.get("SURFCMP_WALK", "0"))
STEPS = 12
EXCEPTIONS = {"Quit": "the walk would end"}
"""Actions that are not taken, and why."""
QUICK = {".surfcmp", ".json", ".csv"}
"""Files that are written when asked for; otherwise the user thinks better of it."""

number = st.integers(0, 2)
share = st.floats(-0.5, 0.5, width=16)
spot = st.tuples(*[st.integers(-45, 45)] * 2)
view = st.integers(0, 3)


class Answers:
    """What the user answers, in place of the system's own dialogs."""

    def __init__(self, files: tuple[Path, ...], folder: Path) -> None:
        self.files_there = files
        self.folder = folder
        self.willing = True

    def file(self, title: str, start: str = "", kinds: str = "") -> Path | None:
        kept = {"*.json": "regions.json", "*.surfcmp": "comparison.surfcmp"}
        path = self.folder / kept[kinds] if kinds in kept else self.files_there[0]
        return path if self.willing and path.is_file() else None

    def files(self, title: str, kinds: str) -> list[Path]:
        return list(self.files_there[:2]) if self.willing else []

    def place(self, title: str, start: str, kinds: str) -> tuple[Path | None, str]:
        path = self.folder / start
        willing = self.willing and path.suffix in QUICK
        return path if willing else None, kinds.split(";;")[0]

    def colour(self, title: str, old: tuple[int, int, int]) -> tuple[int, int, int] | None:
        return (9, 9, 9) if self.willing else None

    def choose(self, heading: str, answers: dict[str, Callable[[], object]]) -> None:
        if self.willing:
            next(iter(answers.values()))()


class Walk(RuleBasedStateMachine):
    """One way through the window; all ways begin alike, in the same window."""

    window: ClassVar[MainWindow]
    answers: ClassVar[Answers]
    actions: ClassVar[dict[str, QAction]]
    wishes: ClassVar[list[Wish]]
    pictures: ClassVar[list[Pictures]]
    scenes: ClassVar[list[Scene]]
    faults: ClassVar[list[object]]
    bad: ClassVar[Path]

    def __init__(self) -> None:
        super().__init__()
        window, answers = self.window, self.answers
        answers.willing = True
        remembered.hide_names(False)
        window.actions_of.hide.setChecked(False)
        window.regions.take.setChecked(False)
        window.docks.arrange_as_at_first()
        window.display.use(Tool.LOOK)
        window.display.show(ViewState())
        window.workbench.restore(Document(answers.files_there[:2]), ViewState())
        self.settle()
        window.display.go_home()
        window.sessions.save(answers.folder / "comparison.surfcmp")  # from now on it is saved there
        self.settle()
        for path in answers.folder.iterdir():
            path.unlink()
        window.banner.hide()
        window.workbench.history = History(window.workbench.history.current)
        window.workbench.changed.emit()
        self.refusable = False

    def settle(self) -> None:
        """Wait until all work is done and drawn."""
        end = time.monotonic() + PATIENCE / 1000
        while not self._rests():
            QCoreApplication.processEvents()
            time.sleep(0.002)  # for the threads at work
            assert time.monotonic() < end, "no picture of what is shown came"

    def _rests(self) -> bool:
        shown = self.pictures[-1:]
        drawn = bool(shown) and shown[0].final and shown[0].wish is self.wishes[-1]
        return drawn and not any(runner.busy for runner in self.window.runners)

    @rule(name=st.deferred(lambda: st.sampled_from(list(Walk.actions))), willing=st.booleans())
    def act(self, name: str, willing: bool) -> None:
        self.answers.willing = willing
        self.actions[name].trigger()

    @rule(names=st.deferred(lambda: st.lists(st.sampled_from(list(Walk.actions)), max_size=3)))
    def act_without_waiting(self, names: list[str]) -> None:
        self.answers.willing = True
        for name in names:
            self.actions[name].trigger()

    @rule(which=st.sampled_from([(0, 1), (1, 0), (2,), (0,), (2, 1), (0, 1, 2)]))
    def drop(self, which: tuple[int, ...]) -> None:
        self.refusable = len(which) > 2
        self.window.opening.take([self.answers.files_there[k] for k in which])

    @rule(first=st.booleans())
    def drop_what_is_no_surface(self, first: bool) -> None:
        self.refusable = True
        paths = [self.bad, self.answers.files_there[0]]
        self.window.opening.take(paths if first else paths[::-1])

    @rule(axis=st.sampled_from(["x", "z", "ry"]))
    def nudge(self, axis: str) -> None:
        self.window.alignment.nudged.emit(axis, 0.5)

    @rule(on_region=st.booleans())
    def fit(self, on_region: bool) -> None:
        self.refusable = True
        self.window.alignment.fit_asked.emit(on_region)

    @rule()
    def put_back(self) -> None:
        self.window.alignment.reset_asked.emit()

    @rule(surface=st.sampled_from([1, 2]), place=spot, z=st.integers(0, 2))
    def mark(self, surface: int, place: tuple[int, int], z: int) -> None:
        point = np.array([*place, z], dtype=np.float64)
        self.window.display.landmark_picked.emit(surface, point)

    @rule()
    def fit_landmarks(self) -> None:
        self.refusable = True
        self.window.alignment.landmarks_asked.emit()

    @rule()
    def clear_landmarks(self) -> None:
        self.window.alignment.clear_asked.emit()

    @rule(
        tool=st.sampled_from([Tool.LASSO, Tool.BRUSH, Tool.SECTION]),
        path=st.lists(spot, min_size=2, max_size=4),
        takes=st.booleans(),
    )
    def draw(self, tool: Tool, path: list[tuple[int, int]], takes: bool) -> None:
        self.window.regions.take.setChecked(takes)
        places = tuple((float(x), float(y)) for x, y in path)
        self.window.display.path_drawn.emit(tool, places)

    @rule()
    def let_go_of_the_region(self) -> None:
        self.window.regions.new.click()

    @rule(which=number)
    def remove_a_region(self, which: int) -> None:
        self.window.regions.remove_asked.emit(which)

    @rule(
        which=number,
        name=st.sampled_from(["", "nose", "chin"]),
        weight=st.sampled_from([-1.0, 0.0, 0.5, 3.0]),
        colour=st.sampled_from([None, *COLOURS]),
    )
    def change_a_region(
        self, which: int, name: str, weight: float, colour: tuple[int, int, int] | None
    ) -> None:
        panel = self.window.regions
        if which < len(self.window.workbench.document.regions):
            panel.renamed.emit(which, name)
            panel.weighed.emit(which, weight)
            panel.coloured.emit(which, colour)

    @rule(saving=st.booleans(), willing=st.booleans())
    def keep_regions(self, saving: bool, willing: bool) -> None:
        self.answers.willing = willing
        (self.window.regions.save_asked if saving else self.window.regions.load_asked).emit()

    @rule(which=st.integers(0, 3), choice=st.integers(0, 7))
    def choose_an_option(self, which: int, choice: int) -> None:
        self.refusable = True
        panel = self.window.options
        button = (panel.domain, panel.duplicates, panel.unit, panel.project)[which]
        choices = list(button.choices.values())
        choices[choice % len(choices)].trigger()

    @rule(
        limit=st.sampled_from([0.1, 1.0, 5.0]),
        tolerances=st.sampled_from([(0.5, 1.0, 2.0), (0.1,), (0.2, 3.0)]),
        banded=st.booleans(),
        pinned=st.booleans(),
    )
    def scale(self, **chosen: object) -> None:
        panel = self.window.scale
        panel.changed.emit(replace(self.window.display.state.scale, **chosen))

    @rule()
    def fit_the_range(self) -> None:
        self.window.scale.fit_asked.emit()

    @rule(kind=st.sampled_from(list(Heatmap)))
    def choose_a_map(self, kind: Heatmap) -> None:
        self.window.toolbar.heatmap_chosen.emit(kind)

    @rule(brush=st.sampled_from([None, (0.1, 1.0)]))
    def brush(self, brush: tuple[float, float] | None) -> None:
        self.window.scale.brushed.emit(brush)

    @rule(view=view)
    def fill(self, view: int) -> None:
        self.window.grid.frames[view].title.filled.emit()

    @rule(view=view, right=share, up=share)
    def pick(self, view: int, right: float, up: float) -> None:
        self.window.grid.frames[view].canvas.clicked.emit(right, up)

    @rule(right=share, up=share)
    def turn(self, right: float, up: float) -> None:
        self.window.grid.frames[0].canvas.turned.emit(right, up)

    @rule(factor=st.sampled_from([0.8, 1.25]), right=share, up=share)
    def zoom(self, factor: float, right: float, up: float) -> None:
        self.window.grid.frames[0].canvas.zoomed.emit(factor, right, up)

    @rule(which=number)
    def remove_a_label(self, which: int) -> None:
        self.window.probes.remove_asked.emit(which)

    @rule(chain=number)
    def fly_to_a_chain(self, chain: int) -> None:
        if chain < self.window.chains.model.rowCount():
            self.window.chains.chosen.emit(chain)

    @rule(which=st.integers(0, 7), shown=st.booleans())
    def show_a_panel(self, which: int, shown: bool) -> None:
        self.window.docks.all[which].setVisible(shown)

    @rule()
    def do_what_is_offered(self) -> None:
        with suppress(RuntimeError):
            self.window.banner.action.click()

    @invariant()
    def all_is_well(self) -> None:
        self.settle()
        for dialog in self.window.findChildren(QDialog):
            dialog.close()
        assert self.faults == []
        self._is_told()
        self._agrees()
        self._comes_back()

    def _comes_back(self) -> None:
        """What undo takes back redo does again."""
        workbench, display = self.window.workbench, self.window.display
        before = workbench.document, display.state.kept
        if workbench.history.undoable is not None:
            workbench.undo()
            self.settle()
            self._agrees()
            assert (workbench.document, display.state.kept) != before
            workbench.redo()
            self.settle()
            self._agrees()
            assert (workbench.document, display.state.kept) == before

    def _is_told(self) -> None:
        """Errors are told in one line, and only where something may be refused."""
        banner = self.window.banner
        if banner.isVisible() and banner.property("kind") == "error":
            text = banner.label.text()
            assert self.refusable, text
            assert "\n" not in text
            assert "internal error" not in text
            banner.hide()
        self.refusable = False

    def _agrees(self) -> None:
        """Document, numbers, view, menus and pictures belong to the same step."""
        window, workbench, display = self.window, self.window.workbench, self.window.display
        assert workbench.shown is not None
        assert workbench.document == workbench.shown.document
        assert display.content is workbench.shown.content
        assert display.state.kept == workbench.history.current.view
        assert display.state.scale.tolerances == workbench.document.options.tolerances
        assert window.actions_of.undo.isEnabled() == (workbench.history.undoable is not None)
        assert window.actions_of.redo.isEnabled() == (workbench.history.redoable is not None)
        comparison = workbench.shown.comparison
        parts = [part.measures.area_compared for part in workbench.shown.regions if part.measures]
        if workbench.document.regions:
            assert sum(parts) == pytest.approx(comparison.measures.area_compared, rel=1e-12)
        triangles = len(comparison.united.triangles)
        assert all(place.triangle < triangles for place in display.state.probes)
        wish = self.wishes[-1]
        assert (wish.content, wish.camera) == (display.content, display.camera)
        assert wish.state.drawn == display.state.drawn
        assert wish.sizes == window.grid.sizes()
        fresh = scene_of(replace(display.content), display.state)
        assert self.scenes[-1].palette == fresh.palette
        for drawn, layer in zip(self.scenes[-1].layers, fresh.layers, strict=True):
            assert drawn.patch is layer.patch
            for part in ("colours", "coarse_colours", "nodes", "lines", "line_colours"):
                assert np.array_equal(getattr(drawn, part), getattr(layer, part)), part
            assert (drawn.relief, drawn.shaded, drawn.edges) == (
                layer.relief,
                layer.shaded,
                layer.edges,
            )


@pytest.fixture
def walked(window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> MainWindow:
    """Give a window whose questions are answered and whose pictures are remembered."""
    paths = tuple(tmp_path / f"{name}.xyz" for name in ("before", "after", "later"))
    for k, path in enumerate(paths):
        cloud = hills(60 - 10 * k, k, lift=3.0 * k)
        np.savetxt(path, cloud + np.array([0.0, 0.0, k]))
    Walk.bad = tmp_path / "bad.ply"
    Walk.bad.write_text("no")
    (tmp_path / "written").mkdir()
    Walk.window, Walk.answers = window, Answers(paths, tmp_path / "written")
    for name in ("file", "files", "place", "colour", "choose"):
        monkeypatch.setattr(window.dialogs, name, getattr(Walk.answers, name))
    monkeypatch.setattr("surfcmp_core.io.samples.sample_pair", lambda _: paths[1:])
    monkeypatch.setattr("app.controllers.workbench.MERGED_SECONDS", math.inf)
    Walk.actions = {plain(action): action for action in window.actions_of.all}
    assert set(EXCEPTIONS) <= set(Walk.actions)
    for name in EXCEPTIONS:
        del Walk.actions[name]
    Walk.wishes, Walk.pictures, Walk.scenes = [], [], []
    window.display.shown.connect(Walk.pictures.append)
    apply, show = Renderer.apply, Studio.show

    def wish(studio: Studio, wish: Wish) -> None:
        Walk.wishes.append(wish)
        show(studio, wish)

    def remember(renderer: Renderer, scene: Scene | None) -> None:
        if scene is not None and scene.layers[0].nodes is not None:  # no sketch
            Walk.scenes.append(scene)
        apply(renderer, scene)

    monkeypatch.setattr(Renderer, "apply", remember)
    monkeypatch.setattr(Studio, "show", wish)
    monkeypatch.setattr("app.controllers.display.SLOW_SECONDS", -1.0)  # the camera jumps
    monkeypatch.setattr("app.drawing.studio.AFFORDABLE_SECONDS", 0.0)  # no finer pictures
    window.resize(700, 500)
    return window


@pytest.mark.timeout(7200 if WALKS else 900)
def test_a_random_walk(walked: MainWindow):
    faulthandler.cancel_dump_traceback_later()  # a way that fails is made shorter for minutes
    with capture_exceptions() as Walk.faults:
        run_state_machine_as_test(
            Walk,
            settings=settings(
                max_examples=WALKS or 10,
                stateful_step_count=2 * STEPS if WALKS else STEPS,
                derandomize=not WALKS,
                suppress_health_check=list(HealthCheck),
            ),
        )
    names = {thread.name for thread in threading.enumerate()}
    assert names <= {"MainThread", "studio", "comparison"}
