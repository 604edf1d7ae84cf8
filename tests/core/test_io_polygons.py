"""Polygons of any shape are covered by their triangles once, or left out and counted."""

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.io import read_surface
from surfcmp_core.io.triangles import CROSSING, SPLIT, TWICE, triangulate
from tests.core.turning import turn_about

REPORTS = Path(__file__).parent / "fixtures" / "reports"
Flat = NDArray[np.float64]


def _area(flat: Flat) -> float:
    x, y = (flat - flat[0]).T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2.0


def _areas(points: Flat, faces: NDArray[np.int32]) -> Flat:
    a, b, c = points[faces].transpose(1, 0, 2)
    return np.asarray(np.cross(b - a, c - a) / 2.0)


def _split(flat: Flat, start: int = 0) -> tuple[NDArray[np.int32], dict[str, int]]:
    """Split a polygon of the plane z = 0, its corners told from `start` on."""
    points = np.column_stack((flat, np.zeros(len(flat))))
    corners = np.roll(np.arange(len(flat)), -start)[None]
    faces, changed = triangulate([corners], points)
    assert faces is not None
    return faces, changed


def _check_cover(flat: Flat, faces: NDArray[np.int32]) -> None:
    """All triangles turn like the polygon, and their areas add up to its own."""
    turned = _areas(np.column_stack((flat, np.zeros(len(flat)))), faces)[:, 2]
    area = _area(flat)
    assert (turned * np.sign(area) >= -1e-12 * abs(area)).all()
    assert turned.sum() == pytest.approx(area, rel=1e-10)


SHAPES: dict[str, list[tuple[float, float]]] = {
    "L": [(0, 0), (10, 0), (10, 2), (2, 2), (2, 10), (0, 10)],
    "dart": [(0, 0), (4, 0), (1, 1), (0, 4)],
    "arrow": [(0, 0), (2, 1), (4, 0), (2, 5)],
    "comb": [
        (0, 0), (7, 0), (7, 5), (6, 5), (6, 1), (4, 1),
        (4, 5), (3, 5), (3, 1), (1, 1), (1, 5), (0, 5),
    ],
    "square with corners on its edges": [
        (0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)
    ],
    "L with corners on its edges": [
        (0, 0), (5, 0), (10, 0), (10, 2), (2, 2), (2, 6), (2, 10), (0, 10)
    ],
    "spiral": [
        (0, 0), (6, 0), (6, 6), (1, 6), (1, 2), (4, 2), (4, 4),
        (3, 4), (3, 3), (2, 3), (2, 5), (5, 5), (5, 1), (0, 1),
    ],
}  # fmt: skip


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("turned", [False, True])
def test_any_shape_from_any_corner(shape: str, turned: bool) -> None:
    flat = np.array(SHAPES[shape], float)[:: -1 if turned else 1].copy()
    for start in range(len(flat)):
        faces, changed = _split(flat, start)
        assert changed == {SPLIT: 1}
        _check_cover(flat, faces)
        assert len(faces) == len(flat) - 2


@given(
    st.lists(st.floats(0.05, 1.0), min_size=4, max_size=30),
    st.integers(0, 29),
    st.integers(0, 2**32 - 1),
    st.sampled_from([0.0, 1e3, 1e6]),
)
def test_stars_in_space(radii: list[float], start: int, seed: int, away: float) -> None:
    angles = np.linspace(0, 2 * np.pi, len(radii), endpoint=False)
    flat = np.array(radii)[:, None] * np.column_stack((np.cos(angles), np.sin(angles)))
    rng = np.random.default_rng(seed)
    rotation = turn_about(rng.normal(size=3), rng.uniform(0, 360), np.zeros(3))[:3, :3]
    points = np.column_stack((flat, np.zeros(len(flat)))) @ rotation.T + away
    corners = np.roll(np.arange(len(flat)), -(start % len(flat)))[None]
    faces, changed = triangulate([corners], points)
    assert faces is not None
    assert changed == {SPLIT: 1}
    areas = _areas(points, faces)
    along = areas @ rotation[:, 2]
    assert along.sum() == pytest.approx(_area(flat), rel=1e-6)
    assert np.abs(along).sum() == pytest.approx(_area(flat), rel=1e-6)


def test_a_polygon_that_is_not_flat() -> None:
    flat = np.array(SHAPES["comb"], float)
    points = np.column_stack((flat, 0.3 * np.sin(flat[:, 0]) + 0.1 * flat[:, 1]))
    for start in range(len(flat)):
        faces, _ = triangulate([np.roll(np.arange(len(flat)), -start)[None]], points)
        assert faces is not None
        assert set(faces.ravel().tolist()) == set(range(len(flat)))
        _check_cover(flat, faces)  # as seen from above, too


def test_a_convex_polygon_is_fanned_from_its_first_corner() -> None:
    faces, _ = _split(np.array([(0, 0), (2, 0), (3, 1), (2, 2), (0, 2)], float), start=2)
    assert faces.tolist() == [[2, 3, 4], [2, 4, 0], [2, 0, 1]]


