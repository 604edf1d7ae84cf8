"""Regions are drawn, named, weighed, saved."""

import json
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from app.model.tool import Tool
from app.panels.regions_panel import COLOURS
from app.window import MainWindow
from tests.window.conftest import PATIENCE
from tests.window.hands import LEFT, drag, show


@pytest.fixture
def lassoed(sample: MainWindow, qtbot: QtBot) -> MainWindow:
    """Give the sample with a region drawn over the relief."""
    show(sample, "regions")
    qtbot.mouseClick(sample.regions.lasso, LEFT)
    assert sample.display.tool is Tool.LASSO
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        drag(qtbot, sample.grid.frames[3].canvas, (0.4, 0.4), (0.7, 0.4), (0.7, 0.7), (0.4, 0.7))
    return sample


def test_a_region_is_drawn_named_weighed_and_undone(lassoed: MainWindow, qtbot: QtBot):
    panel, workbench = lassoed.regions, lassoed.workbench
    assert panel.tree.topLevelItemCount() == 3
    whole = workbench.shown.comparison.measures.area_compared
    parts = [part.measures.area_compared for part in workbench.shown.regions]
    assert sum(parts) == pytest.approx(whole)
    item = panel.tree.topLevelItem(0)
    with qtbot.waitSignal(workbench.compared, timeout=PATIENCE):
        item.setText(0, "cheek")
    with qtbot.waitSignal(workbench.compared, timeout=PATIENCE):
        panel.tree.topLevelItem(0).setText(1, "2.5")
    region = workbench.document.regions[0]
    assert (region.name, region.weight) == ("cheek", 2.5)
    shown = workbench.shown.content.comparison.measures
    assert shown.rho_V_mu > shown.rho_V
    assert lassoed.measures.value("rho_V_mu") != lassoed.measures.value("rho_V")
    panel.tree.topLevelItem(0).setText(1, "none")
    assert workbench.document.regions[0].weight == 2.5
    for _ in range(3):
        with qtbot.waitSignal(workbench.compared, timeout=PATIENCE):
            lassoed.actions_of.undo.trigger()
    assert workbench.document.regions == ()
    assert panel.tree.topLevelItemCount() == 0


def test_a_brush_adds_to_the_selected_region(lassoed: MainWindow, qtbot: QtBot):
    qtbot.mouseClick(lassoed.regions.brush, LEFT)
    with qtbot.waitSignal(lassoed.workbench.compared, timeout=PATIENCE):
        drag(qtbot, lassoed.grid.frames[2].canvas, (0.4, 0.3), (0.5, 0.3), (0.6, 0.3))
    (region,) = lassoed.workbench.document.regions
    lasso, brush = region.strokes
    assert (lasso.radius, brush.radius) == (0.0, lassoed.regions.radius.value)
    assert len(brush.path) > 2


def taken_away(window: MainWindow, qtbot: QtBot, key: Qt.KeyboardModifier) -> float:
    """Drag the brush through the selected region; return how much of its area is left."""
    area = window.workbench.shown.regions[0].measures.area_compared
    canvas = window.grid.frames[3].canvas
    places = [QPoint(round(x * canvas.width()), canvas.height() // 2) for x in (0.5, 0.55, 0.6)]
    with qtbot.waitSignal(window.workbench.compared, timeout=PATIENCE):
        qtbot.mousePress(canvas, LEFT, key, places[0])
        for place in places[1:]:
            qtbot.mouseMove(canvas, place)
        qtbot.mouseRelease(canvas, LEFT, key, places[-1])
    return window.workbench.shown.regions[0].measures.area_compared / area


def test_a_brush_takes_away_from_the_selected_region(lassoed: MainWindow, qtbot: QtBot):
    qtbot.mouseClick(lassoed.regions.brush, LEFT)
    assert 0.3 < taken_away(lassoed, qtbot, Qt.KeyboardModifier.ShiftModifier) < 0.95
    with qtbot.waitSignal(lassoed.workbench.compared, timeout=PATIENCE):
        lassoed.actions_of.undo.trigger()
    qtbot.mouseClick(lassoed.regions.take, LEFT)
    assert 0.3 < taken_away(lassoed, qtbot, Qt.KeyboardModifier.NoModifier) < 0.95
    assert [stroke.takes for stroke in lassoed.workbench.document.regions[0].strokes] == [
        False,
        True,
    ]
    shown = lassoed.workbench.shown
    parts = [part.measures.area_compared for part in shown.regions]
    assert sum(parts) == pytest.approx(shown.comparison.measures.area_compared, rel=1e-12)


def test_nothing_is_taken_away_without_a_region(sample: MainWindow):
    sample.regions.take.setChecked(True)
    sample.regions_of.draw(Tool.BRUSH, ((0.0, 0.0), (5.0, 5.0)))
    assert sample.workbench.document.regions == ()
    assert sample.banner.isVisible()


def test_a_region_takes_another_colour(lassoed: MainWindow, qtbot: QtBot):
    with qtbot.waitSignal(lassoed.workbench.compared, timeout=PATIENCE):
        lassoed.regions.colour.menu().actions()[2].trigger()
    assert lassoed.workbench.document.regions[0].colour == COLOURS[2]
    assert lassoed.actions_of.undo.text() == "&Undo colour of a region"


def test_a_stroke_of_the_brush_begins_a_new_region(lassoed: MainWindow, qtbot: QtBot):
    qtbot.mouseClick(lassoed.regions.new, LEFT)
    assert not lassoed.regions.remove.isEnabled()
    qtbot.mouseClick(lassoed.regions.brush, LEFT)
    with qtbot.waitSignal(lassoed.workbench.compared, timeout=PATIENCE):
        drag(qtbot, lassoed.grid.frames[2].canvas, (0.4, 0.3), (0.5, 0.3), (0.6, 0.3))
    assert len(lassoed.workbench.document.regions) == 2
    assert lassoed.regions.selected == 1


def test_regions_are_saved_and_loaded(lassoed: MainWindow, tmp_path: Path, qtbot: QtBot):
    path = tmp_path / "regions.json"
    lassoed.regions_of.save(path)
    regions = lassoed.workbench.document.regions
    with qtbot.waitSignal(lassoed.workbench.compared, timeout=PATIENCE):
        qtbot.mouseClick(lassoed.regions.remove, LEFT)
    assert lassoed.workbench.document.regions == ()
    with qtbot.waitSignal(lassoed.workbench.compared, timeout=PATIENCE):
        lassoed.regions_of.load(path)
    assert lassoed.workbench.document.regions == regions
    path.write_text(json.dumps([{"nonsense": 1}]))
    lassoed.regions_of.load(path)
    assert "regions.json" in lassoed.banner.label.text()


def test_best_fit_on_a_region_needs_one(lassoed: MainWindow, qtbot: QtBot):
    show(lassoed, "alignment")
    qtbot.mouseClick(lassoed.alignment.on_region, LEFT, pos=QPoint(8, 8))
    assert lassoed.alignment.on_region.isChecked()
    with qtbot.waitSignal(lassoed.workbench.compared, timeout=PATIENCE):
        qtbot.mouseClick(lassoed.alignment.fit, LEFT)
    assert lassoed.alignment.method.text().startswith("Moved: best fit (ICP) on a region")
    with qtbot.waitSignal(lassoed.workbench.compared, timeout=PATIENCE):
        lassoed.regions_of.remove(0)
    before = lassoed.workbench.document
    qtbot.mouseClick(lassoed.alignment.fit, LEFT)
    assert lassoed.workbench.document == before
    assert lassoed.banner.isVisible()
