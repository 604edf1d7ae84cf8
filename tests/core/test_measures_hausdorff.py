"""Hausdorff distances between nodes."""

import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from surfcmp_core.grid.curve import curve_keys
from surfcmp_core.measures import (
    hausdorff,
)
from surfcmp_core.triangulation import triangulate
from tests.core.measure_cases import Floats


def _hausdorff(one: Floats, two: Floats, seed: int = 0) -> float:
    """Ask for it where each node is said to lie anywhere."""
    other = triangulate(two[:, :2].copy())
    found = np.random.default_rng(seed).integers(0, len(other.start) // 3, len(one))
    return hausdorff(
        one[:, :2].copy(),
        one[:, 2].copy(),
        two[:, :2].copy(),
        two[:, 2].copy(),
        other,
        found.astype(np.int32),
    )


def _by_all_pairs(one: Floats, two: Floats) -> float:
    distance = np.linalg.norm(one[:, None] - two[None], axis=2)
    return float(distance.min(axis=1).max())


@given(
    st.integers(1, 30), st.integers(3, 30), st.sampled_from([0.0, 0.1, 10.0]), st.integers(0, 99)
)
def test_hausdorff_against_all_pairs(n1: int, n2: int, height: float, seed: int) -> None:
    rng = np.random.default_rng(seed)
    one, two = rng.normal(size=(n1, 3)), rng.normal(size=(n2, 3))
    one[:, 2] *= height
    assert _hausdorff(one, two, seed) == pytest.approx(_by_all_pairs(one, two))


@pytest.mark.parametrize("height", [0.0, 5.0, 50.0])
def test_hausdorff_of_more_nodes_than_a_batch(height: float) -> None:
    # far from each other most nodes are looked up in the k-d tree
    rng = np.random.default_rng(0)
    one, two = rng.normal(size=(9000, 3)), rng.normal(size=(500, 3))
    one[:, 2] += height
    assert _hausdorff(one, two) == pytest.approx(_by_all_pairs(one, two))


@pytest.mark.parametrize(
    ("height", "rough"),
    [(1e2, 1e-3), (1e2, 1.0), (-1e4, 1e-6), (-1e4, 1.0), (1e7, 0.0), (1e7, 1e-3), (1e7, 1.0)],
)
def test_hausdorff_of_surfaces_far_apart_asks_for_few_nodes(
    height: float, rough: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    # there all nodes of one are nearly equally far from each of the other: a search visits them all
    from scipy import spatial

    asked = []

    class Counting(spatial.cKDTree):  # type: ignore[misc]
        def query(self, x: Floats) -> tuple[Floats, Floats]:
            asked.append(len(x))
            return super().query(x)  # type: ignore[no-any-return]

    monkeypatch.setattr(spatial, "cKDTree", Counting)
    monkeypatch.setattr(sys.modules[hausdorff.__module__], "_WORTH_A_TREE", 0)
    rng = np.random.default_rng(0)
    one, two = rng.random((3000, 3)), rng.random((2000, 3))
    one[:, 2], two[:, 2] = one[:, 2] * rough + height, two[:, 2] * rough
    one = one[np.argsort(curve_keys(one[:, :2].copy(), (0.0, 0.0, 1.0, 1.0)))]
    expected = np.sqrt(
        ((one[:, None, :2] - two[None, :, :2]) ** 2).sum(axis=2)
        + (one[:, None, 2] - two[None, :, 2]) ** 2
    )
    assert _hausdorff(one, two) == pytest.approx(expected.min(axis=1).max(), rel=1e-15)
    assert 0 < sum(asked) < 1500
