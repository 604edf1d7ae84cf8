"""Each panel, used as a person would."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QScrollArea, QTabBar
from pytestqt.qtbot import QtBot

from app.model.tool import Tool
from app.model.view_state import Heatmap
from app.scene.distribution import distribution_of
from app.window import MainWindow
from tests.window.conftest import PATIENCE
from tests.window.hands import LEFT, drag, show


def test_a_range_is_brushed_in_the_histogram(sample: MainWindow, qtbot: QtBot):
    show(sample, "scale")
    drag(qtbot, sample.scale.histogram, (0.3, 0.5), (0.4, 0.5), (0.5, 0.5))
    brush = sample.display.state.brush
    assert brush is not None
    limit = sample.display.state.scale.limit
    assert -limit < brush[0] < brush[1] < limit
    comparison = sample.workbench.shown.comparison
    share = distribution_of(comparison.mean_signed, comparison.area).within(*brush)
    assert f"{100 * share:.1f} %" in sample.scale.beyond.text()
    drag(qtbot, sample.scale.histogram, (0.3, 0.5), (0.3, 0.5))
    assert sample.display.state.brush is None


def test_a_tolerance_is_dragged(sample: MainWindow, qtbot: QtBot):
    show(sample, "scale")
    histogram = sample.scale.histogram
    before = sample.workbench.document.options.tolerances
    x = histogram.to_screen(before[-1], 0.0).x() / histogram.width()
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        drag(qtbot, histogram, (x, 0.5), (x + 0.05, 0.5), (x + 0.1, 0.5))
    after = sample.workbench.document.options.tolerances
    assert after[:-1] == before[:-1]
    assert after[-1] > before[-1]
    measured = sample.workbench.shown.comparison.measures.within_tolerance
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
    model, table = sample.chains.model, sample.workbench.shown.content.chains
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
    qtbot.waitUntil(lambda: len(canvas.labels) == 1)
    item = sample.probes.tree.topLevelItem(0)
    z1, z2, d = (float(item.text(k).replace("−", "-")) for k in (3, 4, 5))
    assert d == pytest.approx(z1 - z2, abs=0.2)
    qtbot.mouseClick(sample.probes.remove, LEFT)
    assert sample.display.state.probes == ()


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


def test_options_compare_anew(sample: MainWindow, qtbot: QtBot):
    show(sample, "options")
    before = sample.workbench.shown.comparison
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        sample.options.domain.choices["plane"].trigger()
    after = sample.workbench.shown.comparison
    assert after.options.domain == "plane"
    assert after.measures.area_compared > before.measures.area_compared
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        sample.actions_of.undo.trigger()
    assert sample.workbench.shown.comparison.measures == before.measures


def test_the_exact_reading_stands_beside_the_nodal_one(sample: MainWindow, qtbot: QtBot):
    show(sample, "options")
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        sample.options.exact.click()
    assert sample.workbench.shown.comparison.measures.exact is not None
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
        assert sample.workbench.document.options.max_edge is None
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
    chains = next(dock for dock in window.docks.all if dock.objectName() == "chains")
    assert chains.titleBarWidget() is not None
    number = [tabs.tabText(k) for k in range(tabs.count())].index("Chains")
    start = tabs.tabRect(number).center()
    qtbot.mousePress(tabs, LEFT, pos=start)
    for step in range(1, 15):
        qtbot.mouseMove(tabs, start + QPoint(-20 * step, 15 * step), delay=5)
    qtbot.mouseRelease(tabs, LEFT, pos=start + QPoint(-300, 220))
    qtbot.waitUntil(lambda: chains.isFloating() and chains.titleBarWidget() is None)
    window.docks.arrange_as_at_first()
    qtbot.waitUntil(lambda: not chains.isFloating() and chains.titleBarWidget() is not None)


def test_the_arrangement_is_kept_over_restarts(window: MainWindow, qtbot: QtBot):
    scale, chains = (
        next(dock for dock in window.docks.all if dock.objectName() == name)
        for name in ("scale", "chains")
    )
    chains.toggleViewAction().trigger()
    window.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, scale)
    window.close()
    again = MainWindow()
    qtbot.addWidget(again)
    again.show()
    again.start()
    docks = {dock.objectName(): dock for dock in again.docks.all}
    assert again.dockWidgetArea(docks["scale"]) == Qt.DockWidgetArea.LeftDockWidgetArea
    assert docks["chains"].isHidden()
    qtbot.wait(100)
    assert docks["scale"].titleBarWidget() is None  # it stands alone there
    assert docks["section"].titleBarWidget() is not None
    docks["chains"].toggleViewAction().trigger()
    assert not docks["chains"].isHidden()


def test_no_panel_is_wider_than_its_dock(sample: MainWindow, qtbot: QtBot):
    sample.display.change(section=(-40.0, 0.0, 40.0, 5.0))
    for dock in sample.docks.all:
        dock.show()
        dock.raise_()
        qtbot.wait(20)
        scroll = dock.widget()
        assert isinstance(scroll, QScrollArea)
        assert scroll.widget().width() <= scroll.viewport().width(), dock.objectName()
