"""A best fit never claims what it cannot: wrong poses are doubted, free motions are named."""

import json
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.__main__ import main
from surfcmp_core import read_surface
from surfcmp_core.alignment import best_fit, fit_landmarks, record_of_motion
from surfcmp_core.errors import InputError
from surfcmp_core.grid.thinning import thin_random
from surfcmp_core.io.samples import sample_pair
from surfcmp_core.projection import moved
from surfcmp_core.report.provenance import fit_rows
from surfcmp_core.surface import Surface
from tests.core.turning import any_motion, left_over, turn_about

AXES = {"x": [1.0, 0, 0], "y": [0, 1.0, 0], "z": [0, 0, 1.0]}


def sample(pair="face", which=0) -> Surface:
    return read_surface(sample_pair(pair)[which])


def hemisphere(count, seed, noise=0.0):
    rng = np.random.default_rng(seed)
    places = rng.normal(size=(count, 3))
    places *= 50.0 / np.linalg.norm(places, axis=1, keepdims=True)
    places[:, 2] = np.abs(places[:, 2])
    return Surface(places + rng.normal(size=(count, 3)) * noise, name=f"hemisphere {seed}")


def cylinder(count, seed, noise=0.0):
    rng = np.random.default_rng(seed)
    angle, x = rng.uniform(0.0, np.pi, count), rng.uniform(-60.0, 60.0, count)
    places = np.column_stack((x, 40.0 * np.cos(angle), 40.0 * np.sin(angle)))
    return Surface(places + rng.normal(size=(count, 3)) * noise, name=f"cylinder {seed}")


def plane(count, seed, noise=0.0):
    rng = np.random.default_rng(seed)
    places = np.column_stack((rng.uniform(-50.0, 50.0, (count, 2)), np.zeros(count)))
    return Surface(places + rng.normal(size=(count, 3)) * noise, name=f"plane {seed}")


def cone(count, seed, noise=0.0):
    rng = np.random.default_rng(seed)
    angle, far = rng.uniform(0.0, 2.0 * np.pi, count), 50.0 * np.sqrt(rng.random(count))
    places = np.column_stack((far * np.cos(angle), far * np.sin(angle), -far))
    return Surface(places + rng.normal(size=(count, 3)) * noise, name=f"cone {seed}")


FREE = [
    (hemisphere, ("turn about x", "turn about y", "turn about z")),
    (cylinder, ("turn about x", "slide along x")),
    (plane, ("turn about z", "slide along x", "slide along y")),
    (cone, ("turn about z",)),
]


@pytest.mark.parametrize("noise", [0.0, 0.3])
@pytest.mark.parametrize("count", [500, 4000])
@pytest.mark.parametrize(("shape", "free"), FREE)
def test_what_no_form_holds_is_named(shape, free, count, noise):
    found = best_fit(shape(count, 1, noise), shape(count, 2, noise))
    assert found.free == free
    assert any("leaves the best fit free to" in doubt for doubt in found.doubts)
    assert all(motion in found.doubts[-1] for motion in free)
    assert not any("directed differently" in doubt for doubt in found.doubts)  # they are alike


@pytest.mark.parametrize(("shape", "free"), FREE)
def test_a_copy_holds_no_better_than_another_sampling(shape, free):
    surface = shape(2000, 1)
    found = best_fit(surface, moved(surface, turn_about(np.array(AXES["z"]), 2.0, np.zeros(3))))
    assert found.free == free


def test_free_motions_are_told_in_the_coordinates_of_surface_1():
    turn = turn_about(np.array(AXES["y"]), 90.0, np.zeros(3))  # x becomes -z
    aside = turn_about(np.array(AXES["z"]), 45.0, np.zeros(3))
    one, other = cylinder(1500, 1), cylinder(1400, 2)
    both = best_fit(moved(one, turn), moved(other, turn))
    assert both.free == ("turn about z", "slide along z")
    askew = best_fit(moved(one, aside), moved(other, aside))
    assert {motion.split(" (")[0] for motion in askew.free} == {"turn about", "slide along"}
    assert all("(0.7" in motion for motion in askew.free)
    start = np.linalg.inv(turn)
    again = best_fit(one, moved(other, turn), start=start)
    assert again.free == ("turn about x", "slide along x")


@pytest.mark.parametrize("pair", ["face", "jaw", "terrain"])
def test_samples_are_held_and_fit_without_a_doubt(pair):
    one, other = sample(pair, 0), sample(pair, 1)
    found = best_fit(one, other)
    assert found.free == ()
    assert found.doubts == ()


@settings(max_examples=12, deadline=None)
@given(st.integers(0, 2**16), st.floats(1.0, 25.0))
def test_from_nearby_there_is_no_doubt(seed, degrees):
    face = thin_random(sample(), 0.3, seed=seed)
    rng = np.random.default_rng(seed)
    motion = any_motion(rng, degrees, 3.0, face.points.mean(axis=0))
    other = thin_random(sample(), 0.3, seed=seed + 1)
    found = best_fit(face, moved(other, motion))
    assert left_over(found.matrix, motion, face.points.mean(axis=0)) < (1.0, 1.0)
    assert found.doubts == ()
    assert found.turned == pytest.approx(degrees, abs=1.0)
    assert found.agreement > 0.7
    assert min(found.overlaps) > 0.9


