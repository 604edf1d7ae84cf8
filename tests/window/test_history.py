"""Undo and redo: of documents, of the view, and of both together."""

from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.model.history import MOST_STEPS, Change, History, Step, change_between
from app.model.landmark import Landmark
from app.model.region import Region, Stroke
from app.model.view_state import Heatmap, Kept, Place, ScaleChoice
from app.window import MainWindow
from surfcmp_core.comparing.options import Motion
from tests.window.conftest import PATIENCE
from tests.window.hands import drag, drop, show

PAIR = (Path("/a"), Path("/b"))
FIRST = Step(Document(PAIR), Kept())


def of(**changes: object) -> Step:
    return replace(FIRST, document=replace(FIRST.document, **changes))


def asking(**options: object) -> Step:
    return replace(FIRST, document=FIRST.document.asking(**options))


def seen(**changes: object) -> Step:
    return replace(FIRST, view=replace(FIRST.view, **changes))


def test_undo_and_redo_walk_along_the_steps():
    one, two, three = (asking(unit=unit) for unit in ("mm", "cm", "m"))
    history = History(one)
    assert not history.push(one)
    assert history.push(two)
    assert history.undo() == one
    assert history.redo() == two
    assert history.redo() == two
    assert history.undo() == one
    assert history.push(three)
    assert history.redoable is None
    history.drop()
    assert history.current == one
    assert history.undoable is None


def test_quick_changes_of_the_scale_are_one_step():
    history = History(FIRST)
    for limit in (2.0, 3.0, 4.0):
        history.push(seen(scale=ScaleChoice(limit)), merged=True)
    assert history.undo() == FIRST
    assert history.redo() == seen(scale=ScaleChoice(4.0))
    history.push(seen(scale=ScaleChoice(4.0), heatmap=Heatmap.TRUST), merged=True)
    assert history.undo() == seen(scale=ScaleChoice(4.0))


def test_a_change_that_is_taken_back_by_hand_is_no_step():
    history = History(FIRST)
    history.push(seen(scale=ScaleChoice(2.0)))
    history.push(FIRST, merged=True)
    assert history.current == FIRST
    assert history.undoable is None
    history.push(seen(edges=False))
    history.undo()
    history.amend(seen(edges=False).view)  # as it would be again
    assert history.redoable is None
    history.push(of(paths=(None, None)))
    history.push(seen(edges=False))
    history.begin()
    assert history.undoable is None


def test_going_back_to_what_is_shown_keeps_what_was_undone():
    one, two, three = (asking(unit=unit) for unit in ("mm", "cm", "m"))
    history = History(one)
    history.push(two)
    history.push(three)
    history.undo()
    history.go_to(three.document)  # the undoing was cancelled
    assert history.current == three
    assert history.undo() == two
    history.redo()
    history.go_to(one.document)  # two and three came to nothing
    assert history.current == one
    assert history.redoable is None


def test_what_had_nothing_to_compare_is_forgotten():
    history = History(Step(Document(), Kept()))
    history.push(Step(Document((Path("/a"), None)), Kept()))
    history.push(FIRST)
    history.begin()
    assert history.undoable is None
    assert history.current == FIRST


def test_the_history_does_not_grow_for_ever():
    history = History(FIRST)
    for k in range(2 * MOST_STEPS):
        history.push(asking(unit=str(k)))
    steps = 0
    while history.undoable:
        history.undo()
        steps += 1
    assert steps == MOST_STEPS - 1


REGION = Region("r", (1, 2, 3))


@pytest.mark.parametrize(
    ("old", "new", "change"),
    [
        (FIRST, of(paths=PAIR[::-1]), Change.SURFACES),
        (FIRST, asking(align=Motion(method="by hand")), Change.MOTION),
        (FIRST, asking(exact=True), Change.OPTIONS),
        (FIRST, asking(tolerances=(9.0,)), Change.SCALE),
        (FIRST, of(regions=(REGION,)), Change.REGIONS),
        (
            of(regions=(REGION,)),
            of(regions=(replace(REGION, strokes=(Stroke(((0, 0),), 1.0),)),)),
            Change.PAINT,
        ),
        (of(regions=(REGION,)), of(regions=(replace(REGION, name="s"),)), Change.REGION_NAME),
        (of(regions=(REGION,)), of(regions=(replace(REGION, weight=2),)), Change.REGION_WEIGHT),
        (
            of(regions=(REGION,)),
            of(regions=(replace(REGION, colour=(0, 0, 0)),)),
            Change.REGION_COLOUR,
        ),
        (FIRST, seen(scale=ScaleChoice(banded=True)), Change.SCALE),
        (FIRST, seen(heatmap=Heatmap.TRUST), Change.HEATMAP),
        (FIRST, seen(edges=False), Change.EDGES),
        (FIRST, seen(probes=(Place(1, (1, 0, 0)),)), Change.PROBES),
        (FIRST, seen(section=(0, 0, 1, 1)), Change.SECTION),
        (FIRST, seen(landmarks=(Landmark(),)), Change.LANDMARKS),
    ],
)
def test_each_change_has_its_name(old: Step, new: Step, change: Change, sample: MainWindow):
    assert change_between(old, new) is change
    sample.actions_of.show_steps(change, None)
    assert sample.actions_of.undo.text().startswith("&Undo ")
    assert not sample.actions_of.redo.isEnabled()


