"""The frame along a direction."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from surfcmp_core.errors import InputError
from surfcmp_core.projection import direction_of_landmarks, frame, moved
from surfcmp_core.surface import Surface

directions = arrays(np.float64, 3, elements=st.floats(-1e6, 1e6)).filter(
    lambda d: np.abs(d).max() > 1e-6
)


@given(directions)
def test_frame_is_a_rotation_that_turns_the_direction_to_z(direction):
    matrix = frame(direction)
    turn = matrix[:3, :3]
    unit = direction / np.linalg.norm(direction)
    np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-14)
    assert np.linalg.det(turn) == pytest.approx(1.0)
    np.testing.assert_allclose(turn @ unit, [0.0, 0.0, 1.0], atol=1e-14)
    np.testing.assert_allclose(turn[2], unit, atol=1e-15)
    np.testing.assert_array_equal(matrix[3], [0, 0, 0, 1])
    np.testing.assert_array_equal(matrix[:3, 3], 0)


@pytest.mark.parametrize("tiny", [1e-3, 1e-8, 1e-12, 1e-160])
def test_frame_near_minus_z_stays_a_rotation(tiny):
    turn = frame([tiny, -2 * tiny, -1.0])[:3, :3]
    np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-14)
    assert np.linalg.det(turn) == pytest.approx(1.0)


def test_frame_of_z_is_exactly_the_identity():
    np.testing.assert_array_equal(frame([0.0, 0.0, 7.0]), np.eye(4))
    np.testing.assert_array_equal(frame([0.0, -0.0, -1.0]), np.diag([1.0, -1.0, -1.0, 1.0]))


@pytest.mark.parametrize("bad", [[0, 0, 0], [np.nan, 0, 1], [np.inf, 0, 1], [1, 2]])
def test_frame_refuses_what_is_no_direction(bad):
    with pytest.raises(InputError, match="not a viewing direction"):
        frame(bad)


def test_moved_by_the_identity_is_the_very_same():
    surface = Surface(np.array([[-0.0, 1e-300, 1e300]]))
    assert moved(surface, np.eye(4)) is surface


def test_moved_turns_then_shifts():
    matrix = frame([1.0, 0.0, 0.0])
    matrix[:3, 3] = 1.0, 2.0, 3.0
    surface = moved(Surface(np.array([[5.0, 0.0, 0.0]]), name="a"), matrix)
    np.testing.assert_allclose(surface.points, [[1.0, 2.0, 8.0]], atol=1e-15)
    assert surface.name == "a"


def test_landmarks_seen_counter_clockwise_face_the_viewer():
    np.testing.assert_array_equal(
        direction_of_landmarks([[0, 0, 1], [2, 0, 1], [0, 3, 1]]), [0.0, 0.0, 1.0]
    )
    np.testing.assert_array_equal(
        direction_of_landmarks([[2, 0, 1], [0, 0, 1], [0, 3, 1]]), [0.0, 0.0, -1.0]
    )


@pytest.mark.parametrize(
    "bad",
    [
        [[0, 0, 0], [1, 1, 1], [2, 2, 2.001]],
        [[0, 0, 0], [0, 0, 0], [1, 0, 0]],
        [[0, 0, 0], [1, 0, 0]],
        [[0, 0, 0], [1, 0, 0], [0, np.nan, 0]],
    ],
)
def test_landmarks_without_a_plane_are_refused(bad):
    with pytest.raises(InputError, match="landmarks"):
        direction_of_landmarks(bad)
