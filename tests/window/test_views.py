"""What the views do under the mouse, on the map and in relief."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QImage
from pytestqt.qtbot import QtBot

from app.drawing.studio import Pictures
from app.model.tool import Tool
from app.model.view_state import Place, ViewState
from app.scene.camera import Camera, home
from app.scene.content import Content, content_of
from app.scene.pick import (
    corners_at,
    path_in_view,
    place_at,
    place_in_view,
    point_at,
    point_in_view,
)
from app.scene.profile import profile_of
from app.window import MainWindow
from surfcmp_core.comparing.comparison import Comparison
from tests.window.builders import comparison_of, hills
from tests.window.conftest import PATIENCE
from tests.window.hands import drag, show

LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton
TURNED = Camera().turned(0.3, -0.7)


@pytest.fixture(scope="module")
def apart() -> Content:
    """Give two surfaces, the second 30 mm above the first."""
    one, two = hills(400, 1), hills(300, 2)
    two[:, 2] += 30.0
    return content_of(comparison_of(one, two))


@pytest.mark.parametrize("view", range(4))
def test_a_place_is_drawn_where_it_was_picked(apart: Content, view: int):
    camera = replace(TURNED, height=150.0)
    found = 0
    for right, up in np.random.default_rng(0).uniform(-0.4, 0.4, (60, 2)).tolist():
        place = place_in_view(apart.geometry, camera, True, view, right, up)
        if place is None:
            continue
        point = point_at(apart, place, True, view)
        seen = camera.project(point[None])[0]
        found += np.allclose(seen[:2], (right, up), atol=0.01)
    assert found > 20


def test_surfaces_far_apart_have_labels_on_either(apart: Content):
    middle = place_in_view(apart.geometry, Camera(height=150.0), False, 0, 0.0, 0.0)
    assert middle is not None
    heights = [point_at(apart, middle, True, view)[2] for view in range(4)]
    assert heights[1] - heights[0] == pytest.approx(30.0, abs=8.0)
    assert heights[2] == heights[3]
    assert heights[2] == pytest.approx((heights[0] + heights[1]) / 2)
    assert (corners_at(apart, middle, False, 0)[:, 2] == 0).all()


def test_boxes_find_what_a_search_through_all_triangles_finds(small: Comparison):
    patch = content_of(small).geometry.patches[2]
    camera = home(content_of(small).geometry, 1.0, True).turned(0.2, -0.8)
    for right, up in np.random.default_rng(1).uniform(-0.5, 0.5, (200, 2)).tolist():
        slow = place_at(replace(patch, boxes=None), camera, True, right, up)
        assert place_at(patch, camera, True, right, up) == slow


@pytest.mark.parametrize("view", [0, 3])
def test_a_path_over_the_relief_lies_under_what_is_seen(apart: Content, view: int):
    camera = replace(TURNED, height=150.0)
    path = [(0.0, 0.0), (0.05, 0.02), (0.1, 0.03)]
    places = path_in_view(apart.geometry, camera, True, view, path)
    for (right, up), place in zip(path, places, strict=True):
        point = point_in_view(apart.geometry, camera, True, view, right, up)
        assert point is not None
        assert np.allclose(place, (point + apart.geometry.origin)[:2])


def test_a_path_beside_the_surface_keeps_its_level(apart: Content):
    camera = replace(TURNED, height=150.0)
    places = path_in_view(apart.geometry, camera, True, 0, [(0.0, 0.0), (3.0, 0.0)])
    assert len(places) == 2
    first = point_in_view(apart.geometry, camera, True, 0, 0.0, 0.0)
    assert first is not None
    beside = np.array([*(places[1] - apart.geometry.origin[:2]), first[2]])
    assert np.allclose(camera.project(beside[None])[0, :2], (3.0, 0.0))
    from_its_side = Camera(height=150.0).turned(0.0, -np.pi / 2)
    assert path_in_view(apart.geometry, from_its_side, True, 0, [(3.0, 3.0)]) == []


def test_on_the_map_a_path_is_where_it_is_drawn(apart: Content):
    camera = Camera(height=150.0)
    places = path_in_view(apart.geometry, camera, False, 0, [(0.1, -0.2), (7.0, 0.0)])
    assert np.allclose(places - apart.geometry.origin[:2], [(15.0, -30.0), (1050.0, 0.0)])


def test_the_right_button_turns_while_a_tool_is_in_hand(sample: MainWindow, qtbot: QtBot):
    canvas, start = sample.grid.frames[0].canvas, sample.display.camera
    qtbot.keyClick(sample, Qt.Key.Key_L)
    assert sample.display.tool is Tool.LASSO
    assert sample.display.state.relief
    centre = canvas.rect().center()
    qtbot.mousePress(canvas, RIGHT, pos=centre)
    qtbot.mouseMove(canvas, centre + QPoint(40, 10))
    qtbot.mouseRelease(canvas, RIGHT, pos=centre + QPoint(40, 10))
    assert sample.display.camera.back != start.back
    assert sample.workbench.document.regions == ()
    qtbot.keyClick(sample, Qt.Key.Key_V)


@pytest.mark.parametrize("relief", [True, False])
def test_a_section_follows_the_line_on_the_screen(sample: MainWindow, relief: bool, qtbot: QtBot):
    sample.display.change(relief=relief)
    show(sample, "section")
    qtbot.mouseClick(sample.section.line, LEFT)
    assert sample.display.state.relief == relief
    canvas = sample.grid.frames[1].canvas
    drag(qtbot, canvas, (0.4, 0.5), (0.5, 0.5), (0.6, 0.55))
    section = sample.display.state.section
    assert section is not None
    content = sample.display.content
    assert content is not None
    for x, y, corner in ((*section[:2], (0.4, 0.5)), (*section[2:], (0.6, 0.55))):
        above = Camera(focus=(x - content.geometry.origin[0], y - content.geometry.origin[1], 0.0))
        place = place_at(content.geometry.patches[2], above, False, 0.0, 0.0)
        assert isinstance(place, Place)
        point = point_at(content, place, relief, 1)
        right, up, _ = sample.display.camera.project(point[None])[0]
        at = canvas.position(right, up)
        assert at.x() == pytest.approx(corner[0] * canvas.width(), abs=3)
        assert at.y() == pytest.approx(corner[1] * canvas.height(), abs=3)


def test_a_brush_paints_the_relief(sample: MainWindow, qtbot: QtBot):
    show(sample, "regions")
    qtbot.mouseClick(sample.regions.brush, LEFT)
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        drag(qtbot, sample.grid.frames[0].canvas, (0.45, 0.4), (0.5, 0.4), (0.55, 0.4))
    assert sample.display.state.relief
    first, *_ = sample.workbench.shown.regions
    assert first.measures is not None
    assert first.triangles > 20


def test_chosen_chains_are_flown_to(sample: MainWindow, qtbot: QtBot):
    display, start = sample.display, sample.display.camera
    cameras: list[Camera] = []
    display.shown.connect(lambda pictures: cameras.append(pictures.wish.camera))
    display.look_from_above()
    assert display.camera.back == (0.0, 0.0, 1.0)
    qtbot.waitUntil(lambda: bool(cameras) and cameras[-1] == display.camera, timeout=PATIENCE)
    between = [camera for camera in cameras if camera not in {start, display.camera}]
    assert between
    assert all(start.back[2] < camera.back[2] < 1.0 for camera in between)
    qtbot.waitUntil(lambda: display.seen == display.camera, timeout=PATIENCE)


def test_the_hand_ends_a_flight(sample: MainWindow, qtbot: QtBot):
    display, start = sample.display, sample.display.camera
    display.look_from_above()
    sample.grid.frames[0].canvas.panned.emit(0.1, 0.0)
    qtbot.wait(400)
    assert display.camera.back == start.back
    assert display.camera.focus != start.focus


def test_where_pictures_come_slowly_the_camera_jumps(sample: MainWindow, monkeypatch):
    monkeypatch.setattr("app.controllers.display.SLOW_SECONDS", -1.0)
    sample.display.look_from_above()
    assert not sample.display.flying
    assert sample.display.camera.back == (0.0, 0.0, 1.0)


def test_views_are_printed_as_finely_as_asked(sample: MainWindow, tmp_path: Path, qtbot: QtBot):
    frame = sample.grid.frames[0]
    qtbot.waitUntil(lambda: frame.canvas.image is not None)
    sizes, path = [], tmp_path / "views.png"
    width, height = frame.canvas.pixels()
    whole = sample.grid.devicePixelRatioF() * sample.grid.width()

    def use() -> None:
        sizes.append((frame.canvas.image.width(), frame.canvas.image.height()))
        sample.exporting.write_views(path, 3)

    sample.display.print(3, use)
    qtbot.waitUntil(lambda: bool(sizes), timeout=PATIENCE)
    assert sizes == [(3 * width, 3 * height)]
    assert frame.canvas.image.width() == width
    assert QImage(str(path)).width() == round(3 * whole)


def test_a_section_looks_only_at_triangles_near_its_line(apart: Content):
    for line in ((-45.0, -30.0, 45.0, 35.0), (0.0, -49.0, 0.0, 49.0), (-20.0, 10.0, 30.0, 10.0)):
        whole = profile_of(apart.comparison, line)
        near = profile_of(apart.comparison, line, apart.geometry)
        assert np.array_equal(near.along, whole.along)
        assert np.array_equal(near.z1, whole.z1, equal_nan=True)


def test_the_brush_shows_its_size(sample: MainWindow, qtbot: QtBot):
    canvas = sample.grid.frames[0].canvas
    before = canvas.grab().toImage()
    qtbot.keyClick(sample, Qt.Key.Key_B)
    qtbot.mouseMove(canvas, canvas.rect().center())
    qtbot.waitUntil(lambda: canvas.hover is not None)
    assert canvas.grab().toImage() != before
    qtbot.keyClick(sample, Qt.Key.Key_V)
    assert canvas.hover is None


def test_a_flight_goes_on_where_the_size_changes(sample: MainWindow, qtbot: QtBot):
    display = sample.display
    display.look_from_above()
    qtbot.wait(60)
    sample.resize(sample.width() + 40, sample.height())
    qtbot.waitUntil(lambda: display.seen.back == (0.0, 0.0, 1.0), timeout=PATIENCE)


def test_large_surfaces_are_sketched_before_they_are_drawn(
    window: MainWindow,
    files: tuple[Path, Path],
    monkeypatch: pytest.MonkeyPatch,
    qtbot: QtBot,
):
    monkeypatch.setattr("app.scene.coarse.NODES", 20)  # these are large, then
    monkeypatch.setattr("app.drawing.studio.AFFORDABLE_SECONDS", 0.0)
    pictures: list[Pictures] = []
    window.display.shown.connect(pictures.append)
    window.opening.begin(list(files))
    qtbot.waitUntil(lambda: bool(pictures) and pictures[-1].final, timeout=PATIENCE)
    assert all(patch.coarse for patch in window.display.content.geometry.patches)
    while pictures:  # until panels that filled have their place, and views their last size
        pictures.clear()
        qtbot.wait(400)
    window.display.change(scale=replace(window.display.state.scale, limit=0.7))
    qtbot.waitUntil(lambda: bool(pictures) and pictures[-1].final, timeout=PATIENCE)
    assert [list(found.images) for found in pictures[:2]] == [[3], [3]]  # no other view changed
    assert not pictures[0].final
    window.display.change(edges=False)
    qtbot.waitUntil(lambda: {0, 1, 2, 3} <= seen_in(pictures), timeout=PATIENCE)


def seen_in(pictures: list[Pictures]) -> set[int]:
    return {view for found in pictures for view in found.images}


def test_drawing_is_given_up_where_something_else_is_wanted(apart: Content):
    from app.drawing.renderer import Renderer, Tile
    from app.scene.scene import VIEWS, scene_of

    renderer = Renderer(VIEWS)
    renderer.apply(scene_of(apart, ViewState()))
    camera, tiles = home(apart.geometry, 1.0, True), [Tile(3, 80, 60), Tile(0, 80, 60)]
    assert renderer.draw(camera, tiles, True, give_up=lambda: True) == {}
    images = renderer.draw(camera, tiles, True, give_up=lambda: False)
    assert [images[view].shape for view in (3, 0)] == [(60, 80, 4)] * 2
    assert len(np.unique(images[3].reshape(-1, 4), axis=0)) > 20
    renderer.close()