def undo(window: MainWindow) -> None:
    window.actions_of.undo.trigger()


def redo(window: MainWindow) -> None:
    window.actions_of.redo.trigger()


def test_opening_the_first_pair_is_the_beginning(sample: MainWindow):
    assert not sample.actions_of.undo.isEnabled()
    assert sample.actions_of.undo.text() == "&Undo"


def test_the_scale_and_the_map_are_undone(sample: MainWindow, qtbot: QtBot):
    workbench, first = sample.workbench, sample.display.state
    sample.toolbar.heatmap.choices[Heatmap.ABSOLUTE].trigger()
    assert sample.actions_of.undo.text() == "&Undo choice of the map"
    show(sample, "scale")
    sample.scale.banded.click()
    second = sample.display.state
    assert sample.actions_of.undo.text() == "&Undo scale"
    qtbot.keyClick(sample, Qt.Key.Key_M)  # a turn of the camera, as it were, is no step
    undo(sample)
    assert sample.display.state.scale == first.scale
    assert sample.display.state.heatmap is Heatmap.ABSOLUTE
    assert sample.actions_of.redo.text() == "&Redo scale"
    undo(sample)
    assert sample.display.state.kept == first.kept
    assert not sample.scale.banded.isChecked()
    redo(sample)
    redo(sample)
    assert sample.display.state.kept == second.kept
    assert not workbench.runner.busy


def test_a_tolerance_is_undone_with_its_line(sample: MainWindow, qtbot: QtBot):
    show(sample, "scale")
    histogram, before = sample.scale.histogram, sample.display.state.scale
    x = histogram.to_screen(before.tolerances[-1], 0.0).x() / histogram.width()
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        drag(qtbot, histogram, (x, 0.5), (x + 0.05, 0.5), (x + 0.1, 0.5))
    assert sample.display.state.scale.tolerances != before.tolerances
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        undo(sample)
    assert sample.display.state.scale == before
    assert sample.workbench.document.options.tolerances == before.tolerances
    assert not sample.actions_of.undo.isEnabled()


def test_labels_and_section_come_back_with_their_surfaces(
    sample: MainWindow, files: tuple[Path, Path], qtbot: QtBot
):
    sample.grid.frames[3].canvas.clicked.emit(0.0, 0.0)
    sample.places.keep()
    sample.display.change(section=(-10.0, 0.0, 10.0, 0.0), heatmap=Heatmap.ABSOLUTE)
    before = sample.display.state
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        drop(sample, *files)
    assert sample.display.state.probes == ()
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        undo(sample)
    assert sample.display.state.kept == before.kept
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        redo(sample)
    assert sample.display.state.probes == ()
    assert sample.display.state.section is None


def test_a_landmark_is_undone(sample: MainWindow):
    for view in (0, 1, 0):
        point = sample.workbench.shown.content.geometry.origin
        sample.alignment_of.add_landmark(view + 1, point)
    assert len(sample.alignment_of.pairs) == 2
    undo(sample)
    assert len(sample.alignment_of.pairs) == 1
    assert sample.alignment_of.pairs[0].complete
    assert "1 pair" in sample.alignment.pairs.text()
    sample.alignment_of.clear()
    undo(sample)
    assert len(sample.alignment_of.pairs) == 1


def test_undo_while_comparing_and_cancel_leave_what_is_shown(
    sample: MainWindow, files: tuple[Path, Path], qtbot: QtBot
):
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        drop(sample, *files)
    undo(sample)
    sample.workbench.runner.cancel()
    assert sample.workbench.document.paths == files
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        undo(sample)
    assert sample.workbench.document.paths != files
    assert sample.actions_of.redo.isEnabled()


def test_a_change_of_the_view_while_comparing_survives(
    sample: MainWindow, files: tuple[Path, Path], qtbot: QtBot
):
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        drop(sample, *files)
        sample.display.change(heatmap=Heatmap.TRUST)
    assert sample.display.state.heatmap is Heatmap.TRUST
    undo(sample)
    assert sample.display.state.heatmap is Heatmap.SIGNED
    assert sample.workbench.document.paths == files
