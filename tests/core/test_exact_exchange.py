"""The exact reading is the same to the last bit, whatever the surfaces' roles and numbering."""

import dataclasses
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core import Comparison, InputError, Surface, compare
from surfcmp_core.comparing.options import Domain
from surfcmp_core.grid import safe_scale
from surfcmp_core.triangulation import triangulate
from tests.pairs import FAMILIES, Nodes, pair_of

EXCHANGED = {
    "volume_above": "volume_below",
    "coverage_1": "coverage_2",
    "hausdorff_1_2": "hausdorff_2_1",
}


def _height(nodes: Nodes) -> NDArray[np.float64]:
    x, y = nodes.T
    return np.asarray(np.sin(3.0 * x) + 0.5 * np.cos(5.0 * y) * x)


def _surface(nodes: Nodes, size: float, name: str, *, mesh: bool, seed: int) -> Surface:
    z = _height(nodes / size) - (0.1 if name == "b" else 0.0)
    faces = None
    if mesh:
        rng = np.random.default_rng(seed)
        shaken = nodes + 0.1 * size * rng.random(nodes.shape) / math.sqrt(len(nodes))
        faces = triangulate(shaken * safe_scale(shaken)).triangles
        faces = faces[rng.random(len(faces)) < 0.9]
    return Surface(np.column_stack((nodes, z)), faces=faces, name=name, unit="mm")


def _shuffled(surface: Surface, seed: int) -> Surface:
    rng = np.random.default_rng(seed)
    order = rng.permutation(len(surface.points))
    place = np.empty(len(order), np.int32)
    place[order] = np.arange(len(order))
    faces = surface.faces
    if faces is not None:
        faces = np.roll(place[faces][rng.permutation(len(faces))], 1, axis=1)
    return dataclasses.replace(surface, points=surface.points[order], faces=faces)


def _rows(found: Comparison) -> NDArray[np.int64]:
    """Order of the triangles of T that knows nothing of numbers."""
    nodes = found.united.nodes
    rank = np.empty(len(nodes), np.int64)
    rank[np.lexsort((nodes[:, 1], nodes[:, 0]))] = np.arange(len(nodes))
    named = np.sort(rank[found.united.triangles], axis=1)
    return np.asarray(np.lexsort(named.T))


def same_bits(one: Comparison, other: Comparison, sign: float) -> None:
    """Hold two exact readings against each other; `sign` is -1 where roles were exchanged."""
    assert one.mean_abs_exact is not None
    assert other.mean_abs_exact is not None
    assert one.mean_signed_exact is not None
    assert other.mean_signed_exact is not None
    rows, others = _rows(one), _rows(other)
    for values, expected in (
        (one.mean_abs_exact[rows], other.mean_abs_exact[others]),
        (one.mean_signed_exact[rows], sign * other.mean_signed_exact[others]),
    ):
        assert np.array_equal(values, expected, equal_nan=True)
    first, second = one.measures.exact, other.measures.exact
    assert first is not None
    assert second is not None
    values, expected = dataclasses.asdict(first), dataclasses.asdict(second)
    if sign < 0.0:
        expected["mean_signed"] *= -1.0
        for name, exchanged in EXCHANGED.items():
            expected[name], expected[exchanged] = expected[exchanged], expected[name]
    assert repr(_plain(values)) == repr(_plain(expected))


def _plain(values: dict[str, Any]) -> dict[str, Any]:
    """Minus zero is zero."""
    return {k: v + 0.0 if isinstance(v, float) else v for k, v in values.items()}


def check(a: Surface, b: Surface, domain: Domain, seed: int) -> None:
    try:
        found = compare(a, b, domain=domain, exact=True)
    except InputError as error:
        assert "no common area" in str(error)  # noqa: PT017
        return
    same_bits(found, compare(b, a, domain=domain, exact=True), -1.0)
    shuffled = compare(_shuffled(a, seed), _shuffled(b, seed + 1), domain=domain, exact=True)
    same_bits(found, shuffled, 1.0)