def test_of_many_only_the_concave_are_cut_otherwise() -> None:
    rng = np.random.default_rng(1)
    square = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], float)
    flat = (square + np.arange(1000)[:, None, None]).reshape(-1, 2)
    dart = rng.permutation(1000)[:100]
    flat.reshape(1000, 4, 2)[dart, 1] += np.array([-0.8, 0.8])
    group = np.arange(4000).reshape(1000, 4)
    faces, changed = triangulate([group], np.column_stack((flat, np.zeros(4000))))
    assert faces is not None
    assert changed == {SPLIT: 1000}
    areas = _areas(np.column_stack((flat, np.zeros(4000))), faces)[:, 2]
    assert (areas > 0).all()
    assert areas.sum() == pytest.approx(sum(map(_area, flat.reshape(1000, 4, 2))))
    again, _ = triangulate([group], np.column_stack((flat, np.zeros(4000))))
    assert np.array_equal(faces, again)  # type: ignore[arg-type]


def test_corners_told_twice_change_nothing() -> None:
    flat = np.array(SHAPES["L"], float)
    points = np.column_stack((flat, np.zeros(6)))
    for at in range(6):
        corners = np.insert(np.arange(6), at, at)[None]
        faces, changed = triangulate([corners], points)
        assert faces is not None
        assert changed[SPLIT] == 1
        assert changed.get(TWICE, 0) <= 1
        _check_cover(flat, faces)


CROSSED = {
    "bow": [(0, 0), (2, 2), (2, 0), (0, 2)],
    "lopsided bow": [(0, 0), (3, 2), (3, 0), (0, 1)],
    "pentagram": [(0, 3), (2, -3), (-3, 1), (3, 1), (-2, -3)],
    "twice around": [(0, 0), (2, 0), (2, 2), (0, 2), (0, 0.5), (1.5, 0.5), (1.5, 1.5), (-1, 1.5)],
}


@pytest.mark.parametrize("name", CROSSED)
def test_a_polygon_that_crosses_itself_is_left_out_and_counted(name: str) -> None:
    flat = np.array(CROSSED[name], float)
    points = np.column_stack((np.concatenate((flat, [(9, 9), (9, 8)])), np.zeros(len(flat) + 2)))
    good = np.array([[0, len(flat), len(flat) + 1]])
    for start in range(len(flat)):
        corners = np.roll(np.arange(len(flat)), -start)[None]
        faces, changed = triangulate([corners, good], points)
        assert faces is not None
        assert faces.tolist() == good.tolist()
        assert changed == {CROSSING: 1}


def test_large_polygons_that_would_take_long_are_refused() -> None:
    rng = np.random.default_rng(1)
    points = np.column_stack((rng.random((6000, 2)), np.zeros(6000)))
    assert triangulate([np.arange(6000)[None]], points)[1] == {CROSSING: 1}
    with pytest.raises(InputError, match="polygons of 6000 corners cross themselves"):
        triangulate([np.arange(6000)[None]] * 99, points)
    points = np.column_stack((rng.random((20_000, 2)), np.zeros(20_000)))
    with pytest.raises(InputError, match="a polygon of 20000 corners that is not convex"):
        triangulate([np.arange(20_000)[None]], points)
    angle = np.linspace(0, 2 * np.pi, 20_000, endpoint=False)
    points = np.column_stack((np.cos(angle), np.sin(angle), 0 * angle))
    faces, _ = triangulate([np.arange(20_000)[None]], points)
    assert faces is not None
    assert len(faces) == 19_998


@pytest.mark.parametrize("away", [np.nan, np.inf, 1e308])
def test_corners_that_are_not_finite_are_left_to_the_check_of_nodes(away: float) -> None:
    points = np.array([[0, 0, 0], [1, 0, 0], [away, 1, -away], [0, 1, 0]], float)
    with np.errstate(all="ignore"):
        faces, _ = triangulate([np.arange(4)[None]], points)
    assert faces is not None
    assert 2 in faces


@pytest.mark.parametrize(
    "name", ["concave_L_bad_start.ply", "concave_L_good_start.ply", "concave_L.obj"]
)
def test_reported_concave_faces(name: str) -> None:
    surface = read_surface(REPORTS / name)
    assert surface.faces is not None
    areas = _areas(surface.points, surface.faces)[:, 2]
    assert (areas > 0).all()
    assert areas.sum() == 36.0


def test_rings_met_in_the_wild(shared: Path) -> None:
    """Outer rings of the fixtures of a library that cuts ears."""
    found = 0
    for path in sorted((shared / "fixtures" / "earcut").glob("*.json")):
        ring = np.array(json.loads(path.read_text())[0], float)
        if len(ring) < 4 or len(ring) > 5000 or not abs(_area(ring)) > 0:
            continue
        points = np.column_stack((ring, np.zeros(len(ring))))
        faces, changed = triangulate([np.arange(len(ring))[None]], points)
        if faces is not None and CROSSING not in changed:
            _check_cover(ring, faces)
            found += 1
    assert found > 20
