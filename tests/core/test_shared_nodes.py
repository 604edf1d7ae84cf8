"""Nodes of both grids, found along the curve."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from surfcmp_core.grid import box_of, grid_of, shared_nodes
from surfcmp_core.surface import Surface
from tests.invariants import shared_by_hand
from tests.pairs import FAMILIES, Nodes, distinct, pair_of

pytestmark = pytest.mark.plain


def _check(first: Nodes, second: Nodes) -> None:
    surfaces = [Surface(np.column_stack((nodes, nodes[:, 0]))) for nodes in (first, second)]
    box = box_of(*surfaces)
    one, other = (grid_of(surface, box=box) for surface in surfaces)
    for a, b in ((one, other), (other, one)):
        found = shared_nodes(a, b)
        assert found.dtype == np.int32
        assert np.array_equal(found, shared_by_hand(a.nodes, b.nodes))


@pytest.mark.parametrize("family", FAMILIES)
def test_shared_nodes_are_those_of_equal_coordinates(family: str) -> None:
    for seed in range(20):
        pair = pair_of(family, seed)
        _check(pair.first, pair.second)


cells = st.lists(st.tuples(st.integers(0, 3), st.integers(0, 3)), min_size=3, unique=True)


@given(cells, cells, st.sampled_from([1.0, 1e-12, 1e-300]))
def test_many_nodes_in_one_cell_of_the_curve(
    first: list[tuple[int, int]], second: list[tuple[int, int]], step: float
) -> None:
    # two nodes far away leave one cell of the curve for all the others
    far = np.array([[-1.0, -1.0], [2.0, 2.0]])
    parts = [distinct(np.concatenate((np.array(c) * step, far))) for c in (first, second)]
    _check(parts[0], parts[1])
