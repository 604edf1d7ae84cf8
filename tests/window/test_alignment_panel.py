"""Surface 2 is moved by hand, by landmarks, by a best fit."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QToolButton
from pytestqt.qtbot import QtBot

from app.window import MainWindow
from surfcmp_core.comparing.options import NOT_MOVED
from tests.window.conftest import PATIENCE
from tests.window.hands import LEFT, show


def test_a_nudge_is_a_motion_and_undone(sample: MainWindow, qtbot: QtBot):
    show(sample, "alignment")
    before = sample.workbench.shown.comparison.measures.mean_signed
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        sample.alignment.nudged.emit("z", 1.5)
    motion = sample.workbench.document.motion
    assert motion.matrix[2][3] == 1.5
    after = sample.workbench.shown.comparison.measures.mean_signed
    assert after == pytest.approx(before - 1.5, abs=1e-6)
    assert sample.workbench.shown.record["options"]["align"]["method"] == "by hand"
    assert "by hand" in sample.alignment.method.text()
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        qtbot.mouseClick(sample.alignment.reset, LEFT)
    assert sample.workbench.shown.comparison.measures.mean_signed == before


def test_each_button_nudges_its_way(sample: MainWindow, qtbot: QtBot):
    show(sample, "alignment")
    box = sample.alignment.step
    box.setFocus()
    box.selectAll()
    qtbot.keyClicks(box, "0.5")
    qtbot.keyClick(box, Qt.Key.Key_Return)
    buttons = {b.text(): b for b in sample.alignment.findChildren(QToolButton)}
    for text, (row, column, value) in (
        ("+x", (0, 3, 0.5)),
        ("−y", (1, 3, -0.5)),
        ("+↻z", (1, 0, np.sin(np.deg2rad(0.5)))),
    ):
        with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
            qtbot.mouseClick(buttons[text], LEFT)
        assert sample.workbench.document.motion.matrix[row][column] == pytest.approx(value)
        assert sample.actions_of.undo.text() == "&Undo alignment"
        with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
            sample.actions_of.undo.trigger()
    assert sample.workbench.document.motion == NOT_MOVED


def test_best_fit_takes_a_shift_back(sample: MainWindow, qtbot: QtBot):
    show(sample, "alignment")
    for axis, step in (("x", 2.0), ("rz", 1.5)):
        with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
            sample.alignment.nudged.emit(axis, step)
    off = sample.workbench.shown.comparison.measures.mean_abs
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        qtbot.mouseClick(sample.alignment.fit, LEFT)
    fitted = sample.workbench.shown.comparison.measures.mean_abs
    assert fitted < off / 2
    assert "ICP" in sample.alignment.method.text()
    assert sample.workbench.document.motion.residual is not None


def test_landmarks_move_surface_2(sample: MainWindow, qtbot: QtBot):
    show(sample, "alignment")
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        sample.alignment.nudged.emit("y", 3.0)
    sample.display.change(relief=False)
    qtbot.mouseClick(sample.alignment.pick, LEFT)
    for x, y in ((0.42, 0.4), (0.58, 0.4), (0.5, 0.75), (0.5, 0.3)):
        for view in (0, 1):
            canvas = sample.grid.frames[view].canvas
            place = QPoint(round(x * canvas.width()), round(y * canvas.height()))
            qtbot.mouseClick(canvas, LEFT, pos=place)
    assert len(sample.alignment_of.pairs) == 4
    texts = [[label.text for label in frame.canvas.labels] for frame in sample.grid.frames]
    assert texts == [["1", "2", "3", "4"], ["1", "2", "3", "4"], [], []]
    first = sample.grid.frames[0].canvas
    assert first.position(first.labels[2].right, first.labels[2].up).x() == pytest.approx(
        0.5 * first.width(), abs=2
    )
    assert sample.display.state.picked is None
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        qtbot.mouseClick(sample.alignment.use, LEFT)
    # the same places of the plane were clicked, so that only heights could move it
    assert sample.workbench.document.motion.method == "landmarks"
    qtbot.mouseClick(sample.alignment.clear, LEFT)
    assert not sample.alignment.use.isEnabled()


def test_too_few_landmarks_cannot_be_used(sample: MainWindow):
    assert not sample.alignment.use.isEnabled()
    sample.alignment_of.fit_landmarks()
    assert sample.banner.isVisible()
