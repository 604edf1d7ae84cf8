"""Thinning."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from surfcmp_core.errors import InputError
from surfcmp_core.grid.thinning import thin_random, thin_to_spacing
from surfcmp_core.surface import Surface

pytestmark = pytest.mark.plain

POINTS = np.random.default_rng(0).uniform(-50.0, 50.0, (2000, 3)) * [1.0, 1.0, 0.1]
CLOUD = Surface(POINTS, name="cloud", unit="mm", dropped={"island": 3, "thinned": 5})


def rows(points):
    return {tuple(p) for p in points.tolist()}


@pytest.mark.parametrize("keep", [0.0005, 0.1, 0.5, 0.9999, 1.0])
def test_random_share_is_exact_seeded_and_counted(keep):
    thin = thin_random(CLOUD, keep, seed=4)
    assert len(thin.points) == round(keep * 2000)
    assert rows(thin.points) <= rows(POINTS)
    assert thin.dropped == {"island": 3, "thinned": 5 + 2000 - len(thin.points)}
    assert (thin.unit, thin.name) == ("mm", "cloud")
    np.testing.assert_array_equal(thin.points, thin_random(CLOUD, keep, seed=4).points)
    if 0.01 < keep < 0.99:
        assert rows(thin.points) != rows(thin_random(CLOUD, keep, seed=5).points)


def test_random_share_is_uniform():
    kept = np.zeros(2000)
    numbered = replace(CLOUD, points=np.column_stack((np.arange(2000.0), POINTS[:, 1:])))
    for seed in range(300):
        kept[thin_random(numbered, 0.25, seed=seed).points[:, 0].astype(int)] += 1
    assert abs(kept.mean() - 75.0) < 1e-9
    assert abs(kept.std() - np.sqrt(300 * 0.25 * 0.75)) < 0.5


def test_mesh_becomes_a_cloud():
    mesh = replace(CLOUD, faces=np.array([[0, 1, 2]], np.int32))
    assert thin_random(mesh, 1.0).kind == "cloud"
    assert thin_to_spacing(mesh, 1.0).kind == "cloud"


def naive(points, spacing, seed):
    kept = []
    for node in np.random.default_rng(seed).permutation(len(points)):
        if all(((points[node] - points[k]) ** 2).sum() >= spacing**2 for k in kept):
            kept.append(node)
    return points[np.sort(kept)]


@given(
    arrays(np.float64, st.tuples(st.integers(1, 40), st.just(3)), elements=st.integers(-6, 6)),
    st.sampled_from([0.5, 1.0, 2.0, 3.5, 30.0]),
    st.integers(0, 5),
)
def test_spacing_against_the_oracle(points, spacing, seed):
    thin = thin_to_spacing(Surface(points), spacing, seed=seed)
    np.testing.assert_array_equal(thin.points, naive(points, spacing, seed))
    assert len(thin.points) + thin.dropped.get("thinned", 0) == len(points)


@pytest.mark.parametrize("spacing", [0.7, 4.0, 1000.0])
def test_spacing_keeps_distance_and_leaves_no_gap(spacing):
    thin = thin_to_spacing(CLOUD, spacing, seed=1).points
    between = np.linalg.norm(thin[:, None] - thin, axis=2)
    assert between[~np.eye(len(thin), dtype=bool)].min(initial=np.inf) >= spacing
    assert np.linalg.norm(POINTS[:, None] - thin, axis=2).min(axis=1).max() < spacing


def test_spacing_far_below_the_extent():
    points = np.array([[0.0, 0, 0], [1e-9, 0, 0], [1e9, 0, 0], [-1e9, 5, 0]])
    assert len(thin_to_spacing(Surface(points), 1e-6).points) == 3
    assert len(thin_to_spacing(Surface(points), 1e-12).points) == 4


@pytest.mark.parametrize("keep", [0.0, -0.1, 1.1, np.nan])
def test_bad_share_is_refused(keep):
    with pytest.raises(InputError, match="cloud: cannot keep a share"):
        thin_random(CLOUD, keep)


@pytest.mark.parametrize("spacing", [0.0, -1.0, np.nan, np.inf])
def test_bad_spacing_is_refused(spacing):
    with pytest.raises(InputError, match="cloud: cannot thin to a spacing"):
        thin_to_spacing(CLOUD, spacing)
