"""Each panel, used as a person would."""

import json
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QScrollArea, QTabBar, QToolButton, QWidget
from pytestqt.qtbot import QtBot

from app.model.document import NOT_MOVED
from app.model.tool import Tool
from app.model.view_state import Heatmap
from app.panels.regions_panel import COLOURS
from app.scene.distribution import distribution_of
from app.window import MainWindow
from tests.window.conftest import PATIENCE

LEFT = Qt.MouseButton.LeftButton


def drag(qtbot: QtBot, widget: QWidget, *places: tuple[float, float]) -> None:
    """Drag over a widget; places in shares of its width and height."""
    points = [QPoint(round(x * widget.width()), round(y * widget.height())) for x, y in places]
    qtbot.mousePress(widget, LEFT, pos=points[0])
    for point in points[1:]:
        qtbot.mouseMove(widget, point)
    qtbot.mouseRelease(widget, LEFT, pos=points[-1])


def show(window: MainWindow, name: str) -> None:
    dock = next(dock for dock in window.docks if dock.objectName() == name)
    dock.show()
    dock.raise_()


@pytest.fixture
def lassoed(sample: MainWindow, qtbot: QtBot) -> MainWindow:
    """Give the sample with a region drawn over the relief."""
    show(sample, "regions")
    qtbot.mouseClick(sample.regions.lasso, LEFT)
    assert sample.display.tool is Tool.LASSO
    with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
        drag(qtbot, sample.grid.frames[3].canvas, (0.4, 0.4), (0.7, 0.4), (0.7, 0.7), (0.4, 0.7))
    return sample


def test_a_range_is_brushed_in_the_histogram(sample: MainWindow, qtbot: QtBot):
    show(sample, "scale")
    drag(qtbot, sample.scale.histogram, (0.3, 0.5), (0.4, 0.5), (0.5, 0.5))
    brush = sample.display.state.brush
    assert brush is not None
    limit = sample.display.state.scale.limit
    assert -limit < brush[0] < brush[1] < limit
    comparison = sample.session.shown.comparison
    share = distribution_of(comparison.mean_signed, comparison.area).within(*brush)
    assert f"{100 * share:.1f} %" in sample.scale.beyond.text()
    drag(qtbot, sample.scale.histogram, (0.3, 0.5), (0.3, 0.5))
    assert sample.display.state.brush is None


def test_a_tolerance_is_dragged(sample: MainWindow, qtbot: QtBot):
    show(sample, "scale")
    histogram = sample.scale.histogram
    before = sample.session.document.options.tolerances
    x = histogram.to_screen(before[-1], 0.0).x() / histogram.width()
    with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
        drag(qtbot, histogram, (x, 0.5), (x + 0.05, 0.5), (x + 0.1, 0.5))
    after = sample.session.document.options.tolerances
    assert after[:-1] == before[:-1]
    assert after[-1] > before[-1]
    measured = sample.session.shown.comparison.measures.within_tolerance
    assert list(measured) == [f"{tolerance:g}" for tolerance in after]
    assert sample.measures.value(f"≤ {after[-1]:g} mm")


def test_absolute_differences_have_a_scale_from_zero(sample: MainWindow):
    sample.toolbar.heatmap.choices[Heatmap.ABSOLUTE].trigger()
    assert sample.scale.histogram.x_at(sample.scale.histogram.area.topLeft()) == 0.0


def test_a_chain_is_flown_to(sample: MainWindow, qtbot: QtBot):
    show(sample, "chains")
    table, model = sample.chains.table, sample.chains.model
    rows = [model.data(model.index(row, 2)) for row in range(5)]
    assert [int(row) for row in rows] == sorted(map(int, rows), reverse=True)
    before = sample.display.camera
    place = table.visualRect(model.index(3, 0)).center()
    qtbot.mouseClick(table.viewport(), LEFT, pos=place)
    assert sample.display.state.chain == model.chain(3)
    assert sample.display.camera != before
    qtbot.keyClick(sample, Qt.Key.Key_Escape)
    assert sample.display.state.chain is None


