"""Footprints and the reasons why triangles are not compared, against every face, exactly."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from surfcmp_core import compare
from surfcmp_core.comparing.side import triangles_with_data
from surfcmp_core.domain import (
    Footprint,
    Reason,
    footprint_of_cloud,
    footprint_of_mesh,
    reasons,
)
from surfcmp_core.domain.footprint import DATA, HOLE, OUTSIDE
from surfcmp_core.errors import InputError
from surfcmp_core.spanning_tree import spanning_tree, tree_ends
from surfcmp_core.triangulation import Triangulation, triangulate
from tests.core import oracles
from tests.core.domain_cases import (
    Faces,
    cell,
    flooded,
    is_under,
    lattice,
    longest_sides,
    states_of,
    surface_of,
)
from tests.pairs import Nodes, distinct

pytestmark = pytest.mark.plain


def _beside(nodes: Nodes, queries: Nodes) -> Nodes:
    """Leave out places that are nodes: whether those have data, `at_node` tells."""
    both = np.concatenate((nodes, distinct(queries)))
    return distinct(both)[len(nodes) :]


def _check_mesh(triangulation: Triangulation, faces: Faces, queries: Nodes) -> Footprint:
    nodes = triangulation.nodes
    footprint = footprint_of_mesh(triangulation, faces)
    queries = _beside(nodes, queries)
    assert np.array_equal(states_of(footprint, queries) == DATA, is_under(nodes, faces, queries))
    assert (footprint.at_node[faces.ravel()] == DATA).all()
    at = [nodes[faces[:, i]].T for i in range(3)]
    areas = np.abs(oracles.orientation(*at[0], *at[1], *at[2])) / 2.0
    assert footprint.area == pytest.approx(areas.sum(), rel=1e-12)
    assert footprint.max_edge == np.inf
    return footprint


HALVES = lattice(25, 19) / 2.0 - 2.0
"""Places around and on an 8 by 5 lattice's nodes, edges and triangles."""


@pytest.mark.parametrize("turned", [False, True])
def test_mesh_of_the_whole_hull(turned: bool) -> None:
    triangulation = triangulate(lattice(8, 5))
    faces = triangulation.triangles
    footprint = _check_mesh(triangulation, faces[:, ::-1] if turned else faces, HALVES)
    assert footprint.is_hull
    assert footprint.area == 28.0
    assert (footprint.at_node == DATA).all()


def test_mesh_with_a_hole_and_a_bay() -> None:
    triangulation = triangulate(lattice(8, 5))
    middle = triangulation.nodes[triangulation.triangles].mean(axis=1)
    in_hole = (np.abs(middle - [2.0, 2.0]) < 1.0).all(axis=1)
    in_bay = (np.abs(middle - [6.5, 2.0]) < 1.0).all(axis=1)
    faces = triangulation.triangles[~in_hole & ~in_bay]
    footprint = _check_mesh(triangulation, faces, HALVES)
    assert not footprint.is_hull
    asked = np.array([[2.0, 2.0], [2.25, 1.75], [6.5, 2.0], [9.0, 2.0], [0.5, 0.5], [1.0, 2.0]])
    assert states_of(footprint, asked).tolist() == [HOLE, HOLE, OUTSIDE, OUTSIDE, DATA, DATA]
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
    triangulation = triangulate(lattice(4, 4))
    faces = np.array([[0, 1, 2], [0, 0, 5], [0, 3, 15], [0, 3, 15], [5, 6, 9]], np.int32)
    rng = np.random.default_rng(1)
    number = {tuple(place): k for k, place in enumerate(triangulation.nodes.tolist())}
    order = np.array([number[tuple(place)] for place in lattice(4, 4).tolist()], np.int32)
    _check_mesh(triangulation, order[faces], np.concatenate((rng.random((99, 2)) * 3.0, HALVES)))


def test_mesh_without_any_area() -> None:
    triangulation = triangulate(lattice(3, 3))
    for faces in (np.empty((0, 3), np.int32), np.array([[0, 0, 1]], np.int32)):
        footprint = footprint_of_mesh(triangulation, faces)
        assert footprint.area == 0.0
        assert not (states_of(footprint, HALVES) == DATA).any()


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
    expected = flooded(triangulation, with_data)
    assert np.array_equal(footprint.state[: triangulation.real], expected)
    assert (footprint.state[triangulation.real :] == OUTSIDE).all()


@given(st.integers(0, 10_000), st.sampled_from([0.1, 0.3, 0.5, 1.0, np.inf]))
def test_any_cloud(seed: int, limit: float) -> None:
    rng = np.random.default_rng(seed)
    triangulation = triangulate(rng.random((20, 2)))
    ends = tree_ends(triangulation, spanning_tree(triangulation))
    footprint = footprint_of_cloud(triangulation, ends, limit)
    with_data = longest_sides(triangulation) <= limit
    expected = flooded(triangulation, with_data)
    assert np.array_equal(footprint.state[: triangulation.real], expected)
    queries = rng.random((40, 2)) * 1.2 - 0.1
    nodes = triangulation.nodes
    under = is_under(nodes, triangulation.triangles[with_data], np.concatenate((queries, nodes)))
    assert np.array_equal(states_of(footprint, queries) == DATA, under[:40])
    assert np.array_equal(footprint.at_node == DATA, under[40:])
    assert footprint.max_edge == limit
    assert footprint.is_hull == bool(with_data.all())


def test_triangles_with_data_of_meshes_and_of_limits_given() -> None:
    nodes = np.concatenate((lattice(6, 6), lattice(6, 6) + np.array([15.0, 0.0])))
    triangulation = triangulate(nodes)
    short = triangulation.triangles[longest_sides(triangulation) < 2.0]
    result = compare(
        surface_of(nodes, short, "a"), surface_of(nodes + 0.25, None, "b"), max_edge=2.0
    )
    for which in (0, 1):
        expected = longest_sides(result.triangulations[which]) < 2.0
        assert np.array_equal(triangles_with_data(result, which), expected)


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
