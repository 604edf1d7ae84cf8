"""The camera's motions and what lies under the pointer."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.scene.camera import Camera, between, home, showing
from app.scene.geometry import geometry_of
from app.scene.pick import place_at
from surfcmp_core.comparing.comparison import Comparison

small_number = st.floats(-0.9, 0.9)
angle = st.floats(-3.0, 3.0)


@given(angle, angle, angle, angle)
def test_turning_keeps_the_axes_at_right_angles(a: float, b: float, c: float, d: float):
    camera = Camera().turned(a, b).turned(c, d)
    axes = np.stack([camera.right, camera.up, camera.back])
    assert np.allclose(axes @ axes.T, np.eye(3), atol=1e-9)


@given(angle, angle, angle, angle, st.floats(0, 1))
def test_between_two_cameras_the_axes_stay_at_right_angles(
    a: float, b: float, c: float, d: float, share: float
):
    one = Camera(height=2.0).turned(a, b)
    two = Camera(focus=(1.0, 2.0, 3.0), height=8.0).turned(c, d)
    for camera, end in ((between(one, two, 0.0), one), (between(one, two, 1.0), two)):
        assert np.allclose(camera.back, end.back, atol=1e-6)
        assert np.allclose(camera.up, end.up, atol=1e-6)
        assert np.allclose(camera.focus, end.focus)
        assert camera.height == pytest.approx(end.height)
    camera = between(one, two, share)
    axes = np.stack([camera.right, camera.up, camera.back])
    assert np.allclose(axes @ axes.T, np.eye(3), atol=1e-6)


@given(st.floats(0.2, 5.0), small_number, small_number)
def test_zooming_keeps_the_place_under_the_pointer(factor: float, right: float, up: float):
    camera = Camera(focus=(1.0, 2.0, 3.0), height=40.0).turned(0.4, -0.2)
    place = np.array(camera.focus) + camera.height * (
        right * camera.right + up * np.array(camera.up)
    )
    seen = camera.zoomed(factor, right, up).project(place[None])[0]
    assert np.allclose(seen[:2], (right, up), atol=1e-9)
    assert camera.zoomed(factor).height == pytest.approx(40.0 / factor)


def test_panning_moves_the_picture_with_the_hand():
    seen = Camera(height=10.0).panned(0.25, -0.1).project(np.zeros((1, 3)))[0]
    assert np.allclose(seen[:2], (0.25, -0.1))


def test_turning_to_the_right_moves_the_front_to_the_right():
    front = np.array([[0.0, 0.0, 1.0]])
    assert Camera().turned(0.3, 0.0).project(front)[0, 0] > 0
    assert Camera().turned(0.0, 0.3).project(front)[0, 1] > 0


@pytest.mark.parametrize("aspect", [0.5, 1.0, 2.5])
@pytest.mark.parametrize("relief", [True, False])
def test_home_shows_everything(small: Comparison, aspect: float, relief: bool):
    geometry = geometry_of(small)
    camera = home(geometry, aspect, relief)
    for patch in geometry.patches[:2]:
        nodes = patch.points.astype(float)
        if not relief:
            nodes[:, 2] = 0.0
        seen = np.abs(camera.project(nodes)).max(axis=0)
        assert seen[0] <= aspect / 2
        assert seen[1] <= 0.5


def test_showing_a_box_puts_it_in_the_middle():
    low, high = np.array([1.0, 2.0, 0.0]), np.array([3.0, 8.0, 0.0])
    camera = showing(low, high, 1.0)
    assert camera.focus == (2.0, 5.0, 0.0)
    assert 6.0 < camera.height < 7.0


@pytest.mark.parametrize("relief", [True, False])
def test_the_triangle_under_its_own_middle_is_found(small: Comparison, relief: bool):
    patch = geometry_of(small).patches[2]
    camera = home(geometry_of(small), 1.0, False)  # from above nothing hides anything
    nodes = patch.points.astype(float)
    middles = camera.project(nodes[patch.triangles].mean(axis=1))
    for t in range(0, len(patch.triangles), 7):
        assert place_at(patch, camera, relief, *middles[t, :2]).triangle == t


def test_beside_the_surface_there_is_nothing(small: Comparison):
    geometry = geometry_of(small)
    assert place_at(geometry.patches[2], home(geometry, 1.0, False), False, 2.0, 2.0) is None


def test_what_is_nearer_is_picked():
    from app.scene.geometry import Patch

    points = np.array(
        [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 5], [1, 0, 5], [0, 1, 5]], dtype=np.float32
    )
    triangles = np.array([[3, 4, 5], [0, 1, 2]], dtype=np.int32)
    patch = Patch(points, np.zeros_like(points), triangles, 1.0)
    assert place_at(patch, Camera(height=4.0), True, 0.05, 0.05).triangle == 0
