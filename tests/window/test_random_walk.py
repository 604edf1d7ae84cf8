"""Actions in any order leave a window that works."""

import os
import random
import threading
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import SignalInstance
from pytestqt.exceptions import capture_exceptions
from pytestqt.qtbot import QtBot

from app.model.tool import Tool
from app.model.view_state import Heatmap
from app.panels.regions_panel import COLOURS
from app.window import MainWindow
from tests.window.conftest import PATIENCE

STEPS = int(os.environ.get("SURFCMP_WALK", "300"))
"""How far to walk; `SURFCMP_WALK=2000` walks as far as one does before a release."""

SEED = int(os.environ.get("SURFCMP_SEED", "11"))


def check(window: MainWindow) -> None:
    """What is shown, the document, the view and the history must belong together."""
    workbench, display = window.workbench, window.display
    if workbench.shown is None:
        return
    assert workbench.document == workbench.shown.document
    assert display.content is workbench.shown.content
    assert display.state.kept == workbench.history.current.view
    assert display.state.scale.tolerances == workbench.document.options.tolerances
    assert window.actions_of.undo.isEnabled() == (workbench.history.undoable is not None)
    assert window.actions_of.redo.isEnabled() == (workbench.history.redoable is not None)
    measures = workbench.shown.comparison.measures
    parts = [part.measures.area_compared for part in workbench.shown.regions if part.measures]
    if workbench.document.regions:
        assert sum(parts) == pytest.approx(measures.area_compared, rel=1e-12)
    triangles = len(workbench.shown.comparison.united.triangles)
    assert all(place.triangle < triangles for place in display.state.probes)


@pytest.mark.timeout(1800)
def test_a_random_walk(window: MainWindow, files: tuple[Path, Path], tmp_path: Path, qtbot: QtBot):
    chance = random.Random(SEED)
    workbench, display = window.workbench, window.display
    bad = tmp_path / "bad.ply"
    bad.write_text("no")
    saved = tmp_path / "walk.surfcmp"
    errors: list[str] = []

    def place() -> tuple[float, float]:
        return chance.uniform(-0.5, 0.5), chance.uniform(-0.5, 0.5)

    def spot() -> tuple[float, float]:
        return chance.uniform(-45, 45), chance.uniform(-45, 45)

    def scale() -> None:
        limit, banded = chance.choice([0.1, 1.0, 5.0]), chance.random() < 0.5
        tolerances = chance.choice([(0.5, 1.0, 2.0), (0.1,), (0.2, 3.0)])
        old = display.state.scale
        window.scale.changed.emit(
            replace(old, limit=limit, banded=banded, tolerances=tolerances, pinned=True)
        )

    def of_a_region(signal: SignalInstance, *values: object) -> None:
        if workbench.document.regions:
            signal.emit(chance.randrange(len(workbench.document.regions)), chance.choice(values))

    def stroke() -> None:
        window.regions.take.setChecked(chance.random() < 0.4)
        tool = chance.choice([Tool.LASSO, Tool.BRUSH])
        window.regions_of.draw(tool, (spot(), spot(), spot(), spot()))

    def landmark() -> None:
        if workbench.shown is not None:
            place = workbench.shown.content.geometry.origin + np.array([*spot(), chance.random()])
            window.alignment_of.add_landmark(chance.choice([1, 2]), place)

    def settle() -> None:
        qtbot.waitUntil(lambda: not workbench.runner.busy, timeout=PATIENCE)
        check(window)

    def option() -> None:
        panel = window.options
        button = chance.choice([panel.domain, panel.duplicates, panel.unit, panel.project])
        chance.choice(list(button.choices.values())).trigger()

    actions = [
        lambda: window.opening.take(list(files)),
        lambda: window.opening.take([bad, files[0]]),
        lambda: workbench.open([files[chance.randrange(2)]], chance.choice([1, 2])),
        workbench.runner.cancel,
        workbench.undo,
        workbench.redo,
        workbench.undo,
        workbench.redo,
        window.opening.swap_surfaces,
        lambda: window.alignment.nudged.emit(chance.choice(["x", "z", "ry"]), 0.5),
        lambda: window.alignment_of.best_fit(False),
        lambda: window.alignment_of.best_fit(True),
        landmark,
        landmark,
        window.alignment_of.fit_landmarks,
        window.alignment_of.clear,
        lambda: window.alignment.reset_asked.emit(),
        lambda: display.use(chance.choice(list(Tool))),
        stroke,
        stroke,
        stroke,
        window.regions.new.click,
        lambda: window.regions_of.draw(Tool.SECTION, (spot(), spot())),
        lambda: window.regions_of.remove(0),
        lambda: of_a_region(window.regions.renamed, "", "nose", "chin"),
        lambda: of_a_region(window.regions.weighed, -1.0, 0.0, 0.5, 3.0),
        lambda: of_a_region(window.regions.coloured, *COLOURS),
        lambda: window.regions_of.save(tmp_path / "regions.json"),
        lambda: (
            (tmp_path / "regions.json").is_file()
            and window.regions_of.load(tmp_path / "regions.json")
        ),
        option,
        scale,
        scale,
        window.scaling.fit,
        lambda: display.change(heatmap=chance.choice(list(Heatmap))),
        lambda: display.change(relief=chance.random() < 0.5),
        lambda: display.change(brush=chance.choice([None, (0.1, 1.0)])),
        lambda: display.toggle_fill(chance.randrange(4)),
        lambda: display._pick(chance.randrange(4), *place()),
        lambda: display._turn(*place()),
        lambda: display._zoom(chance.choice([0.8, 1.25]), *place()),
        display.go_home,
        window.places.keep,
        lambda: window.sessions.save(saved, embed=chance.random() < 0.5),
        lambda: saved.is_file() and window.sessions.open(saved),
        window.sessions._save_now,
        window.sessions.offer_recovery,
        lambda: window.banner.action.isVisible() and window.banner.action.click(),
        lambda: window.exporting.write(tmp_path / f"out{chance.choice(['.json', '.csv'])}"),
        window.actions_of.hide.trigger,
        window.actions_of.toggle_dark,
        window.actions_of.toggle_edges,
        window.actions_of.stop,
        lambda: window.chains.model.rowCount() and window.chains_of.fly_to(0),
        lambda: chance.choice(window.docks.all).setVisible(chance.random() < 0.7),
        lambda: qtbot.wait(chance.choice([1, 10, 60])),
        *[settle] * 8,
    ]
    workbench.failed.connect(errors.append)
    with capture_exceptions() as exceptions:
        for _ in range(STEPS):
            chance.choice(actions)()
        qtbot.waitUntil(lambda: not workbench.runner.busy, timeout=PATIENCE)
        for runner in window.runners:
            qtbot.waitUntil(lambda r=runner: not r.busy and r.wait(0.0), timeout=PATIENCE)
        qtbot.wait(200)
    assert exceptions == []
    assert all("\n" not in error and "internal" not in error for error in errors), errors
    check(window)
    for _ in range(8):  # all the way back, and forth again
        workbench.undo()
        qtbot.waitUntil(lambda: not workbench.runner.busy, timeout=PATIENCE)
        check(window)
    for _ in range(8):
        workbench.redo()
        qtbot.waitUntil(lambda: not workbench.runner.busy, timeout=PATIENCE)
        check(window)
    names = {thread.name for thread in threading.enumerate()}
    assert names <= {"MainThread", "studio", "comparison"}
    # and it still works
    workbench.open(files[::-1])
    workbench.open(files)
    qtbot.waitUntil(
        lambda: not workbench.runner.busy and workbench.shown.document.paths == files,
        timeout=PATIENCE,
    )