@pytest.mark.parametrize("about_origin", [False, True])
@pytest.mark.parametrize("degrees", [45.0, 90.0, 135.0, 150.0, 180.0])
@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_a_wrong_pose_is_doubted(axis, degrees, about_origin):
    face = sample(which=1)  # the coarser one, on which each doubt is as needed
    centre = np.zeros(3) if about_origin else face.points.mean(axis=0)
    motion = turn_about(np.array(AXES[axis]), degrees, centre)
    try:
        found = best_fit(face, moved(face, motion))
    except InputError:  # no partners: that is no claim
        return
    angle, distance = left_over(found.matrix, motion, face.points.mean(axis=0))
    if angle > 3.0 or distance > 3.0:
        assert found.doubts


def test_upside_down_is_doubted_where_hardly_anything_moves():
    # from half a turn away the nearest minimum is a few degrees off: the reach says nothing
    face = sample()
    other = thin_random(face, 0.5, seed=4)
    middle = face.points.mean(axis=0)
    motion = turn_about(np.array(AXES["z"]), 178.0, middle)
    found = best_fit(face, moved(other, motion))
    assert left_over(found.matrix, motion, middle)[0] > 100.0
    assert found.turned < 30.0
    assert any("directed differently" in d or "another pose" in d for d in found.doubts)


def test_a_pose_that_rests_on_little_is_doubted():
    face = sample()
    x = face.points[:, 0]
    left = replace(face, faces=face.faces[(x[face.faces] < 10.0).all(axis=1)], name="left")
    right = Surface(face.points[x > -10.0], name="right")
    found = best_fit(left, right)
    assert max(found.overlaps) < 0.5
    assert any("rests on a small overlap" in doubt for doubt in found.doubts)


def test_landmarks_are_told_each_with_its_residual():
    rng = np.random.default_rng(0)
    marks = rng.normal(size=(5, 3)) * 40.0
    away = marks + rng.normal(size=(5, 3))
    found = fit_landmarks(marks, away)
    left = away @ found.matrix[:3, :3].T + found.matrix[:3, 3] - marks
    np.testing.assert_allclose(found.landmarks, np.linalg.norm(left, axis=1), rtol=1e-9)
    record = found.record()
    assert [mark["name"] for mark in record["landmarks"]] == ["1", "2", "3", "4", "5"]
    assert all(mark["held_out"] is False for mark in record["landmarks"])
    assert found.residual == pytest.approx(np.sqrt(np.mean(np.square(found.landmarks))))
    rows = dict(fit_rows(record, "mm"))
    assert rows["landmark 3"].startswith(f"{found.landmarks[2]:.4g}"[:4])


def test_the_account_is_the_same_for_exchanged_surfaces():
    one, other = sample("face", 0), sample("face", 1)
    there, back = best_fit(one, other), best_fit(other, one)
    assert there.overlaps == pytest.approx(back.overlaps[::-1], abs=0.01)
    assert there.agreement == pytest.approx(back.agreement, abs=0.02)


def test_kept_pairs_are_the_near_ones_of_all():
    one, other = sample("face", 0), sample("face", 1)  # of which one cheek is swollen
    found = best_fit(one, other)
    assert 100 < found.inliers < found.pairs
    assert found.residual < found.residual_all


def test_records_have_the_same_keys_whatever_is_known():
    known = best_fit(sample("face", 0), sample("face", 1)).record()
    nothing = record_of_motion("none", np.eye(4))
    assert known.keys() == nothing.keys()
    assert json.loads(json.dumps(known, allow_nan=False)) == known
    assert fit_rows(nothing, "mm") == [("method", "none")]


def test_every_output_tells_of_a_doubtful_fit(tmp_path, capsys):
    face = thin_random(sample(), 0.2, seed=1)
    other = moved(face, turn_about(np.array(AXES["z"]), 150.0, face.points.mean(axis=0)))
    files = [str(tmp_path / name) for name in ("one.npy", "two.npy")]
    for file, surface in zip(files, (face, other), strict=True):
        np.save(file, surface.points)
    outs = [tmp_path / f"result{ending}" for ending in (".json", ".html")]
    asked = ["--align", "icp", "--project", "auto"]
    assert main(["compare", *files, *asked, *(f"--out={out}" for out in outs)]) == 0
    table = " ".join(capsys.readouterr().out.split())
    document = json.loads(outs[0].read_text(encoding="utf-8"))
    found = document["alignment"]
    assert found["method"] == "icp overlap"
    assert found["doubts"]
    for doubt in found["doubts"]:
        assert f"--align icp: {doubt}" in document["warnings"]
        assert doubt in table
        assert doubt in outs[1].read_text(encoding="utf-8")
    for name, _ in fit_rows(found, "mm"):
        assert name in table
    rows = tmp_path / "pairs.csv"
    assert main(["batch", *files, *asked, "--quiet", "--out", str(rows)]) == 0
    assert found["doubts"][0] in rows.read_text(encoding="utf-8")
