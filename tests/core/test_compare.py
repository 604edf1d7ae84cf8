"""The whole comparison: properties, values anyone can recompute, refusals, cancelling."""

import dataclasses
import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from surfcmp_core import InputError, Surface, compare
from surfcmp_core.comparing.options import Domain
from surfcmp_core.measures import Measures
from tests.core.small_surfaces import (
    DOMAINS,
    Floats,
    assert_same,
    cloud,
    height_at,
    numbers_of,
    two_surfaces,
)
from tests.invariants import codes, ranks
from tests.pairs import FAMILIES, load, pair_of

EXACT_FIXTURES = sorted((Path(__file__).parent / "fixtures").glob("exact_*.json"))


def _close(found: Measures, expected: Measures, **changed: float) -> None:
    """Compare all measures; those in `changed` are compared with these values instead."""
    a, b = numbers_of(found), numbers_of(expected) | changed
    assert a.keys() == b.keys()
    for name in a:
        assert a[name] == pytest.approx(b[name], rel=1e-9, abs=1e-12, nan_ok=True), name


@pytest.mark.parametrize("domain", DOMAINS)
@pytest.mark.parametrize("family", FAMILIES)
def test_any_pair_is_compared_either_way_round(family: str, domain: Domain) -> None:
    reasons: list[str] = []
    for seed in range(5):
        pair = pair_of(family, seed)
        size = max(np.abs(pair.first).max(), np.abs(pair.second).max())
        unit = 1.0 / size
        a = cloud(pair.first, height_at(pair.first * unit), "a")
        b = cloud(pair.second, height_at(pair.second * unit) - 0.1, "b")
        try:
            result = compare(a, b, domain=domain)
        except InputError as error:
            told = str(error)
            with pytest.raises(InputError, match=r"^b and a: no common area to compare") as other:
                compare(b, a, domain=domain)
            # the data of clouds reach no farther than their edges, which is told
            assert ("--max-edge" in str(other.value)) == (domain == "data")
            assert ("--max-edge" in told) == (domain == "data")
            reasons.append(told.partition(";")[0])
            continue
        found, swapped = result.measures, compare(b, a, domain=domain).measures
        values = numbers_of(found)
        del values["mean_abs_interface"]  # none where no triangle has nodes of both grids
        assert all(math.isfinite(value) for value in values.values())
        if not 1e-30 < size < 1e6:  # too far from the origin for so many digits
            continue
        assert np.nansum(result.area) == pytest.approx(found.area_compared, rel=1e-12)
        _close(
            swapped,
            found,
            mean_signed=-found.mean_signed,
            volume_above=found.volume_below,
            volume_below=found.volume_above,
            coverage_1=found.coverage_2,
            coverage_2=found.coverage_1,
            hausdorff_1_2=found.hausdorff_2_1,
            hausdorff_2_1=found.hausdorff_1_2,
        )
    assert set(reasons) <= {"a and b: no common area to compare"}


@pytest.mark.parametrize("path", EXACT_FIXTURES, ids=lambda path: path.stem)
def test_exact_reading_either_way_round(path: Path) -> None:
    pair = load(path)
    size = max(np.abs(pair.first).max(), np.abs(pair.second).max())
    a = cloud(pair.first, height_at(pair.first / size), "a")
    b = cloud(pair.second, height_at(pair.second / size) - 0.1, "b")
    found = compare(a, b, domain="hull", exact=True).measures.exact
    swapped = compare(b, a, domain="hull", exact=True).measures.exact
    assert found is not None
    assert swapped is not None
    assert swapped == dataclasses.replace(
        found,
        mean_signed=-found.mean_signed,
        volume_above=found.volume_below,
        volume_below=found.volume_above,
        coverage_1=found.coverage_2,
        coverage_2=found.coverage_1,
        hausdorff_1_2=found.hausdorff_2_1,
        hausdorff_2_1=found.hausdorff_1_2,
    )


