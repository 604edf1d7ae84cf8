"""The window as a person uses it."""

import json
import math
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from app.__main__ import main
from app.look.numerals import with_unit
from app.model.view_state import Heatmap
from app.window import MainWindow
from surfcmp_core.io.read import READERS
from tests.window.conftest import PATIENCE
from tests.window.hands import drop, pixels


def test_an_empty_window_says_what_to_do(window: MainWindow):
    assert window.pages.currentWidget() is window.empty
    assert window.empty.open.isVisible()
    said = " ".join(label.text() for label in window.empty.findChildren(QLabel))
    assert set(READERS) <= set(said.split())
    assert not window.progress.isVisible()


def test_the_sample_is_compared_at_first_start(sample: MainWindow):
    assert sample.pages.currentWidget() is sample.grid
    assert "face_before.ply" in sample.windowTitle()
    assert "nodes" in sample.status.text()
    for view in range(4):
        assert len(np.unique(pixels(sample, view).reshape(-1, 4), axis=0)) > 100


def test_two_dropped_files_give_the_numbers_of_the_command_line(
    sample: MainWindow, files: tuple[Path, Path], tmp_path: Path, qtbot: QtBot
):
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        drop(sample, *files)
    out = tmp_path / "result.json"
    assert main(["compare", *map(str, files), "--out", str(out), "--quiet"]) == 0
    expected = json.loads(out.read_text())["measures"]
    for key in ("mean_abs", "rms", "p95", "max_abs", "mean_signed", "rho_V", "rho_delta_V"):
        value, _ = with_unit(expected[key], 1, "mm")
        assert sample.measures.value(key) == value
    table = dict(row.split("\t")[:2] for row in sample.measures.table().splitlines()[1:])
    assert float(table["volume_below"]) == expected["volume_below"]
    assert float(table["≤ 1 mm"]) == 100 * expected["within_tolerance"]["1"]


def test_one_dropped_file_fills_the_empty_place(
    window: MainWindow, files: tuple[Path, Path], qtbot: QtBot
):
    drop(window, files[0])
    assert window.workbench.document.paths == (files[0], None)
    assert not window.workbench.runner.busy
    with qtbot.waitSignal(window.workbench.compared, timeout=PATIENCE):
        drop(window, files[1])
    assert window.workbench.document.paths == files


def test_one_dropped_file_asks_where_both_places_are_taken(
    sample: MainWindow, files: tuple[Path, Path], qtbot: QtBot
):
    before = sample.workbench.document.paths
    drop(sample, files[0])
    assert sample.workbench.document.paths == before
    menu = sample.dialogs.question
    qtbot.waitUntil(menu.isVisible)
    choice = next(a for a in menu.actions() if "2" in a.text() and not a.isSeparator())
    with qtbot.waitSignal(sample.workbench.runner.cancelled, timeout=PATIENCE):
        choice.trigger()
        assert sample.workbench.document.paths == (before[0], files[0])
        sample.workbench.runner.cancel()
    menu.close()


def test_three_files_are_refused_with_one_line(sample: MainWindow, files: tuple[Path, Path]):
    drop(sample, *files, files[0])
    assert sample.banner.isVisible()
    assert "3" in sample.banner.label.text()


def test_a_bad_file_leaves_what_was_shown(sample: MainWindow, tmp_path: Path, qtbot: QtBot):
    shown, before = sample.workbench.shown, sample.measures.table()
    bad = tmp_path / "bad.ply"
    bad.write_text("nothing of the kind")
    with qtbot.waitSignal(sample.workbench.failed, timeout=PATIENCE):
        drop(sample, bad, bad)
    assert sample.banner.isVisible()
    assert "bad.ply" in sample.banner.label.text()
    assert "\n" not in sample.banner.label.text()
    assert sample.workbench.shown is shown
    assert sample.workbench.document.paths == shown.document.paths
    assert sample.measures.table() == before


def test_cancel_leaves_what_was_shown(sample: MainWindow, files: tuple[Path, Path], qtbot: QtBot):
    shown = sample.workbench.shown
    with qtbot.waitSignal(sample.workbench.runner.cancelled, timeout=PATIENCE):
        drop(sample, *files)
        assert sample.progress.isVisible()
        qtbot.mouseClick(sample.progress.cancel, Qt.MouseButton.LeftButton)
    assert not sample.progress.isVisible()
    assert sample.workbench.shown is shown
    assert sample.workbench.document == shown.document
    qtbot.wait(300)  # a late result would come now
    assert sample.workbench.shown is shown


def test_the_newest_of_two_wishes_wins(sample: MainWindow, files: tuple[Path, Path], qtbot: QtBot):
    results = []
    sample.workbench.compared.connect(results.append)
    drop(sample, *files)
    drop(sample, files[1], files[0])
    qtbot.waitUntil(lambda: not sample.workbench.runner.busy, timeout=PATIENCE)
    assert [result.document.paths for result in results] == [(files[1], files[0])]


