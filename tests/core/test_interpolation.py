"""Interpolation against fractions: linear on triangles, continued from the hull."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core.interpolation import interpolate
from surfcmp_core.localisation import locate_from
from surfcmp_core.triangulation import Triangulation, triangulate
from tests.core import oracles
from tests.pairs import Nodes, distinct, is_flat, pair_of

pytestmark = pytest.mark.plain

Floats = NDArray[np.float64]


def _located(target: Triangulation, queries: Nodes) -> NDArray[np.int32]:
    return locate_from(target, queries, np.zeros(len(queries), np.int32))


def _by_hand(target: Triangulation, z: Floats, queries: Nodes) -> list[float]:
    """Exact values, NaN outside the hull."""
    whole = oracles.places(np.concatenate((target.nodes, queries)))
    at, places = whole[: len(z)], whole[len(z) :]
    values = []
    for p in places:
        value = float("nan")
        for a, b, c in target.triangles.tolist():
            weights = oracles.weights_in(at[a], at[b], at[c], p)
            if min(weights) >= 0:
                corners = zip(weights, (z[a], z[b], z[c]), strict=True)
                value = float(sum(w * Fraction(float(v)) for w, v in corners))
                break
        values.append(value)
    return values


def _nearest_by_hand(target: Triangulation, z: Floats, queries: Nodes) -> list[float]:
    """Value at the nearest place of the hull's edges, every one tried."""
    at = [(Fraction(x), Fraction(y)) for x, y in target.nodes.tolist()]
    values = []
    for px, py in ((Fraction(x), Fraction(y)) for x, y in queries.tolist()):
        best: tuple[Fraction, Fraction] | None = None
        for a, b, _ in target.start[3 * target.real :].reshape(-1, 3).tolist():
            (ax, ay), (bx, by) = at[a], at[b]
            dx, dy = bx - ax, by - ay
            t = ((px - ax) * dx + (py - ay) * dy) / (dx * dx + dy * dy)
            t = min(max(t, Fraction(0)), Fraction(1))
            square = (ax + t * dx - px) ** 2 + (ay + t * dy - py) ** 2
            if best is None or square < best[0]:
                value_a, value_b = Fraction(float(z[a])), Fraction(float(z[b]))
                best = square, value_a + t * (value_b - value_a)
        assert best is not None
        values.append(float(best[1]))
    return values


@pytest.mark.parametrize("family", ["uniform", "lattice", "half_cell", "nested", "rings", "apart"])
def test_values_at_the_nodes_of_the_other_grid(family: str) -> None:
    rng = np.random.default_rng(0)
    for seed in (1, 2, 3, 4, 5, 6):
        pair = pair_of(family, seed)
        size = max(np.abs(pair.first).max(), np.abs(pair.second).max())
        if not 1e-9 < size < 1e4:  # far offsets and tiny scales leave rounding, not values
            continue
        target = triangulate(pair.first)
        z = rng.normal(size=len(pair.first))
        found = _located(target, pair.second)
        values = interpolate(target, z, pair.second, found)
        expected = _by_hand(target, z, pair.second)
        assert np.allclose(values, expected, rtol=1e-6, atol=1e-6, equal_nan=True)
        assert np.array_equal(np.isnan(values), found >= target.real)
        continued = interpolate(target, z, pair.second, found, continued=True)
        inside = found < target.real
        assert np.array_equal(continued[inside], values[inside])
        by_hand = _nearest_by_hand(target, z, pair.second[~inside])
        assert np.allclose(continued[~inside], by_hand, rtol=1e-9, atol=1e-9)


def test_values_at_its_own_nodes_are_its_own() -> None:
    rng = np.random.default_rng(1)
    nodes, z = rng.random((200, 2)), rng.normal(size=200)
    target = triangulate(nodes)
    assert np.array_equal(interpolate(target, z, nodes, _located(target, nodes)), z)


def test_a_plane_is_met() -> None:
    rng = np.random.default_rng(2)
    nodes, queries = rng.random((300, 2)), rng.random((500, 2))
    target = triangulate(nodes)
    values = interpolate(target, nodes @ [3.0, -2.0] + 7.0, queries, _located(target, queries))
    inside = ~np.isnan(values)
    assert inside.sum() > 400
    assert np.allclose(values[inside], queries[inside] @ [3.0, -2.0] + 7.0, rtol=1e-13)


@given(st.floats(-1e6, 1e6), st.integers(0, 100))
def test_a_constant_stays_that_constant_to_the_last_bit(value: float, seed: int) -> None:
    rng = np.random.default_rng(seed)
    target = triangulate(rng.random((12, 2)))
    queries = rng.random((40, 2)) * 2.0 - 0.5
    values = interpolate(
        target, np.full(12, value), queries, _located(target, queries), continued=True
    )
    assert (values == value).all()


@given(st.integers(0, 1000))
def test_values_lie_between_those_of_the_corners(seed: int) -> None:
    rng = np.random.default_rng(seed)
    nodes = rng.random((10, 2)) * [1.0, 10.0 ** -rng.integers(0, 12)]
    z = rng.normal(size=10)
    target = triangulate(nodes)
    queries = nodes[rng.integers(0, 10, 30)] * 0.5 + nodes[rng.integers(0, 10, 30)] * 0.5
    found = _located(target, queries)
    values = interpolate(target, z, queries, found, continued=True)
    inside = found < target.real
    corners = z[target.start.reshape(-1, 3)[found[inside]]]
    assert (values[inside] <= corners.max(axis=1)).all()
    assert (values[inside] >= corners.min(axis=1)).all()
    assert (values <= z.max()).all()
    assert (values >= z.min()).all()


def test_continuation_is_continuous_across_the_hull() -> None:
    rng = np.random.default_rng(3)
    nodes, z = rng.random((40, 2)), rng.normal(size=40)
    target = triangulate(nodes)
    angle = np.linspace(0.0, 2.0 * np.pi, 4001)[:-1]
    for radius in (0.8, 3.0, 1e3):
        around = 0.5 + radius * np.column_stack((np.cos(angle), np.sin(angle)))
        found = _located(target, around)
        values = interpolate(target, z, around, found, continued=True)
        steps = np.abs(np.diff(np.append(values, values[0])))
        assert steps.max() < 0.02 * np.ptp(z) * max(1.0, radius)


cell = st.tuples(st.integers(0, 6), st.integers(0, 6))


@given(
    st.lists(cell, min_size=3, max_size=12, unique=True),
    st.lists(st.tuples(st.integers(-9, 15), st.integers(-9, 15)), min_size=1, max_size=12),
)
def test_continuation_by_the_nearest_place_of_the_hull(
    cells: list[tuple[int, int]], asked: list[tuple[int, int]]
) -> None:
    nodes = np.array(cells, np.float64)
    if is_flat(nodes):
        return
    target = triangulate(nodes)
    queries = distinct(np.array(asked, np.float64))
    found = _located(target, queries)
    outside = found >= target.real
    z = np.arange(float(len(nodes))) ** 2
    values = interpolate(target, z, queries, found, continued=True)[outside]
    assert np.allclose(values, _nearest_by_hand(target, z, queries[outside]), rtol=1e-12)
