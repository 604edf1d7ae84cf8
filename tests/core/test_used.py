"""Nodes of no triangle, and triangles that stand in a mesh twice, change no number."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from surfcmp_core.alignment import best_fit
from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.comparing.options import Domain
from surfcmp_core.comparing.request import compare
from surfcmp_core.errors import InputError
from surfcmp_core.io import facts_of, read_surface
from surfcmp_core.projection.placement import look_at, place
from surfcmp_core.surface import Duplicates, Surface
from surfcmp_core.surface.used import REPEATED, UNUSED, nodes_in_use, used_part

REPORTS = Path(__file__).parent / "fixtures" / "reports"
DOMAINS: tuple[Domain, ...] = ("data", "hull", "plane")


def _lattice(n: int, z: float, scale: float = 1.0, shift: float = 0.0) -> Surface:
    """Two triangles in each cell of n × n nodes."""
    x, y = np.meshgrid(np.arange(n) * scale + shift, np.arange(n) * scale + shift)
    points = np.column_stack((x.ravel(), y.ravel(), np.full(n * n, z)))
    a = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
    faces = np.concatenate(
        [np.column_stack((a, a + 1, a + n + 1)), np.column_stack((a, a + n + 1, a + n))]
    )
    return Surface(points, faces.astype(np.int32))


PLAIN = _lattice(21, 0.0)
OTHER = _lattice(21, 1.0, 0.9, 0.7)

STRAY = {
    "near": [[10.3, 10.4, 50.0]],
    "far": [[1e6, -1e6, 0.0]],
    "above a node": [[10.0, 10.0, 7.0], [0.0, 0.0, -7.0]],
    "on a node": [[10.0, 10.0, 0.0]],
    "in the plane": [[10.5, 10.25, 0.0], [30.0, 30.0, 0.0]],
    "not finite": [[np.nan, 0.0, 0.0], [np.inf, -np.inf, 1.0], [1e300, 1e-300, 0.0]],
}


def _with_nodes(mesh: Surface, stray: list[list[float]], first: bool) -> Surface:
    extra = np.array(stray)
    assert mesh.faces is not None
    if first:
        points, faces = np.concatenate((extra, mesh.points)), mesh.faces + np.int32(len(extra))
    else:
        points, faces = np.concatenate((mesh.points, extra)), mesh.faces
    return replace(mesh, points=points, faces=faces)


def _numbers(found: Comparison) -> tuple[object, ...]:
    return found.measures, found.z1.tobytes(), found.united.triangles.tobytes()


@pytest.mark.parametrize("domain", DOMAINS)
@pytest.mark.parametrize("where", STRAY)
def test_a_node_of_no_triangle_is_no_part_of_the_surface(where: str, domain: Domain) -> None:
    expected = _numbers(compare(PLAIN, OTHER, domain=domain, exact=True))
    for first in (True, False):
        mesh = _with_nodes(PLAIN, STRAY[where], first)
        found = compare(mesh, OTHER, domain=domain, exact=True)
        assert _numbers(found) == expected
        assert found.surfaces[0].dropped == {UNUSED: len(STRAY[where])}
        assert any("nodes that no triangle uses" in warning for warning in found.warnings)
        assert _numbers(compare(OTHER, mesh, domain=domain, exact=True)) == _numbers(
            compare(OTHER, PLAIN, domain=domain, exact=True)
        )


@pytest.mark.parametrize("name", ["unused_node_same_xy", "unused_node_far"])
@pytest.mark.parametrize("domain", DOMAINS)
def test_reported_files_with_an_unused_node(name: str, domain: Domain) -> None:
    flat = read_surface(REPORTS / "flat0.ply")
    found = compare(read_surface(REPORTS / f"{name}.ply"), flat, domain=domain, exact=True)
    measures = found.measures
    assert (measures.mean_abs, measures.area_compared) == (1.0, 9.0)
    assert (measures.coverage_1, measures.coverage_2) == (1.0, 1.0)
    assert (measures.hausdorff_1_2, measures.hausdorff_2_1) == (1.0, 1.0)
    assert measures.exact is not None
    assert measures.exact.mean_abs == 1.0


@pytest.mark.parametrize("where", STRAY)
def test_nobody_looks_at_unused_nodes(where: str) -> None:
    mesh = _with_nodes(PLAIN, STRAY[where], first=True)
    facts = facts_of(mesh)
    assert (facts.low, facts.high) == ((0.0, 0.0, 0.0), (20.0, 20.0, 0.0))
    assert facts.dropped == {UNUSED: len(STRAY[where])}
    assert facts.nodes == len(mesh.points)
    sight, plain = look_at(mesh), look_at(PLAIN)
    assert sight.part.points.tobytes() == plain.part.points.tobytes()
    assert sight.removed.nodes == {UNUSED: len(STRAY[where])}
    assert np.array_equal(sight.removed.kept, plain.removed.kept + len(STRAY[where]))
    placement = place(mesh, OTHER, "auto")
    assert placement.warnings == ()
    assert placement.surfaces[0].dropped == {UNUSED: len(STRAY[where])}


def _repeated(how: str) -> Surface:
    points, faces = PLAIN.points, PLAIN.faces
    assert faces is not None
    if how == "some":
        return replace(PLAIN, faces=np.concatenate((faces, faces[40:90])))
    if how == "all, turned over":
        return replace(PLAIN, faces=np.concatenate((faces, faces[:, ::-1])))
    if how == "all, from another corner":
        return replace(PLAIN, faces=np.concatenate((faces, np.roll(faces, 1, axis=1))))
    again = faces + np.int32(len(points))  # the mesh stands in its file twice
    points = np.concatenate((points, np.where(points == 0.0, -0.0, points)))
    return Surface(points, np.concatenate((faces, again)))


HOW = ("some", "all, turned over", "all, from another corner", "the mesh twice")


@pytest.mark.parametrize("domain", DOMAINS)
@pytest.mark.parametrize("how", HOW)
def test_repeated_triangles_count_once(how: str, domain: Domain) -> None:
    mesh = _repeated(how)
    found = compare(mesh, OTHER, domain=domain, exact=True)
    assert _numbers(found) == _numbers(compare(PLAIN, OTHER, domain=domain, exact=True))
    assert found.surfaces[0].changed[REPEATED] == len(mesh.faces) - len(PLAIN.faces)  # type: ignore[arg-type]
    assert any(REPEATED in warning for warning in found.warnings)
    alone = compare(mesh, mesh, domain=domain)
    assert (alone.measures.coverage_1, alone.measures.mean_abs) == (1.0, 0.0)


@pytest.mark.parametrize("how", HOW)
def test_repeated_triangles_do_not_hide_each_other(how: str) -> None:
    mesh = _repeated(how)
    assert facts_of(mesh).folded == 0.0
    sight = look_at(mesh)
    assert sight.removed.area == {}
    assert len(sight.part.points) == len(PLAIN.points)


meshes = st.tuples(
    st.lists(st.tuples(*[st.sampled_from([0.0, -0.0, 1.0, 2.0])] * 3), min_size=3, max_size=9),
    st.lists(st.tuples(*[st.integers(0, 2)] * 3), min_size=1, max_size=12),
)


@given(meshes)
def test_the_first_of_equal_triangles_stays(mesh) -> None:
    points, faces = np.array(mesh[0]), np.array(mesh[1], np.int32) % len(mesh[0])
    seen: set[tuple[tuple[float, ...], ...]] = set()
    kept = []
    for face in faces.tolist():
        corners = tuple(sorted(tuple((points[i] + 0.0).tolist()) for i in face))
        if corners not in seen:
            seen.add(corners)
            kept.append(face)
    surface = Surface(points, faces)
    part, number = used_part(surface), nodes_in_use(surface)
    assert part.faces is not None
    assert number[part.faces].tolist() == kept
    assert number.tolist() == sorted({i for face in kept for i in face})
    assert part.points.tobytes() == points[number].tobytes()
    assert used_part(part) is part


@pytest.mark.parametrize("duplicates", ["mean", "max", "min"])
def test_layers_that_are_merged_count_once(duplicates: Duplicates) -> None:
    points, faces = PLAIN.points, PLAIN.faces
    assert faces is not None
    layers = Surface(
        np.concatenate((points, points + np.array([0.0, 0.0, 1.0]))),
        np.concatenate((faces, faces + np.int32(len(points)))),
    )
    found = compare(layers, OTHER, duplicates=duplicates, exact=True).measures
    plain = compare(PLAIN, OTHER, exact=True).measures
    assert found.coverage_1 == plain.coverage_1
    assert found.exact is not None
    assert plain.exact is not None
    assert found.exact.coverage_1 == plain.exact.coverage_1


SHIFT = np.array([0.1, 0.2, 0.05])


def _wavy(mesh: Surface) -> Surface:
    points = mesh.points.copy()
    points[:, 2] += np.sin(points[:, 0] / 3.0) * np.cos(points[:, 1] / 4.0)
    return replace(mesh, points=points)


@pytest.mark.parametrize("where", STRAY)
def test_a_best_fit_knows_no_unused_nodes(where: str) -> None:
    here, there = _wavy(PLAIN), replace(_wavy(PLAIN), points=_wavy(PLAIN).points + SHIFT)
    region = here.points[:, 0] < 15.0
    for first in (True, False):
        stray = _with_nodes(here, STRAY[where], first)
        assert np.array_equal(best_fit(stray, there).matrix, best_fit(here, there).matrix)
        assert np.array_equal(best_fit(there, stray).matrix, best_fit(there, here).matrix)
        extra = np.ones(len(STRAY[where]), bool)
        wide = np.concatenate((extra, region) if first else (region, extra))
        assert np.array_equal(
            best_fit(stray, there, region_1=wide).matrix,
            best_fit(here, there, region_1=region).matrix,
        )


def test_a_best_fit_finds_the_border_of_a_mesh_that_is_there_twice() -> None:
    here, there = _wavy(PLAIN), replace(_wavy(PLAIN), points=_wavy(PLAIN).points + SHIFT)
    assert here.faces is not None
    twice = replace(here, faces=np.concatenate((here.faces, here.faces)))
    assert best_fit(twice, there).overlap == best_fit(here, there).overlap
    assert np.array_equal(best_fit(twice, there).matrix, best_fit(here, there).matrix)


def test_a_cloud_keeps_all_its_nodes() -> None:
    cloud = Surface(PLAIN.points)
    assert used_part(cloud) is cloud
    assert len(nodes_in_use(cloud)) == len(cloud.points)


@pytest.mark.parametrize("odd", [-1, 441, 2**31 - 1])
def test_triangles_of_nodes_that_are_not_there(odd: int) -> None:
    assert PLAIN.faces is not None
    faces = PLAIN.faces.copy()
    faces[7, 1] = odd
    with pytest.raises(InputError, match=f"surface: a triangle names node {odd}, but the nodes"):
        compare(replace(PLAIN, faces=faces), OTHER)
