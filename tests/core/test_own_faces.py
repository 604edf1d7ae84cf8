"""The exact reading and coverage on meshes' own faces, against polygons cut in rationals."""

from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core import InputError, Surface, compare
from surfcmp_core.comparing.verification import check_half_edges
from surfcmp_core.domain import own_faces
from surfcmp_core.localisation import locate_from, relocate
from surfcmp_core.triangulation import Triangulation, triangulate
from tests.core.overlay_pairs import area_of, cut, exact, keep_left, linear, product_over

Ints = NDArray[np.int32]
Floats = NDArray[np.float64]
COARSE = Path(__file__).parent / "fixtures" / "attack" / "coverage_above_1.npz"


def turned(nodes: Floats, face: list[int]) -> list[int] | None:
    """Give a face counter-clockwise, None where it has no area."""
    a, b, c = exact(nodes[face])
    area = area_of([a, b, c])
    if area == 0:
        return None
    return face if area > 0 else [face[0], face[2], face[1]]


def by_brute_force(one: Surface, other: Surface) -> tuple[Fraction, Fraction, Fraction]:
    """Common area, ∬|d| and ∬d over all pairs of faces."""
    area = volume = signed = Fraction(0)
    sides = []
    for s in (one, other):
        assert s.faces is not None
        faces = [turned(s.points[:, :2], f) for f in s.faces.tolist()]
        sides.append(
            [(exact(s.points[f, :2]), s.points[f, 2].tolist()) for f in faces if f is not None]
        )
    for corners_1, z_1 in sides[0]:
        for corners_2, z_2 in sides[1]:
            piece = cut(corners_1, corners_2)
            if area_of(piece) == 0:
                continue
            f_1, f_2 = linear(corners_1, z_1), linear(corners_2, z_2)
            d = [f_1(p) - f_2(p) for p in piece]
            area += area_of(piece)
            signed += product_over(piece, d, [Fraction(1)] * len(piece))
            for sign in (1, -1):
                half = keep_left(piece, [sign * v for v in d])
                at = [sign * (f_1(p) - f_2(p)) for p in half]
                volume += product_over(half, at, [Fraction(1)] * len(half))
    return area, volume, signed


def area_of_faces(mesh: Surface) -> Fraction:
    assert mesh.faces is not None
    faces = [turned(mesh.points[:, :2], f) for f in mesh.faces.tolist()]
    return sum(
        (area_of(exact(mesh.points[f, :2])) for f in faces if f is not None), start=Fraction(0)
    )


def flipped(rng: np.random.Generator, t: Triangulation, times: int) -> Ints:
    """Turn edges of a triangulation at random: another one of the same nodes."""
    triangles = [list(row) for row in t.triangles.tolist()]
    for _ in range(times):
        k = int(rng.integers(len(triangles)))
        a, b, c = np.roll(triangles[k], int(rng.integers(3))).tolist()
        for other, row in enumerate(triangles):
            if other != k and a in row and b in row:
                d = next(v for v in row if v not in (a, b))
                one, two = [d, b, c], [c, a, d]
                if turned(t.nodes, one) == one and turned(t.nodes, two) == two:
                    triangles[k], triangles[other] = one, two
                break
    return np.array(triangles, np.int32)


def mesh_of(seed: int, name: str, *, most: int = 9) -> Surface:
    """Make a mesh whose faces are in general not those of its Delaunay triangulation."""
    rng = np.random.default_rng([seed, ord(name)])
    while True:
        count = int(rng.integers(3, most + 1))
        if rng.random() < 0.5:
            nodes = np.unique(rng.integers(0, 5, (count, 2)).astype(np.float64), axis=0)
        else:
            nodes = rng.random((count, 2)) * 4.0
        try:
            t = triangulate(nodes)
        except InputError:
            continue
        break
    faces = flipped(rng, t, int(rng.integers(0, 30)))
    faces = faces[rng.random(len(faces)) < 0.85]
    if len(faces) == 0:
        faces = t.triangles[:1]
    if rng.random() < 0.3:
        faces = np.concatenate((faces, faces[:1, ::-1]))  # stored twice
    z = rng.integers(-3, 4, len(nodes)) / 2.0
    return Surface(np.column_stack((nodes, z)), faces=faces, name=name, unit="mm")


def without_repetitions(mesh: Surface) -> Surface:
    assert mesh.faces is not None
    rows = np.unique(np.sort(mesh.faces, axis=1), axis=0)
    return Surface(mesh.points, faces=rows, name=mesh.name, unit="mm")


def check(one: Surface, other: Surface) -> None:
    try:
        measures = compare(one, other, exact=True).measures
    except InputError as error:
        assert "no common area" in str(error)  # noqa: PT017
        return
    found = measures.exact
    assert found is not None
    one, other = without_repetitions(one), without_repetitions(other)
    area, volume, signed = by_brute_force(one, other)
    close: Any = {"rel": 1e-11, "abs": 1e-11}
    assert found.area_compared == pytest.approx(float(area), **close)
    assert found.volume_above + found.volume_below == pytest.approx(float(volume), **close)
    assert found.volume_above - found.volume_below == pytest.approx(float(signed), **close)
    for mesh, coverage, nodal in (
        (one, found.coverage_1, measures.coverage_1),
        (other, found.coverage_2, measures.coverage_2),
    ):
        assert 0.0 <= coverage <= 1.0
        assert coverage == pytest.approx(float(area / area_of_faces(mesh)), **close)
        assert 0.0 <= nodal <= 1.0


