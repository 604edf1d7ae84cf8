"""Footprints and the reasons why triangles are not compared, against every face, exactly."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core import Comparison, Surface, compare
from surfcmp_core.comparing.comparison import Domain
from surfcmp_core.comparing.side import triangles_with_data
from surfcmp_core.domain import (
    Footprint,
    Reason,
    footprint_of_cloud,
    footprint_of_mesh,
    reasons,
)
from surfcmp_core.domain.footprint import DATA, HOLE, OUTSIDE, states_at
from surfcmp_core.domain.spacing import spacing_at
from surfcmp_core.errors import InputError
from surfcmp_core.localisation import locate_from
from surfcmp_core.spanning_tree import spanning_tree, tree_ends
from surfcmp_core.triangulation import Triangulation, triangulate
from tests.core import oracles
from tests.pairs import Nodes, distinct

Faces = NDArray[np.int32]
States = NDArray[np.uint8]


def _lattice(columns: int, rows: int) -> Nodes:
    x, y = np.meshgrid(np.arange(columns), np.arange(rows))
    return np.column_stack((x.ravel(), y.ravel())).astype(np.float64)


def _under(nodes: Nodes, faces: Faces, queries: Nodes) -> NDArray[np.bool_]:
    """Which places lie under a face that is no line, borders included; every face is tried."""
    whole = oracles.exact(np.concatenate((nodes, queries)))
    x, y = whole[: len(nodes)].T
    px, py = whole[len(nodes) :].T
    found = np.zeros(len(queries), bool)
    for a, b, c in faces.tolist():
        turn = oracles.sign(oracles.orientation(x[a], y[a], x[b], y[b], x[c], y[c]))
        sides = [
            turn * oracles.orientation(x[u], y[u], x[v], y[v], px, py) >= 0
            for u, v in ((a, b), (b, c), (c, a))
        ]
        if turn:
            found |= np.logical_and.reduce(sides)
    return found


def _beside(nodes: Nodes, queries: Nodes) -> Nodes:
    """Leave out places that are nodes: whether those have data, `at_node` tells."""
    both = np.concatenate((nodes, distinct(queries)))
    return distinct(both)[len(nodes) :]


def _states(footprint: Footprint, queries: Nodes) -> States:
    t = footprint.triangulation
    return states_at(footprint, queries, locate_from(t, queries, np.zeros(len(queries), np.int32)))


def _flooded(triangulation: Triangulation, with_data: NDArray[np.bool_]) -> States:
    """DATA, or OUTSIDE where triangles without data lead to the hull, else HOLE."""
    state = np.where(with_data, DATA, HOLE)
    neighbours = triangulation.twin.reshape(-1, 3) // 3
    is_ghost = neighbours >= triangulation.real
    while True:
        beside = is_ghost | (np.append(state, [OUTSIDE])[np.where(is_ghost, -1, neighbours)] == 1)
        more = (state == HOLE) & beside[: triangulation.real].any(axis=1)
        if not more.any():
            return np.asarray(state, np.uint8)
        state[more] = OUTSIDE


def _check_mesh(triangulation: Triangulation, faces: Faces, queries: Nodes) -> Footprint:
    nodes = triangulation.nodes
    footprint = footprint_of_mesh(triangulation, faces)
    queries = _beside(nodes, queries)
    assert np.array_equal(_states(footprint, queries) == DATA, _under(nodes, faces, queries))
    assert (footprint.at_node[faces.ravel()] == DATA).all()
    at = [nodes[faces[:, i]].T for i in range(3)]
    areas = np.abs(oracles.orientation(*at[0], *at[1], *at[2])) / 2.0
    assert footprint.area == pytest.approx(areas.sum(), rel=1e-12)
    assert footprint.max_edge == np.inf
    return footprint


HALVES = _lattice(25, 19) / 2.0 - 2.0
"""Places around and on an 8 by 5 lattice's nodes, edges and triangles."""


