"""Landmarks and best fit."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from surfcmp_core.alignment import best_fit, fit_landmarks
from surfcmp_core.errors import InputError
from surfcmp_core.grid.thinning import thin_random
from surfcmp_core.io import read_surface
from surfcmp_core.io.samples import sample_pair
from surfcmp_core.projection import moved
from surfcmp_core.surface import Surface
from tests.core.sheets import sheet
from tests.core.turning import any_motion, left_over


def after(matrix, points):
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def assert_rigid(matrix):
    np.testing.assert_allclose(matrix[:3, :3] @ matrix[:3, :3].T, np.eye(3), atol=1e-12)
    assert np.linalg.det(matrix[:3, :3]) > 0.0
    np.testing.assert_array_equal(matrix[3], [0, 0, 0, 1])


@given(st.integers(0, 2**32), st.integers(3, 8), st.floats(0.0, 180.0))
def test_landmarks_give_back_any_motion(seed, count, degrees):
    rng = np.random.default_rng(seed)
    marks = rng.normal(size=(count, 3)) * 40.0
    motion = any_motion(rng, degrees, 1000.0, marks.mean(axis=0))
    spread = np.linalg.svd(marks - marks.mean(axis=0), compute_uv=False)
    assume(spread[1] > 0.02 * spread[0])
    found = fit_landmarks(marks, after(motion, marks))
    np.testing.assert_allclose(found.matrix @ motion, np.eye(4), atol=1e-9)
    assert_rigid(found.matrix)
    assert found.residual < 1e-9
    assert (found.method, found.inliers, found.converged) == ("landmarks", count, True)


def test_landmarks_residual_is_the_root_mean_square_distance():
    rng = np.random.default_rng(0)
    marks_1 = rng.normal(size=(6, 3)) * 40.0
    marks_2 = marks_1 + rng.normal(size=(6, 3))
    found = fit_landmarks(marks_1, marks_2)
    away = after(found.matrix, marks_2) - marks_1
    assert found.residual == pytest.approx(np.sqrt((away**2).sum(axis=1).mean()))
    for seed in range(200):  # no motion nearby does better
        small = any_motion(np.random.default_rng(seed), 0.1, 0.05, np.zeros(3))
        worse = after(small, after(found.matrix, marks_2)) - marks_1
        assert (worse**2).sum() > (away**2).sum()


def test_three_landmarks_have_no_mirror_image():
    marks = np.array([[0.0, 0, 0], [5, 0, 0], [0, 3, 0]])
    found = fit_landmarks(marks, marks * [-1.0, 1.0, 1.0])
    assert_rigid(found.matrix)
    assert found.residual < 1e-12


SQUARE = [[0.0, 0, 0], [1, 0, 0], [1, 1, 0.5], [0, 1, 0]]


@pytest.mark.parametrize(
    ("marks_1", "marks_2", "fault"),
    [
        (SQUARE, SQUARE[:3], "4 landmarks on surface 1 but 3 on surface 2"),
        (SQUARE[:2], SQUARE[:2], "2 pairs of landmarks; at least 3"),
        (SQUARE, np.eye(4)[:, :3] * [0, 0, 1], "surface 2 lie near one line"),
        ([[0, 0, 0], [1, 1, 1], [3, 3, 3]], SQUARE[:3], "surface 1 lie near one line"),
        (SQUARE, np.array(SQUARE) * [1, 1, -1], "mirror image"),
        (SQUARE, np.array(SQUARE)[:, :2], "surface 2: not a list"),
        ([[0, 0, np.nan]] * 3, SQUARE[:3], "surface 1: not a list"),
    ],
)
def test_bad_landmarks_are_refused(marks_1, marks_2, fault):
    with pytest.raises(InputError, match=fault):
        fit_landmarks(marks_1, marks_2)


def test_noisy_flat_landmarks_are_no_mirror_image():
    rng = np.random.default_rng(1)
    for _ in range(50):
        flat = np.array([[0.0, 0, 0], [60, 0, 0], [60, 40, 0], [0, 40, 0]])
        fit_landmarks(flat + rng.normal(size=(4, 3)), flat + rng.normal(size=(4, 3)))


def hills(n=60, seed=0) -> Surface:
    """Give a lively sheet of about 100 x 100 with irregular nodes."""
    surface = sheet(lambda x, y: 0.0 * x, n=n)
    rng = np.random.default_rng(seed)
    xy = surface.points[:, :2] + rng.uniform(-0.3, 0.3, (n * n, 2)) * 2.0 / n
    x, y = 50.0 * xy.T
    z = 12.0 * np.sin(x / 17.0) * np.cos(y / 13.0) + 6.0 * np.sin(x / 9.0 + y / 23.0)
    return replace(surface, points=np.column_stack((x, y, z)), name=f"hills {seed}")


def test_best_fit_of_a_copy_is_exact_and_repeatable():
    surface = hills()
    motion = any_motion(np.random.default_rng(3), 5.0, 5.0, np.zeros(3))
    found = best_fit(surface, moved(surface, motion))
    np.testing.assert_allclose(found.matrix @ motion, np.eye(4), atol=1e-5)
    assert_rigid(found.matrix)
    assert found.converged
    assert found.residual < 1e-5
    again = best_fit(surface, moved(surface, motion))
    np.testing.assert_array_equal(again.matrix, found.matrix)


def test_exchanged_surfaces_give_the_inverse_motion():
    one, other = hills(60, 0), hills(45, 1)
    motion = any_motion(np.random.default_rng(4), 3.0, 3.0, np.zeros(3))
    other = moved(other, motion)
    there, back = best_fit(one, other), best_fit(other, one)
    np.testing.assert_allclose(there.matrix @ back.matrix, np.eye(4), atol=2e-3)
    assert left_over(there.matrix, motion, np.zeros(3)) < (0.05, 0.05)


def test_partial_overlap_is_not_drawn_over():
    one, other = hills(60, 0), hills(70, 1)
    left = replace(one, faces=one.faces[(one.points[one.faces, 0] < 15.0).all(axis=1)])
    right = Surface(other.points[other.points[:, 0] > -20.0], name="right")
    motion = any_motion(np.random.default_rng(5), 4.0, 3.0, np.zeros(3))
    found = best_fit(left, moved(right, motion))
    degrees, distance = left_over(found.matrix, motion, np.zeros(3))
    assert degrees < 0.05
    assert distance < 0.05
    assert found.method == "icp overlap"
    assert 0.3 < found.overlap < 0.7
    everywhere = best_fit(left, moved(right, motion), overlap_only=False)
    assert everywhere.method == "icp"
    assert everywhere.overlap == 1.0
    assert left_over(everywhere.matrix, motion, np.zeros(3))[1] > 0.5


def test_swelling_does_not_pull_the_rest_along():
    one, other = hills(60, 0), hills(50, 1)
    x, y = other.points[:, 0], other.points[:, 1]
    other.points[:, 2] += 8.0 * np.exp(-((x - 20.0) ** 2 + (y + 10.0) ** 2) / 2.0 / 12.0**2)
    motion = any_motion(np.random.default_rng(6), 5.0, 5.0, np.zeros(3))
    found = best_fit(one, moved(other, motion))
    degrees, distance = left_over(found.matrix, motion, np.zeros(3))
    assert degrees < 0.05
    assert distance < 0.05


def test_region_decides_where_the_rest_has_changed():
    one, other = hills(60, 0), hills(60, 1)
    other.points[other.points[:, 0] > -10.0, 2] += 3.0  # most of it has moved
    motion = any_motion(np.random.default_rng(7), 2.0, 2.0, np.zeros(3))
    region = one.points[:, 0] < -15.0
    found = best_fit(one, moved(other, motion), region_1=region)
    degrees, distance = left_over(found.matrix, motion, np.array([-30.0, 0.0, 0.0]))
    assert degrees < 0.1
    assert distance < 0.1
    assert found.method == "icp region"
    both = best_fit(one, moved(other, motion), region_1=region, region_2=other.points[:, 0] < -15.0)
    np.testing.assert_allclose(both.matrix, found.matrix, atol=0.05)


def test_start_is_where_it_starts_from():
    one, other = hills(60, 0), hills(50, 1)
    motion = any_motion(np.random.default_rng(8), 120.0, 400.0, np.zeros(3))
    rough = any_motion(np.random.default_rng(9), 3.0, 3.0, np.zeros(3)) @ np.linalg.inv(motion)
    found = best_fit(one, moved(other, motion), start=rough)
    degrees, distance = left_over(found.matrix, motion, np.zeros(3))
    assert degrees < 0.05
    assert distance < 0.05


def test_flat_sheets_stay_where_nothing_holds_them():
    flat = sheet(lambda x, y: 0.0 * x, n=20)
    lifted = replace(flat, points=flat.points + np.array([0.0, 0.0, 0.1]))
    found = best_fit(flat, lifted)
    np.testing.assert_allclose(found.matrix[:3, 3], [0.0, 0.0, -0.1], atol=1e-9)
    np.testing.assert_allclose(found.matrix[:3, :3], np.eye(3), atol=1e-9)


def test_coordinates_far_from_the_origin_lose_nothing():
    one, other = hills(60, 0), hills(50, 1)
    far = np.eye(4)
    far[:3, 3] = 5e6, -4e6, 300.0
    near, away = best_fit(one, other), best_fit(moved(one, far), moved(other, far))
    np.testing.assert_allclose(away.matrix @ far, far @ near.matrix, atol=1e-4)


def test_surfaces_without_partners_are_refused():
    one, other = hills(30, 0), hills(30, 1)
    far = np.eye(4)
    far[:3, 3] = 1e4, 0.0, 0.0
    with pytest.raises(InputError, match="nodes find a partner on hills 0; bring"):
        best_fit(one, moved(other, far))


@pytest.mark.parametrize(
    ("region", "fault"),
    [
        (np.ones(3, bool), "not one bool for each node"),
        (np.ones(900), "not one bool for each node"),
        (np.arange(900) < 5, "5 nodes to align; at least 10"),
    ],
)
def test_bad_regions_are_refused(region, fault):
    with pytest.raises(InputError, match=fault):
        best_fit(hills(30, 0), hills(30, 1), region_1=region)


def test_progress_rises_and_may_cancel():
    told = []
    best_fit(hills(30, 0), hills(30, 1), progress=lambda stage, share: told.append((stage, share)))
    assert {stage for stage, _ in told} == {"align"}
    assert told == sorted(told)
    assert 0.0 < told[0][1] <= told[-1][1] <= 1.0


@pytest.mark.parametrize("seed", [0, 1])
def test_sample_face_is_found_to_a_twentieth_of_a_millimetre(seed):
    before, after_swelling = (read_surface(path) for path in sample_pair("face"))
    centre = before.points.mean(axis=0)
    motion = any_motion(np.random.default_rng(seed), 5.0, 5.0, centre)
    found = best_fit(before, moved(after_swelling, motion))
    degrees, distance = left_over(found.matrix, motion, centre)
    assert degrees <= 0.05
    assert distance <= 0.05
    assert found.converged


def test_sample_face_from_far_off_by_landmarks():
    before, after_swelling = (read_surface(path) for path in sample_pair("face"))
    centre = before.points.mean(axis=0)
    rng = np.random.default_rng(2)
    motion = any_motion(rng, 30.0, 60.0, centre)
    turned = moved(after_swelling, motion)
    picked = [100, 1500, 2600, 3900]
    # picked by hand: a millimetre off
    marks = after_swelling.points[picked] + rng.normal(size=(4, 3))
    start = fit_landmarks(marks, turned.points[picked])
    found = best_fit(before, turned, start=start.matrix)
    degrees, distance = left_over(found.matrix, motion, centre)
    assert degrees <= 0.05
    assert distance <= 0.05


@pytest.mark.parametrize("degrees", [5.0, 30.0])
@pytest.mark.parametrize("name", ["face_avg_f18", "made_face"])
def test_face_against_a_thinned_noisy_copy(scan, name, degrees):
    face = scan(name)
    rng = np.random.default_rng(3)
    copy = thin_random(face, 0.5, seed=3)
    copy = replace(copy, points=copy.points + rng.normal(size=copy.points.shape) * 0.2)
    centre = face.points.mean(axis=0)
    motion = any_motion(rng, degrees, 5.0, centre)
    turned = moved(copy, motion)
    start = None
    if degrees > 5.0:
        picked = np.array([0.001, 0.25, 0.5, 0.9]) * len(copy.points)
        picked = picked.astype(int)
        marks = copy.points[picked] + rng.normal(size=(4, 3)) * 2.0
        start = fit_landmarks(marks, turned.points[picked]).matrix
    found = best_fit(face, turned, start=start)
    angle, distance = left_over(found.matrix, motion, centre)
    assert angle <= 0.05
    assert distance <= 0.05


@pytest.mark.parametrize("name", ["face_avg_f18", "made_face"])
def test_borders_of_scans_do_not_draw(scan, name):
    # with partners on borders allowed, twice as much is left over
    face = scan(name)
    rng = np.random.default_rng(9)
    y = face.points[face.faces, 1]
    upper = replace(face, faces=face.faces[(y > -20.0).all(axis=1)])
    noisy = face.points + rng.normal(size=face.points.shape) * 0.15
    lower = replace(face, points=noisy, faces=face.faces[(y < 20.0).all(axis=1)])
    centre = face.points.mean(axis=0)
    motion = any_motion(rng, 5.0, 5.0, centre)
    angle, distance = left_over(best_fit(upper, moved(lower, motion)).matrix, motion, centre)
    assert angle < 0.04
    assert distance < 0.02


JAWS = ("jaw_crowns_ref_L0", "jaw_crowns_pred_L0")
MADE_JAWS = ("made_jaw", "made_jaw_later")


@pytest.mark.parametrize(("names", "seed"), [(JAWS, 0), (JAWS, 6), (MADE_JAWS, 0), (MADE_JAWS, 7)])
def test_unlike_jaws_turned_about_a_far_centre_settle(scan, names, seed):
    # step by step they would creep along for more than sixty rounds
    reference, predicted = map(scan, names)
    rng = np.random.default_rng(seed)
    centre = reference.points.mean(axis=0)
    motion = any_motion(rng, 5.0, 0.0, centre + rng.normal(size=3) * 30.0)
    near, far = best_fit(reference, predicted), best_fit(reference, moved(predicted, motion))
    assert near.converged
    assert far.converged
    assert far.iterations < 40
    degrees, distance = left_over(far.matrix @ motion, np.linalg.inv(near.matrix), centre)
    assert degrees < 0.01
    assert distance < 0.01
