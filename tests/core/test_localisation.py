"""Localisation against every triangle and every hull edge, exactly."""

import numpy as np
import pytest
from numpy.typing import NDArray

from surfcmp_core.grid import safe_scale
from surfcmp_core.localisation import locate_along_tree, locate_from
from surfcmp_core.spanning_tree import spanning_tree, tree_ends
from surfcmp_core.triangulation import Triangulation, triangulate
from tests.core import oracles
from tests.pairs import FAMILIES, Nodes, pair_of

pytestmark = pytest.mark.plain


def _check(target: Triangulation, queries: Nodes, found: NDArray[np.int32]) -> None:
    """A real triangle holds its node; a ghost's hull edge has it strictly outside."""
    assert found.dtype == np.int32
    assert found.shape == (len(queries),)
    whole = oracles.exact(np.concatenate((target.nodes, queries)))
    at, places = whole[: len(target.nodes)], whole[len(target.nodes) :]
    corners = target.start.reshape(-1, 3)[found]
    is_ghost = found >= target.real
    assert np.array_equal(is_ghost, corners[:, 2] < 0)
    (ax, ay), (bx, by), (cx, cy) = (at[corners[:, i]].T for i in range(3))
    px, py = places.T
    ab = oracles.orientation(ax, ay, bx, by, px, py)
    bc = oracles.orientation(bx, by, cx, cy, px, py)
    ca = oracles.orientation(cx, cy, ax, ay, px, py)
    assert ((ab >= 0) & (bc >= 0) & (ca >= 0))[~is_ghost].all()
    assert (ab[is_ghost] > 0).all()  # a ghost's hull edge runs clockwise around the hull
    # outside the hull is exactly where a hull edge has the node outside
    ghosts = target.start[3 * target.real :].reshape(-1, 3)
    outside = np.zeros(len(queries), bool)
    for (x, y), (u, v) in zip(at[ghosts[:, 0]], at[ghosts[:, 1]], strict=True):
        outside |= oracles.orientation(x, y, u, v, px, py) > 0
    assert np.array_equal(outside, is_ghost)


@pytest.mark.parametrize("family", FAMILIES)
def test_nodes_of_one_grid_in_the_triangles_of_the_other(family: str) -> None:
    rng = np.random.default_rng(0)
    for seed in range(12):
        pair = pair_of(family, seed)
        scale = safe_scale(pair.first, pair.second)
        one, other = triangulate(pair.first * scale), triangulate(pair.second * scale)
        for target, source in ((one, other), (other, one), (one, one)):
            ends = tree_ends(source, spanning_tree(source))
            _check(target, source.nodes, locate_along_tree(target, source.nodes, ends))
            hints = rng.integers(0, len(target.start) // 3, len(source.nodes)).astype(np.int32)
            before = hints.copy()
            _check(target, source.nodes, locate_from(target, source.nodes, hints))
            assert np.array_equal(hints, before)


def test_walks_from_anywhere_over_a_larger_triangulation() -> None:
    rng = np.random.default_rng(1)
    target = triangulate(rng.random((3000, 2)))
    queries = rng.random((3000, 2)) * 1.5 - 0.25
    hints = rng.integers(0, len(target.start) // 3, len(queries)).astype(np.int32)
    _check(target, queries, locate_from(target, queries, hints))


def test_nodes_on_the_line_of_a_hull_edge() -> None:
    target = triangulate(np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [1.0, 1.0]]))
    queries = np.array([[-1.0, 0.0], [0.0, 0.0], [0.5, 0.0], [2.0, 0.0], [3.0, 0.0], [9.0, 0.0]])
    for hint in range(len(target.start) // 3):
        found = locate_from(target, queries, np.full(len(queries), hint, np.int32))
        _check(target, queries, found)
        assert np.array_equal(found >= target.real, [True, False, False, False, False, True])


def test_nothing_to_locate() -> None:
    target = triangulate(np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]))
    assert len(locate_from(target, np.empty((0, 2)), np.empty(0, np.int32))) == 0