@pytest.mark.parametrize("turned", [False, True])
def test_mesh_of_the_whole_hull(turned: bool) -> None:
    triangulation = triangulate(_lattice(8, 5))
    faces = triangulation.triangles
    footprint = _check_mesh(triangulation, faces[:, ::-1] if turned else faces, HALVES)
    assert footprint.is_hull
    assert footprint.area == 28.0
    assert (footprint.at_node == DATA).all()


def test_mesh_with_a_hole_and_a_bay() -> None:
    triangulation = triangulate(_lattice(8, 5))
    middle = triangulation.nodes[triangulation.triangles].mean(axis=1)
    in_hole = (np.abs(middle - [2.0, 2.0]) < 1.0).all(axis=1)
    in_bay = (np.abs(middle - [6.5, 2.0]) < 1.0).all(axis=1)
    faces = triangulation.triangles[~in_hole & ~in_bay]
    footprint = _check_mesh(triangulation, faces, HALVES)
    assert not footprint.is_hull
    asked = np.array([[2.0, 2.0], [2.25, 1.75], [6.5, 2.0], [9.0, 2.0], [0.5, 0.5], [1.0, 2.0]])
    assert _states(footprint, asked).tolist() == [HOLE, HOLE, OUTSIDE, OUTSIDE, DATA, DATA]
    node = {tuple(place): k for k, place in enumerate(triangulation.nodes.tolist())}
    assert footprint.at_node[node[2.0, 2.0]] == HOLE
    assert footprint.at_node[node[1.0, 2.0]] == DATA
    assert footprint.at_node[node[7.0, 2.0]] == OUTSIDE


def test_mesh_with_other_diagonals_than_delaunay() -> None:
    nodes = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 1.0], [0.0, 1.0], [5.0, 4.0], [5.0, -4.0]])
    faces = np.array([[0, 1, 4], [1, 0, 5]], np.int32)  # over the nodes 2 and 3, or beside them
    triangulation = triangulate(nodes)
    queries = np.random.default_rng(0).random((400, 2)) * [12.0, 12.0] - [1.0, 5.0]
    _check_mesh(triangulation, faces, np.concatenate((queries, nodes)))


def test_mesh_with_faces_over_each_other_and_faces_that_are_lines() -> None:
    triangulation = triangulate(_lattice(4, 4))
    faces = np.array([[0, 1, 2], [0, 0, 5], [0, 3, 15], [0, 3, 15], [5, 6, 9]], np.int32)
    rng = np.random.default_rng(1)
    number = {tuple(place): k for k, place in enumerate(triangulation.nodes.tolist())}
    order = np.array([number[tuple(place)] for place in _lattice(4, 4).tolist()], np.int32)
    _check_mesh(triangulation, order[faces], np.concatenate((rng.random((99, 2)) * 3.0, HALVES)))


def test_mesh_without_any_area() -> None:
    triangulation = triangulate(_lattice(3, 3))
    for faces in (np.empty((0, 3), np.int32), np.array([[0, 0, 1]], np.int32)):
        footprint = footprint_of_mesh(triangulation, faces)
        assert footprint.area == 0.0
        assert not (_states(footprint, HALVES) == DATA).any()


cell = st.tuples(st.integers(0, 5), st.integers(0, 4))


@given(st.lists(cell, min_size=5, max_size=16, unique=True), st.integers(0, 10_000))
def test_any_mesh(cells: list[tuple[int, int]], seed: int) -> None:
    rng = np.random.default_rng(seed)
    nodes = np.array(cells, np.float64)
    try:
        triangulation = triangulate(nodes)
    except InputError:
        return
    of_its_own = triangulation.triangles[rng.random(triangulation.real) < 0.7]
    others = rng.integers(0, len(nodes), (rng.integers(0, 3), 3)).astype(np.int32)
    _check_mesh(triangulation, np.concatenate((of_its_own, others)), HALVES)
    footprint = footprint_of_mesh(triangulation, of_its_own)
    kept = {tuple(t) for t in of_its_own.tolist()}
    with_data = np.array([tuple(t) in kept for t in triangulation.triangles.tolist()])
    expected = _flooded(triangulation, with_data)
    assert np.array_equal(footprint.state[: triangulation.real], expected)
    assert (footprint.state[triangulation.real :] == OUTSIDE).all()