def test_exchange_changes_the_sign(sample: MainWindow, qtbot: QtBot):
    before = sample.workbench.shown.content.comparison.measures
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        qtbot.mouseClick(sample.toolbar.swap, Qt.MouseButton.LeftButton)
    after = sample.workbench.shown.content.comparison.measures
    assert math.isclose(after.mean_signed, -before.mean_signed, rel_tol=1e-9)
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        sample.actions_of.undo.trigger()
    assert sample.workbench.shown.content.comparison.measures == before


@pytest.mark.parametrize("view", range(4))
def test_a_view_fills_the_window_and_gives_it_back(sample: MainWindow, view: int, qtbot: QtBot):
    QTest.mouseDClick(sample.grid.frames[view].title, Qt.MouseButton.LeftButton)
    assert [frame.isVisible() for frame in sample.grid.frames] == [k == view for k in range(4)]
    qtbot.waitUntil(lambda: sample.grid.frames[view].size() == sample.grid.size())
    qtbot.keyClick(sample, Qt.Key.Key_0)
    assert all(frame.isVisible() for frame in sample.grid.frames)
    qtbot.keyClick(sample, Qt.Key(Qt.Key.Key_1 + view))
    assert [frame.isVisible() for frame in sample.grid.frames] == [k == view for k in range(4)]


def test_map_and_relief_by_one_switch(sample: MainWindow, qtbot: QtBot):
    relief = pixels(sample, 0)
    with qtbot.waitSignal(sample.display.shown, timeout=PATIENCE):
        qtbot.mouseClick(sample.toolbar.map, Qt.MouseButton.LeftButton)
    assert not sample.display.state.relief
    assert sample.display.camera.back == (0.0, 0.0, 1.0)
    assert (pixels(sample, 0) != relief).any()


def test_dragging_turns_all_views(sample: MainWindow, qtbot: QtBot):
    before = [pixels(sample, view) for view in range(4)]
    canvas = sample.grid.frames[0].canvas
    with qtbot.waitSignal(sample.display.shown, timeout=PATIENCE):
        qtbot.mousePress(canvas, Qt.MouseButton.LeftButton, pos=QPoint(100, 100))
        qtbot.mouseMove(canvas, QPoint(160, 120))
        qtbot.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=QPoint(160, 120))
    qtbot.waitUntil(lambda: all((pixels(sample, view) != before[view]).any() for view in range(4)))


@pytest.mark.parametrize("heatmap", list(Heatmap))
def test_every_heatmap_is_drawn(sample: MainWindow, heatmap: Heatmap, qtbot: QtBot):
    sample.toolbar.heatmap.choices[heatmap].trigger()
    assert sample.display.state.heatmap is heatmap
    qtbot.waitUntil(lambda: len(np.unique(pixels(sample, 3).reshape(-1, 4), axis=0)) > 50)


def test_the_range_stays_until_it_is_changed(
    sample: MainWindow, files: tuple[Path, Path], qtbot: QtBot
):
    box = sample.scale.limit
    box.selectAll()
    qtbot.keyClicks(box, "3.5")
    qtbot.keyClick(box, Qt.Key.Key_Return)
    assert sample.display.state.scale.limit == 3.5
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        drop(sample, *files)
    assert sample.display.state.scale.limit == 3.5
    qtbot.mouseClick(sample.scale.fit, Qt.MouseButton.LeftButton)
    assert sample.display.state.scale.limit != 3.5


def test_bands_at_the_tolerances_the_user_types(sample: MainWindow, qtbot: QtBot):
    box = sample.scale.tolerances
    box.setFocus()
    box.selectAll()
    qtbot.keyClicks(box, "0.1 0.4")
    qtbot.keyClick(box, Qt.Key.Key_Return)
    sample.scale.banded.click()
    assert sample.display.state.scale.tolerances == (0.1, 0.4)
    assert sample.display.state.scale.banded


def test_a_click_picks_a_triangle_and_a_second_one_lets_it_go(sample: MainWindow, qtbot: QtBot):
    canvas = sample.grid.frames[3].canvas
    centre = canvas.rect().center()
    qtbot.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=centre)
    assert sample.display.state.picked is not None
    qtbot.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=centre)
    assert sample.display.state.picked is None


def test_the_measures_are_copied_as_a_table(sample: MainWindow, qtbot: QtBot):
    qtbot.mouseClick(sample.measures.copy, Qt.MouseButton.LeftButton)
    assert QGuiApplication.clipboard().text() == sample.measures.table()


def test_dark_and_light(sample: MainWindow, qtbot: QtBot):
    light = pixels(sample, 0)[2, 2, :3].astype(int)
    sample.actions_of.toggle_dark()
    qtbot.waitUntil(lambda: pixels(sample, 0)[2, 2, :3].astype(int).sum() < light.sum() / 2)
    sample.actions_of.toggle_dark()


def test_closing_during_a_computation(window: MainWindow, files: tuple[Path, Path]):
    drop(window, *files)
    assert window.workbench.runner.busy
    window.close()
    assert not window.workbench.runner.busy
