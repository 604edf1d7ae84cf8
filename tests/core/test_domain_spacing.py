"""Edges of clouds are limited by the spacing around."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core import compare
from surfcmp_core.comparing.side import triangles_with_data
from surfcmp_core.domain import (
    footprint_of_cloud,
)
from surfcmp_core.domain.footprint import DATA, OUTSIDE
from surfcmp_core.domain.spacing import spacing_at
from surfcmp_core.errors import InputError
from surfcmp_core.spanning_tree import spanning_tree, tree_ends
from surfcmp_core.triangulation import Triangulation, triangulate
from tests.core.domain_cases import cell, flooded, lattice, longest_sides, states_of, surface_of
from tests.pairs import Nodes


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
    with_data = longest_sides(triangulation) <= limits
    assert 10 < with_data.sum() < triangulation.real
    expected = flooded(triangulation, with_data)
    assert np.array_equal(footprint.state[: triangulation.real], expected)
    assert footprint.max_edge >= limits.max()
    for power in (-60, 40):
        scaled = triangulation._replace(nodes=np.ldexp(nodes, power))
        again = footprint_of_cloud(scaled, ends, None)
        assert np.array_equal(again.state, footprint.state)
        assert again.max_edge == np.ldexp(footprint.max_edge, power)


def _nested(seed: int) -> Nodes:
    """Spacing 1 over 60 by 60, a tenth of that in the middle; a hole of eight spacings in each."""
    rng = np.random.default_rng(seed)
    wide = lattice(61, 61) + rng.uniform(-0.2, 0.2, (61 * 61, 2))
    dense = (lattice(121, 121) + rng.uniform(-0.2, 0.2, (121 * 121, 2))) * 0.1 + 24.0
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
            lattice(60, 60) + rng.uniform(-0.3, 0.3, (3600, 2)),
            rng.uniform(-1500.0, 1500.0, (40, 2)),
        )
    )
    triangulation = triangulate(nodes)
    ends = tree_ends(triangulation, spanning_tree(triangulation))
    footprint = footprint_of_cloud(triangulation, ends, None)
    assert footprint.area == pytest.approx(59.0**2, rel=0.02)


def test_derived_limits_do_not_depend_on_roles_or_order() -> None:
    rng = np.random.default_rng(7)
    first, second = (surface_of(_nested(seed) + 0.3 * seed, None, "ab"[seed]) for seed in range(2))
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
        assert np.array_equal(with_data, longest_sides(t) <= limits)


def test_edges_of_a_cloud_may_be_four_times_its_spacing() -> None:
    nodes = lattice(10, 10)
    nodes = np.concatenate((nodes, nodes + np.array([14.0, 0.0])))
    triangulation = triangulate(nodes)
    ends = tree_ends(triangulation, spanning_tree(triangulation))
    footprint = footprint_of_cloud(triangulation, ends, None)
    assert footprint.max_edge == 4.0
    asked = np.array([[5.0, 5.0], [11.0, 5.0], [15.0, 5.0], [-1.0, 5.0]])
    assert states_of(footprint, asked).tolist() == [DATA, OUTSIDE, DATA, OUTSIDE]
    assert footprint.area == 2 * 81.0