@settings(max_examples=60)
@given(
    st.sampled_from(sorted(FAMILIES)),
    st.integers(0, 10**6),
    st.sampled_from(["data", "hull", "plane"]),
    st.booleans(),
    st.booleans(),
)
def test_exchange_and_numbering_of_any_pair(
    family: str, seed: int, domain: Domain, first_is_mesh: bool, second_is_mesh: bool
) -> None:
    pair = pair_of(family, seed)
    size = max(np.abs(pair.first).max(), np.abs(pair.second).max())
    check(
        _surface(pair.first, size, "a", mesh=first_is_mesh, seed=seed),
        _surface(pair.second, size, "b", mesh=second_is_mesh, seed=seed + 1),
        domain,
        seed,
    )


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("mesh", [False, True], ids=["clouds", "meshes"])
def test_exchange_and_numbering_of_each_family(family: str, mesh: bool) -> None:
    domains: list[Domain] = ["data", "hull", "plane"]
    for seed in range(3):
        pair = pair_of(family, seed)
        size = max(np.abs(pair.first).max(), np.abs(pair.second).max())
        check(
            _surface(pair.first, size, "a", mesh=mesh, seed=seed),
            _surface(pair.second, size, "b", mesh=mesh, seed=seed + 1),
            domains[seed],
            seed,
        )


def test_surfaces_on_one_grid_go_by_their_heights() -> None:
    nodes = np.random.default_rng(1).random((50, 2))
    a, b = (Surface(np.column_stack((nodes, _height(k * nodes))), name="z") for k in (1.0, 2.0))
    check(a, b, "hull", 0)


# planes


def _plane(nodes: Nodes) -> Surface:
    return Surface(np.column_stack((nodes, 0.5 * nodes[:, 0] - 0.25 * nodes[:, 1])), name="plane")


@pytest.mark.parametrize("family", FAMILIES)
def test_planes_do_not_differ_on_any_triangles(family: str) -> None:
    for seed in range(10):
        pair = pair_of(family, seed)
        size = max(np.abs(pair.first).max(), np.abs(pair.second).max())
        for domain in ("hull", "data"):
            try:
                found = compare(_plane(pair.first), _plane(pair.second), domain=domain, exact=True)
            except InputError as error:
                told = str(error)
                assert "no common area" in told or "too large to give volumes" in told
                continue
            measures = found.measures.exact
            assert measures is not None
            if measures.area_compared:
                assert measures.max_abs <= 2.0**-49 * size


@pytest.mark.parametrize(("side", "angle"), [(4, 30.0), (10, 30.0), (30, 30.0), (30, 17.0)])
def test_planes_do_not_differ_on_turned_lattices(side: int, angle: float) -> None:
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    turn = np.array([[c, -s], [s, c]])
    lattice = np.stack(np.meshgrid(np.arange(side), np.arange(side)), -1).reshape(-1, 2)
    found = compare(
        _plane(lattice @ turn), _plane((lattice + np.array([0.5, 0.0])) @ turn), exact=True
    )
    measures = found.measures.exact
    assert measures is not None
    assert measures.max_abs <= 2.0**-49 * side
    assert measures.rho_V <= 2.0**-49 * side * found.counts["triangles_united"]


def test_planes_over_a_sliver_of_the_hull() -> None:
    first = np.array([[0.0, 3.0], [0.4, 1.2], [0.5, 1.5], [1.0, 3.0]])
    second = np.array([[0.05, 0.35], [1.1, 2.9], [0.1, 2.9]])
    a, b = (Surface(np.column_stack((n, n[:, 0])), name="x") for n in (first, second))
    measures = compare(a, b, domain="hull", exact=True).measures.exact
    assert measures is not None
    assert measures.max_abs < 1e-15
    assert measures.rho_V < 1e-14