@pytest.mark.parametrize("domain", DOMAINS)
def test_equal_surfaces_do_not_differ(domain: Domain) -> None:
    first, _ = two_surfaces(1)
    order = np.random.default_rng(0).permutation(len(first.points))
    second = dataclasses.replace(first, points=first.points[order])
    result = compare(first, second, domain=domain, exact=True, tolerances=(0.0, 1.0))
    assert result.counts["chains"] == 0
    assert result.counts["nodes_shared"] == 400
    assert (result.united.label == 3).all()
    assert (result.united.origin == 3).all()
    assert result.measures.exact is not None
    for measures in (result.measures, result.measures.exact):
        for name, value in numbers_of(measures).items():
            if name.startswith("within"):
                assert value == 1.0, name
            elif not name.startswith(("area", "coverage")):
                assert value == 0.0 or (math.isnan(value) and measures is not result.measures), name
    assert (result.mean_abs[result.compared] == 0.0).all()


@pytest.mark.parametrize("domain", DOMAINS)
def test_coverage_is_a_share(domain: Domain) -> None:
    first, second = two_surfaces(1)
    measures = compare(first, second, domain=domain).measures
    assert 0.0 < measures.coverage_1 <= 1.0 + 1e-12
    assert 0.0 < measures.coverage_2 <= 1.0 + 1e-12
    same = compare(first, first, domain=domain).measures
    assert same.coverage_1 == pytest.approx(1.0, rel=1e-12)
    assert same.coverage_2 == pytest.approx(1.0, rel=1e-12)


@pytest.mark.parametrize("domain", DOMAINS)
def test_constant_offset_is_that_offset(domain: Domain) -> None:
    rng = np.random.default_rng(2)
    first = cloud(rng.random((300, 2)), 5.25, "a")
    second = cloud(rng.random((200, 2)), 6.75, "b")
    result = compare(first, second, domain=domain)
    m = result.measures
    for value in (m.mean_abs, m.mean_abs_interface, m.rms, m.max_abs, m.p50, m.p90, m.p95):
        assert value == pytest.approx(1.5, rel=1e-14)
    assert m.mean_signed == pytest.approx(-1.5, rel=1e-14)
    assert m.rho_V == pytest.approx(1.5 * result.counts["triangles_compared"], rel=1e-12)
    representative = (result.united.representative & result.compared).sum()
    assert m.rho_delta_V == pytest.approx(1.5 * representative, rel=1e-12)
    assert m.volume_above == 0.0
    assert m.volume_below == pytest.approx(1.5 * m.area_compared, rel=1e-12)


def _shuffled(surface: Surface, seed: int) -> Surface:
    order = np.random.default_rng(seed).permutation(len(surface.points))
    place = np.empty(len(order), np.int32)
    place[order] = np.arange(len(order))
    faces = None if surface.faces is None else np.roll(place[surface.faces][::-1], 1, axis=1)
    return dataclasses.replace(surface, points=surface.points[order], faces=faces)


def test_order_of_nodes_and_faces_does_not_matter() -> None:
    for kind in ("cloud", "mesh"):
        first, second = two_surfaces(3)
        if kind == "mesh":
            faces = compare(first, second).triangulations[0].triangles
            source = compare(first, second).grids[0].source
            first = dataclasses.replace(first, faces=source[faces].astype(np.int32))
        one, other = compare(first, second), compare(_shuffled(first, 1), _shuffled(second, 2))
        assert np.array_equal(one.united.nodes, other.united.nodes)
        assert np.array_equal(one.z1, other.z1, equal_nan=True)
        assert np.array_equal(one.z2, other.z2, equal_nan=True)
        name = ranks(one.united.nodes)
        numbers = [codes(c.united.triangles, name, len(name)) for c in (one, other)]
        orders = [np.argsort(number) for number in numbers]
        assert np.array_equal(numbers[0][orders[0]], numbers[1][orders[1]])
        for field in ("reason", "area", "mean_abs", "mean_signed"):
            before, after = (
                getattr(c, field)[o] for c, o in zip((one, other), orders, strict=True)
            )
            assert np.allclose(before, after, rtol=1e-12, equal_nan=True), field
        _close(other.measures, one.measures)


@pytest.mark.parametrize("power", [-450, -330, -60, 1, 60, 330, 450])
def test_unit_of_length_in_the_plane_does_not_matter(power: int) -> None:
    first, second = two_surfaces(4)
    before = compare(first, second).measures
    factor = np.array([2.0**power, 2.0**power, 1.0])
    scaled = [dataclasses.replace(s, points=s.points * factor) for s in (first, second)]
    after = compare(*scaled).measures
    for name in ("mean_abs", "mean_signed", "rms", "max_abs", "rho_V", "rho_delta_V", "p50", "p95"):
        assert getattr(after, name) == pytest.approx(getattr(before, name), rel=1e-9), name
    assert after.coverage_1 == pytest.approx(before.coverage_1, rel=1e-9)
    assert after.area_compared / 4.0**power == pytest.approx(before.area_compared, rel=1e-9)