@settings(max_examples=150)
@given(st.integers(0, 10**9))
@example(206154)  # both areas are one but for their last bit
def test_exact_area_is_the_common_area_of_all_pairs_of_faces(seed: int) -> None:
    check(mesh_of(seed, "a"), mesh_of(seed, "b"))


@pytest.mark.parametrize("seed", range(40))
def test_meshes_of_any_faces(seed: int) -> None:
    check(mesh_of(seed, "a"), mesh_of(seed, "b"))


def test_faces_with_nodes_on_their_edges_are_as_the_file_has_them() -> None:
    """Two nodes on the edge of a face belong to its neighbours alone: F is torn there."""
    points = np.array(
        [[0.0, 0, 0], [4, 0, 4], [0, 4, 1], [1, -2, 0], [3, -2, 2], [1, 0, 5], [3, 0, -5]]
    )
    faces = np.array([[0, 1, 2], [0, 3, 5], [5, 3, 4], [5, 4, 6], [6, 4, 1]], np.int32)
    torn = Surface(points, faces=faces, name="torn", unit="mm")
    flat = Surface(
        np.array([[-1.0, -3, 0], [5, -3, 0], [5, 5, 0], [-1, 5, 0]]),
        faces=np.array([[0, 1, 2], [0, 2, 3]], np.int32),
        name="flat",
        unit="mm",
    )
    check(torn, flat)
    (of_file, of_square) = compare(torn, flat).faces
    assert of_file is not None
    assert (of_file.replaced, of_file.overlapping) == (1, 0)
    assert of_file.largest_difference == pytest.approx(8.0)  # -5 in place of 3 at (3, 0)
    assert of_square is not None
    assert of_square.largest_difference == 0.0


def test_the_file_is_told_how_far_it_is_from_its_triangles() -> None:
    points = np.array([[0.0, 0, 0], [2, 1, 1], [0, 2, 0], [-2, 1, 1]])
    long = Surface(points, faces=np.array([[0, 1, 3], [1, 2, 3]], np.int32), name="long")
    found = compare(long, long, exact=True)
    for one in found.faces:
        assert one is not None
        assert (one.replaced, one.overlapping) == (2, 0)
        assert one.largest_difference == pytest.approx(1.0)
        assert one.mean_difference == pytest.approx(1.0 / 3.0)
    short = Surface(points, faces=np.array([[0, 1, 2], [0, 2, 3]], np.int32), name="short")
    between = compare(long, short, exact=True).measures
    assert between.exact is not None
    assert between.exact.mean_abs == pytest.approx(1.0 / 3.0)
    assert between.mean_abs == 0.0  # the nodal reading knows the nodes only
    cloud = compare(Surface(points, name="cloud"), short)
    assert cloud.faces[0] is None


def test_faces_that_lie_over_each_other_are_counted() -> None:
    points = np.array([[0.0, 0, 0], [4, 0, 0], [0, 4, 0], [4, 4, 0], [2, 5, 0]])
    folded = Surface(points, faces=np.array([[0, 1, 3], [1, 2, 0]], np.int32), name="folded")
    found = compare(folded, folded, exact=True)
    (one, _) = found.faces
    assert one is not None
    assert one.overlapping == 1
    assert any("lie over others" in warning for warning in found.warnings)
    for measures in (found.measures, found.measures.exact):
        assert measures is not None
        assert 0.0 < measures.coverage_1 <= 1.0


def test_coverage_of_a_coarse_mesh_with_itself() -> None:
    data = np.load(COARSE)
    mesh = Surface(data["points"].astype(np.float64), faces=data["faces"], name="coarse")
    measures = compare(mesh, mesh, exact=True).measures
    assert measures.exact is not None
    assert measures.exact.coverage_1 == measures.exact.coverage_2 == 1.0
    assert 0.9 < measures.coverage_1 <= 1.0
    assert measures.coverage_1 == measures.coverage_2


def test_faces_stored_twice_are_covered_once() -> None:
    points = np.random.default_rng(1).random((30, 3))
    faces = triangulate(points[:, :2].copy()).triangles
    once = Surface(points, faces=faces, name="once", unit="mm")
    twice = Surface(
        points, faces=np.concatenate((faces, faces[::2, ::-1])), name="twice", unit="mm"
    )
    measures = compare(once, twice, exact=True).measures
    assert measures.exact is not None
    assert measures.coverage_2 == measures.exact.coverage_2 == 1.0


@pytest.mark.parametrize("seed", range(30))
def test_edges_are_turned_until_all_faces_are_there(seed: int) -> None:
    rng = np.random.default_rng(seed)
    nodes = (
        rng.random((60, 2)) if seed % 2 else np.unique(rng.integers(0, 8, (60, 2)), axis=0) * 1.0
    )
    t = triangulate(nodes)
    faces = flipped(rng, t, 300)
    own = own_faces(t, faces[rng.permutation(len(faces))])
    check_half_edges(own.triangulation)
    assert own.valid.all()
    assert own.overlapping == 0
    assert np.array_equal(
        np.unique(np.sort(own.triangulation.triangles, axis=1), axis=0),
        np.unique(np.sort(faces, axis=1), axis=0),
    )
    queries = np.concatenate((rng.random((200, 2)) * nodes.max(axis=0), nodes))
    before = locate_from(t, queries, np.zeros(len(queries), np.int32))
    after = relocate(own.triangulation, t, queries, before)
    assert np.array_equal(before >= t.real, after >= t.real)
    for place, k in zip(exact(queries), after.tolist(), strict=True):
        if k < t.real:
            corners = exact(nodes[own.triangulation.triangles[k]])
            for i in range(3):
                assert area_of([corners[i], corners[(i + 1) % 3], place]) >= 0
