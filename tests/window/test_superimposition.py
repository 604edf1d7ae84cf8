"""Both scans in one scene, as a user turns, fades, cuts and measures them."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.model.superimposition import Cut
from app.views.both_scans import SuperimpositionView
from app.window import MainWindow
from tests.window.conftest import PATIENCE

LEFT, PLAIN = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier


def views() -> list[SuperimpositionView]:
    every = QApplication.topLevelWidgets()
    return [one for one in every if isinstance(one, SuperimpositionView) and one.isVisible()]


def opened(window: MainWindow, qtbot: QtBot) -> SuperimpositionView:
    window.superimposing.open()
    [view] = views()
    qtbot.waitExposed(view)
    qtbot.wait(100)
    return view


def pixels(image: QImage) -> NDArray[np.int64]:
    rgb = image.convertToFormat(QImage.Format.Format_RGB888)
    flat = np.frombuffer(rgb.constBits(), np.uint8).reshape(rgb.height(), rgb.bytesPerLine())
    return flat[:, : 3 * rgb.width()].astype(np.int64)


def test_without_surfaces_there_is_nothing_to_superimpose(window: MainWindow):
    window.superimposing.open()
    assert not views()
    assert window.banner.isVisible()


def test_one_fades_into_the_other_and_the_space_bar_swaps_them(sample: MainWindow, qtbot: QtBot):
    view, both = opened(sample, qtbot), sample.superimposing
    seen = pixels(view.picture())
    assert (abs(seen - seen[0, 0]).max(axis=1) > 30).mean() > 0.3  # there is something
    QTest.keyClick(view.interactor, Qt.Key.Key_Space)
    assert both.state.fade == 0.0
    one = pixels(view.picture())
    QTest.keyClick(view.interactor, Qt.Key.Key_Space)
    assert both.state.fade == 1.0
    two = pixels(view.picture())
    assert abs(one - two).max() > 30
    QTest.keyClick(view.interactor, Qt.Key.Key_Space)
    assert np.array_equal(pixels(view.picture()), one)


def test_the_panel_dresses_the_scans(sample: MainWindow, qtbot: QtBot):
    view, both = opened(sample, qtbot), sample.superimposing
    panel = both.panel
    panel.opacities[0].setValue(30)
    panel.heatmaps[1].click()
    assert both.state.coats[0].opacity == 0.3
    assert both.state.coats[1].heatmap
    assert not panel.before.isEnabled()
    before = pixels(view.picture())
    panel.sides["below"].click()
    assert abs(pixels(view.picture()) - before).max() > 30


def test_a_plane_cuts_both_and_tells_their_distance(sample: MainWindow, qtbot: QtBot):
    view, both = opened(sample, qtbot), sample.superimposing
    whole = pixels(view.picture())
    both.change(replace(both.state, cut=Cut(0, 0.7)))
    assert "on the cut at most" in both.reading
    cut = pixels(view.picture())
    width = cut.shape[1]
    assert np.array_equal(cut[:, -width // 8 :], whole[:, -width // 8 :])  # the ground
    assert abs(cut - whole).max() > 30


def test_what_is_under_the_pointer_is_told(sample: MainWindow, qtbot: QtBot):
    view, both = opened(sample, qtbot), sample.superimposing
    middle = view.interactor.rect().center()
    with qtbot.waitSignal(view.pointed, timeout=PATIENCE):
        QTest.mouseMove(view.interactor, middle)
    assert "along the view" in both.reading
    assert "nearest place of the other" in both.reading
    with qtbot.waitSignal(view.pointed, timeout=PATIENCE):
        QTest.mouseMove(view.interactor, QPoint(4, 4))
    assert both.reading == ""


def test_places_give_distances_and_an_angle(sample: MainWindow, qtbot: QtBot):
    view, both = opened(sample, qtbot), sample.superimposing
    middle = view.interactor.rect().center()
    QTest.mouseClick(view.interactor, LEFT, PLAIN, middle)
    assert both.places == []  # no ruler in hand
    both.measure(True)
    for step in (QPoint(-60, 0), QPoint(0, 40), QPoint(60, 0)):
        QTest.mouseClick(view.interactor, LEFT, PLAIN, middle + step)
    one, two, _ = both.places
    assert f"{math.dist(one, two):.3g}" in both.reading.replace("−", "-")
    assert "angle: " in both.reading
    QTest.mouseClick(view.interactor, LEFT, PLAIN, middle)
    assert len(both.places) == 1


def test_dragging_turns_and_measures_nothing(sample: MainWindow, qtbot: QtBot):
    view, both = opened(sample, qtbot), sample.superimposing
    both.measure(True)
    before = pixels(view.picture())
    middle = view.interactor.rect().center()
    QTest.mousePress(view.interactor, LEFT, PLAIN, middle)
    for k in range(1, 8):
        QTest.mouseMove(view.interactor, middle + QPoint(10 * k, 3 * k))
    QTest.mouseRelease(view.interactor, LEFT, PLAIN, middle + QPoint(70, 21))
    assert both.places == []
    assert abs(pixels(view.picture()) - before).max() > 30


@pytest.mark.timeout(300)
def test_fifty_times_opened_and_closed(sample: MainWindow, files: tuple[Path, Path], qtbot: QtBot):
    view = opened(sample, qtbot)
    for k in range(50):
        sample.superimposing.open()
        qtbot.wait(1)
        if k % 10 == 5:
            sample.opening.take(list(files) if k % 20 == 5 else [])  # also during a comparison
        view.close()
        assert not views()
        if k % 10 == 9:  # for good, and made anew
            sample.superimposing.close()
            view = opened(sample, qtbot)
    sample.superimposing.close()
    assert not views()


def test_a_picture_is_saved_whole_or_not_at_all(
    sample: MainWindow, qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    opened(sample, qtbot)
    for place, there in ((tmp_path / "both.png", True), (tmp_path / "no" / "both.png", False)):
        monkeypatch.setattr(sample.dialogs, "place", lambda *_a, p=place: (p, ""))
        sample.superimposing.save_picture()
        assert place.is_file() == there
        assert sample.banner.isVisible() != there
    assert not QImage(str(tmp_path / "both.png")).isNull()


def test_nothing_is_drawn_in_a_window_that_was_closed(sample: MainWindow, qtbot: QtBot):
    view, both = opened(sample, qtbot), sample.superimposing
    view.close()
    drawn: list[object] = []
    view.show_scene = drawn.append  # type: ignore[method-assign]
    sample.display.change(dark=not sample.display.state.dark)
    assert not drawn
    both.open()
    assert len(drawn) == 1