def test_chains_are_sorted_by_any_column(sample: MainWindow, qtbot: QtBot):
    show(sample, "chains")
    model, table = sample.chains.model, sample.session.shown.content.chains
    for column, values in ((3, table.area), (4, table.mean_abs), (5, table.share)):
        model.sort(column, Qt.SortOrder.DescendingOrder)
        order = [model.chain(row) for row in range(model.rowCount())]
        known = values[order][np.isfinite(values[order])]
        assert (np.diff(known) <= 0).all()
        assert sorted(order) == list(range(len(order)))


def test_a_label_stays_until_it_is_removed(sample: MainWindow, qtbot: QtBot):
    show(sample, "probes")
    canvas = sample.grid.frames[0].canvas
    qtbot.mouseClick(canvas, LEFT, pos=canvas.rect().center())
    assert sample.probes.tree.topLevelItemCount() == 1
    qtbot.mouseClick(sample.probes.keep, LEFT)
    assert len(sample.display.state.probes) == 1
    qtbot.waitUntil(lambda: len(canvas._labels) == 1)
    item = sample.probes.tree.topLevelItem(0)
    z1, z2, d = (float(item.text(k).replace("−", "-")) for k in (3, 4, 5))
    assert d == pytest.approx(z1 - z2, abs=0.2)
    qtbot.mouseClick(sample.probes.remove, LEFT)
    assert sample.display.state.probes == ()


def test_a_region_is_drawn_named_weighed_and_undone(lassoed: MainWindow, qtbot: QtBot):
    panel, session = lassoed.regions, lassoed.session
    assert panel.tree.topLevelItemCount() == 3
    whole = session.shown.comparison.measures.area_compared
    parts = [part.measures.area_compared for part in session.shown.regions]
    assert sum(parts) == pytest.approx(whole)
    item = panel.tree.topLevelItem(0)
    with qtbot.waitSignal(session.compared, timeout=PATIENCE):
        item.setText(0, "cheek")
    with qtbot.waitSignal(session.compared, timeout=PATIENCE):
        panel.tree.topLevelItem(0).setText(1, "2.5")
    region = session.document.regions[0]
    assert (region.name, region.weight) == ("cheek", 2.5)
    shown = session.shown.content.comparison.measures
    assert shown.rho_V_mu > shown.rho_V
    assert lassoed.measures.value("rho_V_mu") != lassoed.measures.value("rho_V")
    panel.tree.topLevelItem(0).setText(1, "none")
    assert session.document.regions[0].weight == 2.5
    for _ in range(3):
        with qtbot.waitSignal(session.compared, timeout=PATIENCE):
            lassoed.actions_of.undo.trigger()
    assert session.document.regions == ()
    assert panel.tree.topLevelItemCount() == 0


def test_a_brush_adds_to_the_selected_region(lassoed: MainWindow, qtbot: QtBot):
    qtbot.mouseClick(lassoed.regions.brush, LEFT)
    with qtbot.waitSignal(lassoed.session.compared, timeout=PATIENCE):
        drag(qtbot, lassoed.grid.frames[2].canvas, (0.4, 0.3), (0.5, 0.3), (0.6, 0.3))
    (region,) = lassoed.session.document.regions
    lasso, brush = region.strokes
    assert (lasso.radius, brush.radius) == (0.0, lassoed.regions.radius.value)
    assert len(brush.path) > 2


