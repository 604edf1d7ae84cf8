"""Minimum spanning trees against Kruskal's, in whole numbers."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from surfcmp_core.grid import safe_scale
from surfcmp_core.spanning_tree import spanning_tree, tree_ends
from surfcmp_core.triangulation import triangulate
from tests import pairs
from tests.core import oracles
from tests.pairs import FAMILIES, Nodes, pair_of

pytestmark = pytest.mark.plain


def _check(nodes: Nodes) -> None:
    """The tree joins all nodes, is as short as any, and its influence circles are empty."""
    triangulation = triangulate(nodes)
    tree = spanning_tree(triangulation)
    ends = tree_ends(triangulation, tree)
    assert tree.dtype == ends.dtype == np.int32
    assert tree.shape == (len(nodes) - 1,)
    assert ends.shape == (len(nodes) - 1, 2)
    start, twin = triangulation.start, triangulation.twin
    assert np.array_equal(np.column_stack((start[tree], start[twin[tree]])), ends)
    part = list(range(len(nodes)))
    for a, b in ends.tolist():
        p, q = part[a], part[b]
        assert p != q, "a circle in the tree"
        part = [p if k == q else k for k in part]
    # all minimum trees have the same lengths, so these are as short one by one
    found = sorted(oracles.squares(nodes, ends.tolist()))
    assert found == sorted(oracles.squares(nodes, oracles.shortest_tree(nodes)))
    x, y = oracles.exact(nodes).T
    for a, b in ends.tolist():
        across = (x - x[a]) * (x - x[b]) + (y - y[a]) * (y - y[b])
        across[[a, b]] = 1
        assert (across > 0).all(), "a node in an influence circle, or on it"


@pytest.mark.parametrize("family", FAMILIES)
def test_tree_is_as_short_as_any(family: str) -> None:
    for seed in range(12):
        nodes = pair_of(family, seed).first
        _check(nodes * safe_scale(nodes))


@pytest.mark.parametrize("family", ["uniform", "lattice", "clustered", "circle_of_integers"])
def test_tree_of_more_nodes(family: str) -> None:
    pair = pair_of(family, 1, most=250)
    nodes = max(pair.first, pair.second, key=len)
    _check(nodes * safe_scale(nodes))


def test_tree_of_a_lattice() -> None:
    x, y = np.meshgrid(np.arange(12), np.arange(9))
    _check(np.column_stack((x.ravel(), y.ravel())).astype(np.float64))


def test_lengths_that_differ_in_the_last_bit() -> None:
    rng = np.random.default_rng(3)
    x, y = np.meshgrid(np.arange(1.0, 7.0), np.arange(1.0, 7.0))
    nodes = np.column_stack((x.ravel(), y.ravel()))
    _check(nodes + rng.integers(-1, 2, nodes.shape) * 2.0**-50)


cell = st.tuples(st.integers(0, 5), st.integers(0, 5))


@given(st.lists(cell, min_size=3, max_size=14, unique=True))
def test_tree_of_any_small_set(cells: list[tuple[int, int]]) -> None:
    nodes = np.array(cells, np.float64)
    assume(not pairs.is_flat(nodes))
    _check(nodes)
