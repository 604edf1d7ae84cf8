"""What is compared, through the whole comparison."""

import numpy as np
import pytest
from numpy.typing import NDArray

from surfcmp_core import Comparison, compare
from surfcmp_core.comparing.options import Domain
from surfcmp_core.domain import (
    Reason,
)
from surfcmp_core.triangulation import triangulate
from tests.core.domain_cases import Faces, is_under, lattice, surface_of
from tests.pairs import Nodes, distinct

pytestmark = pytest.mark.plain


def _some_faces(rng: np.random.Generator, nodes: Nodes, share: float) -> Faces:
    triangulation = triangulate(nodes)
    return triangulation.triangles[rng.random(triangulation.real) < share]


def _in_hull(nodes: Nodes, queries: Nodes) -> NDArray[np.bool_]:
    return is_under(nodes, triangulate(nodes).triangles, queries)


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
            at_nodes = is_under(nodes, surface.faces, united.nodes)
            expected &= is_under(nodes, surface.faces, centroids)
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
    first = surface_of(*parts[0], "a")
    second = surface_of(*parts[1], "b")
    _check_domain(compare(first, second, domain=domain), domain)


def test_hole_and_outline_are_told_apart() -> None:
    nodes = lattice(12, 9)
    triangulation = triangulate(nodes)
    middle = nodes[triangulation.triangles].mean(axis=1)
    in_hole = (np.abs(middle - [5.0, 4.0]) < 2.0).all(axis=1)
    first = surface_of(nodes, triangulation.triangles[~in_hole], "a")
    inner = lattice(14, 11) * 0.73 + 0.61  # reaches over the right border of the first
    inner[:, 0] += 3.0
    second = surface_of(inner, triangulate(inner).triangles, "b")
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
    first = surface_of(np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]), None, "a")
    second = surface_of(np.array([[2.0, 0.0], [4.0, 2.0], [2.0, 4.0], [0.0, 2.0]]), None, "b")
    for domain in ("data", "hull"):
        result = compare(first, second, domain=domain, max_edge=np.inf)
        assert not np.isnan(result.z1).any()
        assert result.measures.area_compared == 8.0
        assert result.measures.coverage_1 == 0.5
        assert result.measures.coverage_2 == 1.0


def test_the_limit_for_clouds_is_used_and_reported() -> None:
    nodes = np.concatenate((lattice(6, 6), lattice(6, 6) + np.array([15.0, 0.0])))
    first, second = surface_of(nodes, None, "a"), surface_of(nodes * [1.0, 0.9], None, "b")
    for limit, used, area in ((None, (4.0, 4.0), 45.0), (2.0, (2.0, 2.0), 45.0), (np.inf,) * 3):
        result = compare(first, second, max_edge=limit)
        if limit == np.inf:
            assert result.max_edges == (np.inf, np.inf)
            assert result.measures.area_compared == pytest.approx(20.0 * 4.5)
        else:
            assert result.max_edges == pytest.approx(used)
            assert result.measures.area_compared == pytest.approx(area)
    mesh = surface_of(nodes, triangulate(nodes).triangles, "a")
    assert compare(mesh, second, max_edge=2.0).max_edges == (np.inf, 2.0)