def taken_away(window: MainWindow, qtbot: QtBot, key: Qt.KeyboardModifier) -> float:
    """Drag the brush through the selected region; return how much of its area is left."""
    area = window.session.shown.regions[0].measures.area_compared
    canvas = window.grid.frames[3].canvas
    places = [QPoint(round(x * canvas.width()), canvas.height() // 2) for x in (0.5, 0.55, 0.6)]
    with qtbot.waitSignal(window.session.compared, timeout=PATIENCE):
        qtbot.mousePress(canvas, LEFT, key, places[0])
        for place in places[1:]:
            qtbot.mouseMove(canvas, place)
        qtbot.mouseRelease(canvas, LEFT, key, places[-1])
    return window.session.shown.regions[0].measures.area_compared / area


def test_a_brush_takes_away_from_the_selected_region(lassoed: MainWindow, qtbot: QtBot):
    qtbot.mouseClick(lassoed.regions.brush, LEFT)
    assert 0.3 < taken_away(lassoed, qtbot, Qt.KeyboardModifier.ShiftModifier) < 0.95
    with qtbot.waitSignal(lassoed.session.compared, timeout=PATIENCE):
        lassoed.actions_of.undo.trigger()
    qtbot.mouseClick(lassoed.regions.take, LEFT)
    assert 0.3 < taken_away(lassoed, qtbot, Qt.KeyboardModifier.NoModifier) < 0.95
    assert [stroke.takes for stroke in lassoed.session.document.regions[0].strokes] == [False, True]
    shown = lassoed.session.shown
    parts = [part.measures.area_compared for part in shown.regions]
    assert sum(parts) == pytest.approx(shown.comparison.measures.area_compared, rel=1e-12)


def test_nothing_is_taken_away_without_a_region(sample: MainWindow):
    sample.regions.take.setChecked(True)
    sample.regions_of.draw(Tool.BRUSH, ((0.0, 0.0), (5.0, 5.0)))
    assert sample.session.document.regions == ()
    assert sample.banner.isVisible()


def test_a_region_takes_another_colour(lassoed: MainWindow, qtbot: QtBot):
    with qtbot.waitSignal(lassoed.session.compared, timeout=PATIENCE):
        lassoed.regions.colour.menu().actions()[2].trigger()
    assert lassoed.session.document.regions[0].colour == COLOURS[2]
    assert lassoed.actions_of.undo.text() == "&Undo colour of a region"


def test_a_stroke_of_the_brush_begins_a_new_region(lassoed: MainWindow, qtbot: QtBot):
    qtbot.mouseClick(lassoed.regions.new, LEFT)
    assert not lassoed.regions.remove.isEnabled()
    qtbot.mouseClick(lassoed.regions.brush, LEFT)
    with qtbot.waitSignal(lassoed.session.compared, timeout=PATIENCE):
        drag(qtbot, lassoed.grid.frames[2].canvas, (0.4, 0.3), (0.5, 0.3), (0.6, 0.3))
    assert len(lassoed.session.document.regions) == 2
    assert lassoed.regions.selected == 1


def test_regions_are_saved_and_loaded(lassoed: MainWindow, tmp_path: Path, qtbot: QtBot):
    path = tmp_path / "regions.json"
    lassoed.regions_of.save(path)
    regions = lassoed.session.document.regions
    with qtbot.waitSignal(lassoed.session.compared, timeout=PATIENCE):
        qtbot.mouseClick(lassoed.regions.remove, LEFT)
    assert lassoed.session.document.regions == ()
    with qtbot.waitSignal(lassoed.session.compared, timeout=PATIENCE):
        lassoed.regions_of.load(path)
    assert lassoed.session.document.regions == regions
    path.write_text(json.dumps([{"nonsense": 1}]))
    lassoed.regions_of.load(path)
    assert "regions.json" in lassoed.banner.label.text()


def test_a_section_is_drawn(sample: MainWindow, qtbot: QtBot):
    show(sample, "section")
    qtbot.mouseClick(sample.section.line, LEFT)
    assert sample.display.tool is Tool.SECTION
    drag(qtbot, sample.grid.frames[0].canvas, (0.35, 0.5), (0.5, 0.5), (0.65, 0.5))
    assert sample.display.state.section is not None
    assert sample.section.heights.isVisible()
    qtbot.mouseClick(sample.section.copy, LEFT)
    rows = QGuiApplication.clipboard().text().splitlines()
    assert rows[0].startswith("distance (mm)")
    values = np.array([[float(word) for word in row.split("\t")] for row in rows[1:]])
    assert len(values) > 20
    known = np.isfinite(values).all(axis=1)
    assert np.allclose(values[known, 3], values[known, 1] - values[known, 2])
    qtbot.mouseClick(sample.section.line, LEFT)
    assert sample.display.tool is Tool.LOOK


def test_a_nudge_is_a_motion_and_undone(sample: MainWindow, qtbot: QtBot):
    show(sample, "alignment")
    before = sample.session.shown.comparison.measures.mean_signed
    with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
        sample.alignment.nudged.emit("z", 1.5)
    motion = sample.session.document.motion
    assert motion.matrix[2][3] == 1.5
    after = sample.session.shown.comparison.measures.mean_signed
    assert after == pytest.approx(before - 1.5, abs=1e-6)
    assert sample.session.shown.record["options"]["align"]["method"] == "by hand"
    assert "by hand" in sample.alignment.method.text()
    with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
        qtbot.mouseClick(sample.alignment.reset, LEFT)
    assert sample.session.shown.comparison.measures.mean_signed == before


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
        with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
            qtbot.mouseClick(buttons[text], LEFT)
        assert sample.session.document.motion.matrix[row][column] == pytest.approx(value)
        assert sample.actions_of.undo.text() == "&Undo alignment"
        with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
            sample.actions_of.undo.trigger()
    assert sample.session.document.motion == NOT_MOVED


def test_best_fit_on_a_region_needs_one(lassoed: MainWindow, qtbot: QtBot):
    show(lassoed, "alignment")
    qtbot.mouseClick(lassoed.alignment.on_region, LEFT, pos=QPoint(8, 8))
    assert lassoed.alignment.on_region.isChecked()
    with qtbot.waitSignal(lassoed.session.compared, timeout=PATIENCE):
        qtbot.mouseClick(lassoed.alignment.fit, LEFT)
    assert lassoed.alignment.method.text().startswith("Moved: best fit (ICP) on a region")
    with qtbot.waitSignal(lassoed.session.compared, timeout=PATIENCE):
        lassoed.regions_of.remove(0)
    before = lassoed.session.document
    qtbot.mouseClick(lassoed.alignment.fit, LEFT)
    assert lassoed.session.document == before
    assert lassoed.banner.isVisible()


def test_best_fit_takes_a_shift_back(sample: MainWindow, qtbot: QtBot):
    show(sample, "alignment")
    for axis, step in (("x", 2.0), ("rz", 1.5)):
        with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
            sample.alignment.nudged.emit(axis, step)
    off = sample.session.shown.comparison.measures.mean_abs
    with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
        qtbot.mouseClick(sample.alignment.fit, LEFT)
    fitted = sample.session.shown.comparison.measures.mean_abs
    assert fitted < off / 2
    assert "ICP" in sample.alignment.method.text()
    assert sample.session.document.motion.residual is not None


def test_landmarks_move_surface_2(sample: MainWindow, qtbot: QtBot):
    show(sample, "alignment")
    with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
        sample.alignment.nudged.emit("y", 3.0)
    sample.display.change(relief=False)
    qtbot.mouseClick(sample.alignment.pick, LEFT)
    for x, y in ((0.42, 0.4), (0.58, 0.4), (0.5, 0.75), (0.5, 0.3)):
        for view in (0, 1):
            canvas = sample.grid.frames[view].canvas
            place = QPoint(round(x * canvas.width()), round(y * canvas.height()))
            qtbot.mouseClick(canvas, LEFT, pos=place)
    assert len(sample.alignment_of.pairs) == 4
    texts = [[label.text for label in frame.canvas._labels] for frame in sample.grid.frames]
    assert texts == [["1", "2", "3", "4"], ["1", "2", "3", "4"], [], []]
    first = sample.grid.frames[0].canvas
    assert first._position(first._labels[2].right, first._labels[2].up).x() == pytest.approx(
        0.5 * first.width(), abs=2
    )
    assert sample.display.state.picked is None
    with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
        qtbot.mouseClick(sample.alignment.use, LEFT)
    # the same places of the plane were clicked, so that only heights could move it
    assert sample.session.document.motion.method == "landmarks"
    qtbot.mouseClick(sample.alignment.clear, LEFT)
    assert not sample.alignment.use.isEnabled()


def test_too_few_landmarks_cannot_be_used(sample: MainWindow):
    assert not sample.alignment.use.isEnabled()
    sample.alignment_of.fit_landmarks()
    assert sample.banner.isVisible()


def test_options_compare_anew(sample: MainWindow, qtbot: QtBot):
    show(sample, "options")
    before = sample.session.shown.comparison
    with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
        sample.options.domain.choices["plane"].trigger()
    after = sample.session.shown.comparison
    assert after.options.domain == "plane"
    assert after.measures.area_compared > before.measures.area_compared
    with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
        sample.actions_of.undo.trigger()
    assert sample.session.shown.comparison.measures == before.measures


def test_the_exact_reading_stands_beside_the_nodal_one(sample: MainWindow, qtbot: QtBot):
    show(sample, "options")
    with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
        sample.options.exact.click()
    assert sample.session.shown.comparison.measures.exact is not None
    groups = {
        sample.measures.tree.topLevelItem(k).text(0)
        for k in range(sample.measures.tree.topLevelItemCount())
    }
    assert {"Difference", "Difference, exact"} <= groups


def test_a_wrong_longest_side_changes_nothing(sample: MainWindow, qtbot: QtBot):
    show(sample, "options")
    box = sample.options.max_edge
    for text in ("abc", "-3", "0"):
        box.setFocus()
        box.setText("")
        qtbot.keyClicks(box, text)
        qtbot.keyClick(box, Qt.Key.Key_Return)
        assert sample.session.document.options.max_edge is None
        assert box.text() == ""


def test_keys_turn_move_and_zoom(sample: MainWindow, qtbot: QtBot):
    sample.grid.setFocus()
    start = sample.display.camera
    qtbot.keyClick(sample.grid, Qt.Key.Key_Left)
    turned = sample.display.camera
    assert turned.back != start.back
    qtbot.keyClick(sample.grid, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    assert sample.display.camera.focus != turned.focus
    qtbot.keyClick(sample.grid, Qt.Key.Key_Plus)
    assert sample.display.camera.height < start.height


def test_every_control_has_a_name(sample: MainWindow):
    from PySide6.QtWidgets import QAbstractButton, QAbstractItemView, QLineEdit

    nameless = [
        widget
        for kind in (QAbstractButton, QLineEdit, QAbstractItemView)
        for widget in sample.findChildren(kind)
        if not widget.objectName().startswith("qt_")
        and not widget.accessibleName()
        and not getattr(widget, "text", str)()
        and not isinstance(widget.parent(), QAbstractItemView)
        and type(widget).__name__ not in {"QToolBarExtension", "QHeaderView", "QToolButton"}
    ]
    assert nameless == []


def test_a_panel_is_dragged_out_by_its_tab_and_put_back(window: MainWindow, qtbot: QtBot):
    tabs = next(
        bar
        for bar in window.findChildren(QTabBar)
        if bar.isVisible() and "Chains" in [bar.tabText(k) for k in range(bar.count())]
    )
    chains = next(dock for dock in window.docks if dock.objectName() == "chains")
    assert chains.titleBarWidget() is not None
    number = [tabs.tabText(k) for k in range(tabs.count())].index("Chains")
    start = tabs.tabRect(number).center()
    qtbot.mousePress(tabs, LEFT, pos=start)
    for step in range(1, 15):
        qtbot.mouseMove(tabs, start + QPoint(-20 * step, 15 * step), delay=5)
    qtbot.mouseRelease(tabs, LEFT, pos=start + QPoint(-300, 220))
    qtbot.waitUntil(lambda: chains.isFloating() and chains.titleBarWidget() is None)
    window.arrange_as_at_first()
    qtbot.waitUntil(lambda: not chains.isFloating() and chains.titleBarWidget() is not None)


def test_the_arrangement_is_kept_over_restarts(window: MainWindow, qtbot: QtBot):
    scale, chains = (
        next(dock for dock in window.docks if dock.objectName() == name)
        for name in ("scale", "chains")
    )
    chains.toggleViewAction().trigger()
    window.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, scale)
    window.close()
    again = MainWindow()
    qtbot.addWidget(again)
    again.show()
    again.start()
    docks = {dock.objectName(): dock for dock in again.docks}
    assert again.dockWidgetArea(docks["scale"]) == Qt.DockWidgetArea.LeftDockWidgetArea
    assert docks["chains"].isHidden()
    qtbot.wait(100)
    assert docks["scale"].titleBarWidget() is None  # it stands alone there
    assert docks["section"].titleBarWidget() is not None
    docks["chains"].toggleViewAction().trigger()
    assert not docks["chains"].isHidden()


def test_no_panel_is_wider_than_its_dock(sample: MainWindow, qtbot: QtBot):
    sample.display.change(section=(-40.0, 0.0, 40.0, 5.0))
    for dock in sample.docks:
        dock.show()
        dock.raise_()
        qtbot.wait(20)
        scroll = dock.widget()
        assert isinstance(scroll, QScrollArea)
        assert scroll.widget().width() <= scroll.viewport().width(), dock.objectName()