def _longest(triangulation: Triangulation) -> NDArray[np.float64]:
    corners = triangulation.nodes[triangulation.triangles]
    sides = corners - np.roll(corners, 1, axis=1)
    return np.asarray(np.hypot(sides[..., 0], sides[..., 1]).max(axis=1))


@given(st.integers(0, 10_000), st.sampled_from([0.1, 0.3, 0.5, 1.0, np.inf]))
def test_any_cloud(seed: int, limit: float) -> None:
    rng = np.random.default_rng(seed)
    triangulation = triangulate(rng.random((20, 2)))
    ends = tree_ends(triangulation, spanning_tree(triangulation))
    footprint = footprint_of_cloud(triangulation, ends, limit)
    with_data = _longest(triangulation) <= limit
    expected = _flooded(triangulation, with_data)
    assert np.array_equal(footprint.state[: triangulation.real], expected)
    queries = rng.random((40, 2)) * 1.2 - 0.1
    nodes = triangulation.nodes
    under = _under(nodes, triangulation.triangles[with_data], np.concatenate((queries, nodes)))
    assert np.array_equal(_states(footprint, queries) == DATA, under[:40])
    assert np.array_equal(footprint.at_node == DATA, under[40:])
    assert footprint.max_edge == limit
    assert footprint.is_hull == bool(with_data.all())


def _far_along(tree: NDArray[np.int32], node: int, steps: int) -> list[tuple[int, int]]:
    """Edges of a tree up to so many steps from a node."""
    found: set[tuple[int, int]] = set()
    reached = {node}
    for _ in range(steps):
        found |= {(a, b) for a, b in tree.tolist() if a in reached or b in reached}
        reached |= {v for edge in found for v in edge}
    return sorted(found)


