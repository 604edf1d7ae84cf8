"""All measures together: checks anyone can recompute, and what must not change them."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core.measures import (
    Covered,
    triangle_areas,
)
from tests.core.measure_cases import (
    Case,
    Floats,
    near,
    numbers,
    over_lattice,
    random_case,
    representative,
)

pytestmark = pytest.mark.plain


@pytest.mark.parametrize("turned", range(5))
def test_bell_over_lattice(turned: int) -> None:
    # Every choice of diagonals lies between these; the limit is π.
    bell = over_lattice(100, -5.0, 5.0, lambda x, y: np.exp(-(x**2) - y**2), turned)
    assert 3.13821 <= bell.volume_above <= 3.14498
    assert bell.volume_below == 0.0
    assert bell.area_compared == near(100.0, 1e-14)
    assert bell.mean_abs == bell.volume_above / bell.area_compared


def franke(x: Floats, y: Floats) -> Floats:
    return np.asarray(
        0.75 * np.exp(-((9 * x - 2) ** 2 + (9 * y - 2) ** 2) / 4)
        + 0.75 * np.exp(-((9 * x + 1) ** 2) / 49 - (9 * y + 1) / 10)
        + 0.5 * np.exp(-((9 * x - 7) ** 2 + (9 * y - 3) ** 2) / 4)
        - 0.2 * np.exp(-((9 * x - 4) ** 2) - (9 * y - 7) ** 2)
    )


@pytest.mark.large
def test_franke_in_the_limit() -> None:
    coarse, fine = (over_lattice(n, 0.0, 1.0, franke).volume_above for n in (101, 201))
    assert (4.0 * fine - coarse) / 3.0 == pytest.approx(0.40696959, abs=1e-8)


@pytest.mark.parametrize("turned", range(3))
def test_plane_through_the_square(turned: int) -> None:
    half = over_lattice(12, 0.0, 1.0, lambda x, y: x - 0.5, turned)
    assert half.mean_abs == near(0.25, 1e-14)
    assert half.rms == near(1.0 / math.sqrt(12.0), 1e-14)
    assert half.volume_above == near(0.125, 1e-14)
    assert half.volume_below == near(0.125, 1e-14)
    assert half.mean_signed == pytest.approx(0.0, abs=1e-16)
    assert half.max_abs == 0.5
    assert half.within_tolerance == pytest.approx({"0": 0.0, "0.125": 0.25, "0.5": 1.0, "1": 1.0})
    # Each triangle's mean |d| must not be |mean d|: the middle column straddles d = 0.
    assert half.rho_V > sum(abs(np.linspace(0, 1, 12)[:-1] + 1 / 22 - 0.5)) * 22


@pytest.mark.parametrize("c", [0.3, -7.1, 1e-300, -1e200, 0.0])
def test_constant_offset(c: float) -> None:
    case = random_case()
    case.z1, case.z2 = np.full(len(case.nodes), c), np.zeros(len(case.nodes))
    values, found = case.measure(tolerances=(abs(c),), node_weight=None)
    count = int(case.compared.sum())
    for key in ("mean_abs", "rms", "mean_abs_interface"):
        assert getattr(found, key) == near(abs(c), 1e-15)
    assert found.mean_signed == near(c, 1e-15)
    assert found.max_abs == found.p50 == found.p90 == found.p95 == abs(c)
    assert found.rho_V == found.rho_V_mu == near(abs(c) * count, 1e-15)
    shared = int((case.compared & representative(case)).sum())
    assert found.rho_delta_V == near(abs(c) * shared, 1e-15)
    assert list(found.within_tolerance.values()) == [1.0]
    assert (values.mean_abs[case.compared] == abs(c)).all()
    assert (values.mean_signed[case.compared] == c).all()


def test_equal_surfaces_differ_by_nothing() -> None:
    case = random_case()
    case.z2 = case.z1
    found = numbers(case.measure()[1])
    areas = {"area_compared", "area_interface", "coverage_1", "coverage_2"}
    for key, value in found.items():
        assert value == 1.0 if key.startswith("within") else value == 0.0 or key in areas, key


@pytest.mark.parametrize("seed", range(20))
def test_exchange_changes_signs_only(seed: int) -> None:
    case = random_case(seed)
    values, found = case.measure(footprint_2=Covered(1.0))
    # The other surface's nodes come first, triangles and their nodes in another order.
    rng = np.random.default_rng(seed)
    place = np.argsort(rng.random(len(case.nodes)))
    new = np.argsort(place)
    turn = np.arange(3) + rng.integers(0, 3, (len(case.triangles), 1))
    order = rng.permutation(len(case.triangles))
    assert case.node_weight is not None
    other = Case(
        case.nodes[place],
        np.array([0, 2, 1, 3], np.uint8)[case.label[place]],
        new[np.take_along_axis(case.triangles, turn % 3, axis=1)][order].astype(np.int32),
        case.z2[place],
        case.z1[place],
        case.compared[order],
        case.node_weight[place],
    )
    other_values, exchanged = other.measure(footprint_2=Covered(1.0))
    assert numbers(exchanged) == numbers(found) | {
        "mean_signed": -found.mean_signed,
        "volume_above": found.volume_below,
        "volume_below": found.volume_above,
    }
    assert np.array_equal(other_values.area, values.area[order], equal_nan=True)
    assert np.array_equal(other_values.mean_abs, values.mean_abs[order], equal_nan=True)
    assert np.array_equal(other_values.mean_signed, -values.mean_signed[order], equal_nan=True)


@pytest.mark.parametrize("exponent", [-900, -30, 1, 900])
def test_scaling_z_by_a_power_of_two_is_exact(exponent: int) -> None:
    case = random_case()
    case.z1, case.z2 = np.round(case.z1, 3), np.round(case.z2, 3)
    values, found = case.measure()
    factor = 2.0**exponent
    tolerances = (0.0, 0.125 * factor, 0.5 * factor, factor)
    case.z1, case.z2 = case.z1 * factor, case.z2 * factor
    scaled_values, scaled = case.measure(tolerances=tolerances)
    kept = {"area_compared", "area_interface", "coverage_1", "coverage_2"}
    expected = {
        k: v if k in kept else v * factor
        for k, v in numbers(found).items()
        if not k.startswith("within")
    }
    got = numbers(scaled)
    assert {k: got[k] for k in expected} == expected
    assert list(scaled.within_tolerance.values()) == list(found.within_tolerance.values())
    assert np.array_equal(scaled_values.mean_abs, values.mean_abs * factor, equal_nan=True)


def test_regions_add_up() -> None:
    case = random_case(3, side=40)
    _, whole = case.measure()
    region = case.nodes[case.triangles].mean(axis=1)[:, 0] < 1.1
    _, left = case.measure(compared=case.compared & region)
    _, right = case.measure(compared=case.compared & ~region)
    sums = ["rho_V", "rho_V_mu", "rho_delta_V", "volume_above", "volume_below"]
    for key in [*sums, "area_compared", "area_interface", "coverage_1", "coverage_2"]:
        added = getattr(left, key) + getattr(right, key)
        assert added == near(getattr(whole, key), 4e-16), key
    assert whole.mean_abs == near(
        (left.mean_abs * left.area_compared + right.mean_abs * right.area_compared)
        / whole.area_compared,
        1e-15,
    )
    assert max(left.max_abs, right.max_abs) == whole.max_abs


def test_formula_4_is_formula_3_as_a_weight() -> None:
    case = random_case(5)
    weight = representative(case).astype(np.float64)
    _, found = case.measure(node_weight=None, triangle_weight=weight)
    assert 0.0 < found.rho_V_mu == found.rho_delta_V < found.rho_V


def test_weight_of_one_is_no_weight() -> None:
    case = random_case(6)
    _, plain = case.measure(node_weight=None)
    _, ones = case.measure(
        node_weight=np.ones(len(case.nodes)), triangle_weight=np.ones(len(case.triangles))
    )
    assert plain.rho_V_mu == plain.rho_V
    assert ones.rho_V_mu == near(plain.rho_V, 1e-15)


def test_both_weights_multiply() -> None:
    case = random_case(7)
    _, nodal = case.measure()
    _, both = case.measure(triangle_weight=np.full(len(case.triangles), 0.25))
    assert both.rho_V_mu == 0.25 * nodal.rho_V_mu


def divided(case: Case, times: int) -> Case:
    """The same surfaces, every triangle cut into four, `times` over; labels become meaningless."""
    for _ in range(times):
        ends = np.sort(
            np.concatenate(
                [case.triangles[:, [0, 1]], case.triangles[:, [1, 2]], case.triangles[:, [2, 0]]]
            ),
            axis=1,
        )
        edges, of = np.unique(ends, axis=0, return_inverse=True)
        n, m = len(case.nodes), len(case.triangles)
        ab, bc, ca = (n + of.ravel()).reshape(3, m)
        a, b, c = case.triangles.T

        def middle(v: Floats, edges: NDArray[np.int32] = edges) -> Floats:
            return np.concatenate([v, (v[edges[:, 0]] + v[edges[:, 1]]) / 2.0])

        assert case.node_weight is not None
        parts = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        case = Case(
            middle(case.nodes),
            np.full(n + len(edges), 3, np.uint8),
            np.concatenate([np.column_stack(p) for p in parts]).astype(np.int32),
            middle(case.z1),
            middle(case.z2),
            np.tile(case.compared, 4),
            middle(case.node_weight),
        )
    return case


def test_cutting_every_triangle_changes_no_integral() -> None:
    case = random_case(8, side=6)
    _, whole = case.measure()
    _, fine = divided(case, 3).measure()
    for key in ("mean_abs", "mean_signed", "rms", "volume_above", "volume_below", "area_compared"):
        assert getattr(fine, key) == near(getattr(whole, key), 1e-13), key
    assert fine.within_tolerance == near(whole.within_tolerance, 1e-13)
    # Σ ∬|d|µ/S over the parts of one triangle is 4³ times that of the triangle.
    assert fine.rho_V_mu / 64.0 == near(whole.rho_V_mu, 1e-13)
    # Centroids alone, a crude oracle, come close when triangles are small.
    fine_case = divided(case, 5)
    centre = (fine_case.z1 - fine_case.z2)[fine_case.triangles].mean(axis=1)
    area = triangle_areas(fine_case.nodes, fine_case.triangles)
    kept = fine_case.compared
    volume = (np.abs(centre) * area)[kept].sum()
    assert volume == near(whole.volume_above + whole.volume_below, 1e-3)
    square = (centre**2 * area)[kept].sum()
    assert square == near(whole.rms**2 * whole.area_compared, 1e-2)
    share = ((np.abs(centre) <= 0.125) * area)[kept].sum() / area[kept].sum()
    assert share == near(whole.within_tolerance["0.125"], 2e-2)


def test_values_of_each_triangle_make_the_sums() -> None:
    case = random_case(9)
    values, found = case.measure()
    out = ~case.compared
    for column in (values.area, values.mean_abs, values.mean_signed):
        assert np.isnan(column[out]).all()
        assert np.isfinite(column[case.compared]).all()
    assert np.nansum(values.mean_abs) == near(found.rho_V, 1e-14)
    inside = case.compared & representative(case)
    assert values.mean_abs[inside].sum() == near(found.rho_delta_V, 1e-14)
    assert values.area[inside].sum() == near(found.area_interface, 1e-14)
    volume = values.area * values.mean_abs
    assert np.nansum(volume) == near(found.volume_above + found.volume_below, 1e-14)
    assert volume[inside].sum() / found.area_interface == near(found.mean_abs_interface, 1e-14)
    signed = np.nansum(values.area * values.mean_signed)
    assert signed / found.area_compared == near(found.mean_signed, 1e-12)
    assert found.volume_above - found.volume_below == near(signed, 1e-12)
    used = np.unique(case.triangles[case.compared])
    assert found.max_abs == np.abs(case.z1 - case.z2)[used].max()
    assert found.coverage_1 == found.area_compared
    assert found.coverage_2 == found.area_compared / 4.0


@given(st.permutations(range(60)))
def test_sums_do_not_depend_on_the_order(order: list[int]) -> None:
    case = random_case(10, side=6)
    case.triangles, case.compared = case.triangles[:50], np.arange(50) % 7 > 0
    order = [t for t in order if t < 50]
    _, found = case.measure()
    _, shuffled = case.measure(triangles=case.triangles[order], compared=case.compared[order])
    assert numbers(shuffled) == numbers(found)


@pytest.mark.large
def test_many_equal_terms_add_up_exactly() -> None:
    nodes = np.array([[0.0, 0.0], [0.1, 0.0], [0.0, 0.1]])
    triangles = np.tile(np.array([[0, 1, 2]], np.int32), (100_000, 1))
    z = np.full(3, 0.1)
    label = np.full(3, 3, np.uint8)
    compared = np.ones(len(triangles), bool)
    _, found = Case(nodes, label, triangles, z, np.zeros(3), compared).measure()
    assert found.rho_V == 100_000 * 0.1
    assert found.area_compared == 100_000 * (0.5 * (0.1 * 0.1))


def test_threads_do_not_matter(monkeypatch: pytest.MonkeyPatch) -> None:
    case = random_case(11, side=20)
    values, found = case.measure()
    monkeypatch.setattr("surfcmp_core.measures.chunks.AT_ONCE", 50)
    other_values, other = case.measure(threads=3)
    assert numbers(other) == numbers(found)
    assert np.array_equal(other_values.mean_abs, values.mean_abs, equal_nan=True)


def test_nothing_compared() -> None:
    case = random_case()
    case.compared[:] = False
    case.z1[:] = np.nan
    values, found = case.measure(footprint_1=Covered(0.0))
    assert np.isnan(values.area).all()
    for key in ("mean_abs", "mean_abs_interface", "mean_signed", "rms", "max_abs", "p50", "p95"):
        assert math.isnan(getattr(found, key))
    assert all(math.isnan(v) for v in found.within_tolerance.values())
    for key in ("rho_V", "rho_V_mu", "rho_delta_V", "volume_above", "area_compared", "coverage_1"):
        assert getattr(found, key) == 0.0


def test_no_representative_triangle() -> None:
    case = random_case()
    case.label[:] = 1
    _, found = case.measure()
    assert found.rho_delta_V == found.area_interface == 0.0
    assert math.isnan(found.mean_abs_interface)


@pytest.mark.parametrize("missing", [math.nan, math.inf])
@pytest.mark.parametrize("corner", range(3))
def test_compared_without_data_is_refused(missing: float, corner: int) -> None:
    case = random_case()
    case.compared[:] = False
    case.compared[7] = True
    case.z2[case.triangles[7, corner]] = missing
    with pytest.raises(ValueError, match="triangle 7 lacks area or data"):
        case.measure()


@pytest.mark.parametrize("missing", [math.nan, math.inf, -math.inf])
def test_missing_data_elsewhere_do_not_matter(missing: float) -> None:
    case = random_case()
    case.compared[(case.triangles == 50).any(axis=1)] = False
    _, found = case.measure()
    case.z1[50] = missing
    assert numbers(case.measure()[1]) == numbers(found)


def test_compared_without_area_is_refused() -> None:
    case = random_case()
    t = int(np.flatnonzero(case.compared)[3])
    case.triangles[t] = case.triangles[t, ::-1]
    with pytest.raises(ValueError, match=f"triangle {t} lacks"):
        case.measure()


@pytest.mark.parametrize("tolerance", [-1.0, math.nan])
def test_senseless_tolerance_is_refused(tolerance: float) -> None:
    with pytest.raises(ValueError, match="tolerance"):
        random_case().measure(tolerances=(tolerance,))


def test_tolerances_are_named_by_their_shortest_decimal() -> None:
    _, found = random_case().measure(tolerances=(0.5, 1.0, 20.0, 0.1, 1e-7))
    assert list(found.within_tolerance) == ["0.5", "1", "20", "0.1", "1e-07"]


def test_surface_over_much_height_keeps_small_differences() -> None:
    case = random_case()
    case.z1, case.z2 = np.round(case.z1 * 64) / 64, np.round(case.z2 * 64) / 64
    _, found = case.measure()
    _, lifted = case.measure(z1=case.z1 + 1e9, z2=case.z2 + 1e9)
    assert numbers(lifted) == numbers(found)