@pytest.mark.parametrize("power", [520, 700, 1000, -525, -600, -750, -1000])
def test_units_too_large_or_small_are_refused(power: int) -> None:
    first, second = two_surfaces(4)
    factor = np.array([2.0**power, 2.0**power, 1.0])
    scaled = [dataclasses.replace(s, points=s.points * factor) for s in (first, second)]
    with pytest.raises(InputError, match="coordinates"):
        compare(*scaled)


def test_place_in_the_plane_does_not_matter() -> None:
    rng = np.random.default_rng(5)
    first, second = (
        cloud(np.unique(rng.integers(0, 60, (n, 2)), axis=0) / 4.0, 0.0, name)
        for n, name in ((300, "a"), (200, "b"))
    )
    first.points[:, 2], second.points[:, 2] = first.points[:, 0], second.points[:, 1]
    before = compare(first, second)
    shift = np.array([2.0**22, -(2.0**20), 0.0])
    moved = [dataclasses.replace(s, points=s.points + shift) for s in (first, second)]
    after = compare(*moved)
    assert np.array_equal(after.united.nodes - shift[:2], before.united.nodes)
    for name in ("rho_V", "mean_abs", "rms", "area_compared", "hausdorff_1_2"):
        expected = getattr(before.measures, name)
        assert getattr(after.measures, name) == pytest.approx(expected, rel=1e-9), name


@pytest.mark.parametrize("domain", DOMAINS)
def test_threads_do_not_matter_to_the_last_bit(domain: Domain) -> None:
    for seed in (6, 7):
        first, second = two_surfaces(seed, 3000)
        assert_same(
            compare(first, second, domain=domain, threads=1),
            compare(first, second, domain=domain, threads=2),
        )
        assert_same(compare(first, second, domain=domain), compare(first, second, domain=domain))


def test_input_is_left_as_it_was() -> None:
    first, second = (dataclasses.replace(s, unit="mm") for s in two_surfaces(8))
    before = first.points.copy(), second.points.copy()
    motion = np.eye(4)
    motion[2, 3] = 0.5
    result = compare(first, second, align=motion)
    assert np.array_equal(first.points, before[0])
    assert np.array_equal(second.points, before[1])
    assert result.surfaces == (first, second)
    assert np.array_equal(result.transform, motion)


def test_nodes_are_the_inputs_bit_for_bit() -> None:
    first, second = two_surfaces(9)
    for factor in (1.0, 1e-90, 1e90):
        pair = [
            dataclasses.replace(s, points=s.points * [factor, factor, 1.0]) for s in (first, second)
        ]
        united = compare(*pair).united
        for surface, node in zip(pair, (united.node_1, united.node_2), strict=True):
            there = {tuple(place) for place in united.nodes[node].tolist()}
            assert there == {tuple(place) for place in surface.points[:, :2].tolist()}


def test_a_motion_moves_the_second_surface() -> None:
    first, second = two_surfaces(10)
    angle = 0.3
    motion = np.eye(4)
    motion[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    motion[:3, 3] = [0.1, -0.2, 0.05]
    moved = second.points @ motion[:3, :3].T + motion[:3, 3]
    by_hand = compare(first, dataclasses.replace(second, points=moved))
    _close(compare(first, second, align=motion).measures, by_hand.measures)


def test_weight_of_one_and_two() -> None:
    first, second = two_surfaces(11)
    plain = compare(first, second).measures

    def weighted(weight: Callable[[Floats], Floats]) -> Measures:
        return compare(first, second, weight=lambda x, y: weight(x)).measures

    _close(weighted(np.ones_like), plain)
    _close(weighted(lambda x: np.full_like(x, 2.0)), plain, rho_V_mu=2.0 * plain.rho_V)
    left = weighted(lambda x: np.asarray(x <= 0.5, np.float64))
    right = weighted(lambda x: np.asarray(x > 0.5, np.float64))
    assert left.rho_V_mu + right.rho_V_mu == pytest.approx(plain.rho_V, rel=1e-9)