@given(st.lists(cell, min_size=3, max_size=16, unique=True), st.integers(0, 7), st.integers(0, 99))
def test_spacing_is_the_median_of_the_edges_around(
    cells: list[tuple[int, int]], steps: int, seed: int
) -> None:
    nodes = np.array(cells, np.float64)
    if seed % 2:
        nodes += np.random.default_rng(seed).normal(size=nodes.shape) * 0.2
    try:
        triangulation = triangulate(nodes)
    except InputError:
        return
    ends = tree_ends(triangulation, spanning_tree(triangulation))
    found = spacing_at(triangulation.nodes, ends, steps + 1)
    for v in range(len(nodes)):
        around = _far_along(ends, v, steps + 1)
        lengths = sorted(float(np.hypot(*(nodes[a] - nodes[b]))) for a, b in around)
        assert found[v] == pytest.approx(lengths[(len(lengths) - 1) // 2], rel=1e-12)


def _derived(triangulation: Triangulation, ends: NDArray[np.int32]) -> NDArray[np.float64]:
    """Which limit each triangle has: the definition, in numpy."""
    nodes = triangulation.nodes
    spacing = spacing_at(nodes, ends)
    lengths = np.linalg.norm(nodes[ends[:, 0]] - nodes[ends[:, 1]], axis=1)
    factor = 4.0 * np.quantile(lengths / spacing[ends].max(axis=1), 0.95)
    limits = np.minimum(factor * spacing, 40.0 * np.quantile(lengths, 0.95))
    return np.asarray(np.sort(limits[triangulation.triangles], axis=1)[:, 1])


@pytest.mark.parametrize("seed", range(6))
def test_clouds_whose_edges_are_limited_by_the_spacing_around(seed: int) -> None:
    rng = np.random.default_rng(seed)
    nodes = rng.random((300, 2)) ** (1 + seed % 3)
    triangulation = triangulate(nodes)
    ends = tree_ends(triangulation, spanning_tree(triangulation))
    footprint = footprint_of_cloud(triangulation, ends, None)
    limits = _derived(triangulation, ends)
    with_data = _longest(triangulation) <= limits
    assert 10 < with_data.sum() < triangulation.real
    expected = _flooded(triangulation, with_data)
    assert np.array_equal(footprint.state[: triangulation.real], expected)
    assert footprint.max_edge >= limits.max()
    for power in (-60, 40):
        scaled = replace(triangulation, nodes=np.ldexp(nodes, power))
        again = footprint_of_cloud(scaled, ends, None)
        assert np.array_equal(again.state, footprint.state)
        assert again.max_edge == np.ldexp(footprint.max_edge, power)


def _nested(seed: int) -> Nodes:
    """Spacing 1 over 60 by 60, a tenth of that in the middle; a hole of eight spacings in each."""
    rng = np.random.default_rng(seed)
    wide = _lattice(61, 61) + rng.uniform(-0.2, 0.2, (61 * 61, 2))
    dense = (_lattice(121, 121) + rng.uniform(-0.2, 0.2, (121 * 121, 2))) * 0.1 + 24.0
    outer = (np.abs(wide - 30.0) > 6.0).any(axis=1) & (np.hypot(*(wide - 12.0).T) > 8.0)
    inner = np.hypot(*(dense - 30.0).T) > 0.8
    return np.concatenate((wide[outer], dense[inner]))


@pytest.mark.parametrize("seed", range(3))
def test_neither_is_the_sparse_part_cut_nor_a_hole_of_the_dense_part_bridged(seed: int) -> None:
    triangulation = triangulate(_nested(seed))
    ends = tree_ends(triangulation, spanning_tree(triangulation))
    covered = footprint_of_cloud(triangulation, ends, None).covered
    middle = triangulation.nodes[triangulation.triangles].mean(axis=1)
    sparse = (np.abs(middle - 30.0) > 10.0).any(axis=1) & (np.hypot(*(middle - 12.0).T) > 10.0)
    sparse &= (np.abs(middle - 30.0) < 29.0).all(axis=1)
    dense = (np.abs(middle - 30.0) < 5.8).all(axis=1) & (np.hypot(*(middle - 30.0).T) > 1.0)
    inner_hole = np.hypot(*(middle - 30.0).T) < 0.6
    outer_hole = np.hypot(*(middle - 12.0).T) < 6.0
    for inside, has_data in (
        (sparse, True),
        (dense, True),
        (inner_hole, False),
        (outer_hole, False),
    ):
        assert inside.any()
        assert (covered[inside] == has_data).all()


def test_strays_far_off_are_no_surface() -> None:
    rng = np.random.default_rng(4)
    nodes = np.concatenate(
        (
            _lattice(60, 60) + rng.uniform(-0.3, 0.3, (3600, 2)),
            rng.uniform(-1500.0, 1500.0, (40, 2)),
        )
    )
    triangulation = triangulate(nodes)
    ends = tree_ends(triangulation, spanning_tree(triangulation))
    footprint = footprint_of_cloud(triangulation, ends, None)
    assert footprint.area == pytest.approx(59.0**2, rel=0.02)


def test_derived_limits_do_not_depend_on_roles_or_order() -> None:
    rng = np.random.default_rng(7)
    first, second = (_surface(_nested(seed) + 0.3 * seed, None, "ab"[seed]) for seed in range(2))
    result, swapped = compare(first, second), compare(second, first)
    shuffled = [
        replace(s, points=s.points[rng.permutation(len(s.points))]) for s in (first, second)
    ]
    again = compare(*shuffled)
    assert swapped.max_edges == result.max_edges[::-1]
    assert again.max_edges == result.max_edges
    assert 0.9 < result.measures.coverage_1 < 1.0
    assert np.array_equal(again.reason, result.reason)
    assert np.array_equal(again.united.triangles, result.united.triangles)
    compared = [
        {
            tuple(sorted(map(tuple, c.united.nodes[t].tolist())))
            for t in c.united.triangles[c.compared]
        }
        for c in (result, swapped)
    ]
    assert compared[0] == compared[1]
    for which in (0, 1):
        with_data = triangles_with_data(result, which)
        assert np.array_equal(triangles_with_data(swapped, 1 - which), with_data)
        assert not with_data.all()
        t = result.triangulations[which]
        limits = _derived(t, tree_ends(t, spanning_tree(t)))
        assert np.array_equal(with_data, _longest(t) <= limits)


def test_triangles_with_data_of_meshes_and_of_limits_given() -> None:
    nodes = np.concatenate((_lattice(6, 6), _lattice(6, 6) + np.array([15.0, 0.0])))
    triangulation = triangulate(nodes)
    short = triangulation.triangles[_longest(triangulation) < 2.0]
    result = compare(_surface(nodes, short, "a"), _surface(nodes + 0.25, None, "b"), max_edge=2.0)
    for which in (0, 1):
        expected = _longest(result.triangulations[which]) < 2.0
        assert np.array_equal(triangles_with_data(result, which), expected)


def test_edges_of_a_cloud_may_be_four_times_its_spacing() -> None:
    nodes = _lattice(10, 10)
    nodes = np.concatenate((nodes, nodes + np.array([14.0, 0.0])))
    triangulation = triangulate(nodes)
    ends = tree_ends(triangulation, spanning_tree(triangulation))
    footprint = footprint_of_cloud(triangulation, ends, None)
    assert footprint.max_edge == 4.0
    asked = np.array([[5.0, 5.0], [11.0, 5.0], [15.0, 5.0], [-1.0, 5.0]])
    assert _states(footprint, asked).tolist() == [DATA, OUTSIDE, DATA, OUTSIDE]
    assert footprint.area == 2 * 81.0


def test_reasons() -> None:
    states = np.array([DATA, OUTSIDE, HOLE])
    state_1, state_2 = (part.ravel() for part in np.meshgrid(states, states, indexing="ij"))
    found = reasons(state_1, state_2, np.ones(9))
    expected = [
        *(Reason.COMPARED, Reason.OUTSIDE_2, Reason.HOLE),
        *(Reason.OUTSIDE_1, Reason.OUTSIDE_1, Reason.OUTSIDE_1),
        *(Reason.HOLE, Reason.OUTSIDE_2, Reason.HOLE),
    ]
    assert found.tolist() == expected
    flat = reasons(state_1, state_2, np.zeros(9))
    assert flat.tolist() == [Reason.DEGENERATE, *expected[1:]]


# through the whole comparison


def _surface(nodes: Nodes, faces: Faces | None, name: str) -> Surface:
    return Surface(np.column_stack((nodes, nodes[:, 0] - nodes[:, 1])), faces, name)


def _some_faces(rng: np.random.Generator, nodes: Nodes, share: float) -> Faces:
    triangulation = triangulate(nodes)
    return triangulation.triangles[rng.random(triangulation.real) < share]


def _in_hull(nodes: Nodes, queries: Nodes) -> NDArray[np.bool_]:
    return _under(nodes, triangulate(nodes).triangles, queries)


def _check_domain(result: Comparison, domain: Domain) -> None:
    """A triangle is compared where its nodes and its centroid have data in both."""
    united = result.united
    centroids = united.nodes[united.triangles].sum(axis=1) / 3.0
    expected = np.ones(len(united.triangles), bool)
    for surface, z in zip(result.surfaces, (result.z1, result.z2), strict=True):
        nodes = surface.points[:, :2]
        if domain == "plane":
            at_nodes = np.ones(len(united.nodes), bool)
            assert not np.isnan(z).any()
        elif domain == "hull":
            at_nodes = _in_hull(nodes, united.nodes)
            assert np.array_equal(np.isnan(z), ~at_nodes)
        else:
            assert surface.faces is not None
            at_nodes = _under(nodes, surface.faces, united.nodes)
            expected &= _under(nodes, surface.faces, centroids)
        expected &= at_nodes[united.triangles].all(axis=1)
    assert np.array_equal(result.compared, expected)
    assert np.array_equal(np.isnan(result.mean_abs), ~expected)
    assert np.array_equal(np.isnan(result.area), ~expected)
    assert set(result.reason[~expected].tolist()) <= {1, 2, 3}


@pytest.mark.parametrize("domain", ["data", "hull", "plane"])
@pytest.mark.parametrize("seed", range(12))
def test_what_is_compared(domain: Domain, seed: int) -> None:
    rng = np.random.default_rng(seed)
    parts = []
    for k in range(2):
        cells = rng.integers(0, 7, (25, 2)) + (0.5 * k if seed % 2 else 0.0)
        nodes = distinct(cells.astype(np.float64)) if seed % 3 else rng.random((25, 2)) * 7.0
        parts.append((nodes, _some_faces(rng, nodes, 0.85)))
    first = _surface(*parts[0], "a")
    second = _surface(*parts[1], "b")
    _check_domain(compare(first, second, domain=domain), domain)


def test_hole_and_outline_are_told_apart() -> None:
    nodes = _lattice(12, 9)
    triangulation = triangulate(nodes)
    middle = nodes[triangulation.triangles].mean(axis=1)
    in_hole = (np.abs(middle - [5.0, 4.0]) < 2.0).all(axis=1)
    first = _surface(nodes, triangulation.triangles[~in_hole], "a")
    inner = _lattice(14, 11) * 0.73 + 0.61  # reaches over the right border of the first
    inner[:, 0] += 3.0
    second = _surface(inner, triangulate(inner).triangles, "b")
    result = compare(first, second)
    united = result.united
    centroids = united.nodes[united.triangles].mean(axis=1)
    for reason, inside in (
        (Reason.HOLE, (np.abs(centroids - [5.0, 4.0]) < 1.0).all(axis=1)),
        (Reason.OUTSIDE_1, centroids[:, 0] > 11.5),
        (Reason.OUTSIDE_2, centroids[:, 0] < 2.5),
        (Reason.COMPARED, (np.abs(centroids - [9.0, 2.5]) < 0.8).all(axis=1)),
    ):
        assert inside.any()
        assert (result.reason[inside] == reason).all()
    swapped = compare(second, first)
    assert swapped.measures.area_compared == pytest.approx(result.measures.area_compared)
    # what lies outside both is called outside 1
    for reason in (Reason.COMPARED, Reason.HOLE):
        assert (swapped.reason == reason).sum() == (result.reason == reason).sum()


def test_ghosts_of_an_edge_on_the_others_hull() -> None:
    """Nodes of one grid on the open hull edges of the other have data there."""
    first = _surface(np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]), None, "a")
    second = _surface(np.array([[2.0, 0.0], [4.0, 2.0], [2.0, 4.0], [0.0, 2.0]]), None, "b")
    for domain in ("data", "hull"):
        result = compare(first, second, domain=domain, max_edge=np.inf)
        assert not np.isnan(result.z1).any()
        assert result.measures.area_compared == 8.0
        assert result.measures.coverage_1 == 0.5
        assert result.measures.coverage_2 == 1.0


def test_the_limit_for_clouds_is_used_and_reported() -> None:
    nodes = np.concatenate((_lattice(6, 6), _lattice(6, 6) + np.array([15.0, 0.0])))
    first, second = _surface(nodes, None, "a"), _surface(nodes * [1.0, 0.9], None, "b")
    for limit, used, area in ((None, (4.0, 4.0), 45.0), (2.0, (2.0, 2.0), 45.0), (np.inf,) * 3):
        result = compare(first, second, max_edge=limit)
        if limit == np.inf:
            assert result.max_edges == (np.inf, np.inf)
            assert result.measures.area_compared == pytest.approx(20.0 * 4.5)
        else:
            assert result.max_edges == pytest.approx(used)
            assert result.measures.area_compared == pytest.approx(area)
    mesh = _surface(nodes, triangulate(nodes).triangles, "a")
    assert compare(mesh, second, max_edge=2.0).max_edges == (np.inf, 2.0)
