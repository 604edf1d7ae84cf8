"""The whole comparison: properties, values anyone can recompute, refusals, cancelling."""

import dataclasses
import math
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from surfcmp_core import Comparison, InputError, Surface, compare
from surfcmp_core.comparing.comparison import Domain
from surfcmp_core.errors import Cancelled
from surfcmp_core.measures import Measures
from tests.invariants import codes, ranks
from tests.pairs import FAMILIES, Nodes, load, pair_of

Floats = NDArray[np.float64]
DOMAINS: list[Domain] = ["data", "hull", "plane"]
EXACT_FIXTURES = sorted((Path(__file__).parent / "fixtures").glob("exact_*.json"))


def _cloud(nodes: Nodes, z: Floats | float, name: str = "scan") -> Surface:
    return Surface(np.column_stack((nodes, np.broadcast_to(z, len(nodes)))), name=name)


def _lattice(columns: int, rows: int, side: float = 1.0) -> Nodes:
    x, y = np.meshgrid(np.linspace(0.0, side, columns), np.linspace(0.0, side, rows))
    return np.column_stack((x.ravel(), y.ravel()))


def _height(nodes: Nodes) -> Floats:
    x, y = nodes.T
    return np.asarray(np.sin(3.0 * x) + 0.5 * np.cos(5.0 * y) * x)


def _two(seed: int, n: int = 400) -> tuple[Surface, Surface]:
    rng = np.random.default_rng(seed)
    first, second = rng.random((n, 2)), rng.random((n // 2, 2))
    return (
        _cloud(first, _height(first), "a"),
        _cloud(second, _height(second) + 0.1 * second[:, 0] - 0.04, "b"),
    )


def _values(measures: Measures) -> dict[str, float]:
    values: dict[str, float] = {}
    for field in dataclasses.fields(measures):
        value = getattr(measures, field.name)
        if isinstance(value, dict):
            values |= {f"within {k}": v for k, v in value.items()}
        elif value is not None and field.name != "exact":
            values[field.name] = value
    return values


def _close(found: Measures, expected: Measures, **changed: float) -> None:
    """Compare all measures; those in `changed` are compared with these values instead."""
    a, b = _values(found), _values(expected) | changed
    assert a.keys() == b.keys()
    for name in a:
        assert a[name] == pytest.approx(b[name], rel=1e-9, abs=1e-12, nan_ok=True), name


def _same(a: Comparison, b: Comparison) -> None:
    """Compare all arrays and measures bit for bit."""
    for name in ("nodes", "label", "triangles", "origin", "chain", "chain_closed", "tree1"):
        assert np.array_equal(getattr(a.united, name), getattr(b.united, name)), name
    for name in ("z1", "z2", "reason", "area", "mean_abs", "mean_signed"):
        assert np.array_equal(getattr(a, name), getattr(b, name), equal_nan=name != "reason"), name
    one, other = _values(a.measures), _values(b.measures)
    assert all(np.array_equal(one[k], other[k], equal_nan=True) for k in one | other)


# properties


@pytest.mark.parametrize("domain", DOMAINS)
@pytest.mark.parametrize("family", FAMILIES)
def test_any_pair_is_compared_either_way_round(family: str, domain: Domain) -> None:
    reasons: list[str] = []
    for seed in range(5):
        pair = pair_of(family, seed)
        size = max(np.abs(pair.first).max(), np.abs(pair.second).max())
        unit = 1.0 / size
        a = _cloud(pair.first, _height(pair.first * unit), "a")
        b = _cloud(pair.second, _height(pair.second * unit) - 0.1, "b")
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
        values = _values(found)
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
    a = _cloud(pair.first, _height(pair.first / size), "a")
    b = _cloud(pair.second, _height(pair.second / size) - 0.1, "b")
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
    first, _ = _two(1)
    order = np.random.default_rng(0).permutation(len(first.points))
    second = dataclasses.replace(first, points=first.points[order])
    result = compare(first, second, domain=domain, exact=True, tolerances=(0.0, 1.0))
    assert result.counts["chains"] == 0
    assert result.counts["nodes_shared"] == 400
    assert (result.united.label == 3).all()
    assert (result.united.origin == 3).all()
    assert result.measures.exact is not None
    for measures in (result.measures, result.measures.exact):
        for name, value in _values(measures).items():
            if name.startswith("within"):
                assert value == 1.0, name
            elif not name.startswith(("area", "coverage")):
                assert value == 0.0 or (math.isnan(value) and measures is not result.measures), name
    assert (result.mean_abs[result.compared] == 0.0).all()


@pytest.mark.parametrize("domain", DOMAINS)
def test_coverage_is_a_share(domain: Domain) -> None:
    first, second = _two(1)
    measures = compare(first, second, domain=domain).measures
    assert 0.0 < measures.coverage_1 <= 1.0 + 1e-12
    assert 0.0 < measures.coverage_2 <= 1.0 + 1e-12
    same = compare(first, first, domain=domain).measures
    assert same.coverage_1 == pytest.approx(1.0, rel=1e-12)
    assert same.coverage_2 == pytest.approx(1.0, rel=1e-12)


@pytest.mark.parametrize("domain", DOMAINS)
def test_constant_offset_is_that_offset(domain: Domain) -> None:
    rng = np.random.default_rng(2)
    first = _cloud(rng.random((300, 2)), 5.25, "a")
    second = _cloud(rng.random((200, 2)), 6.75, "b")
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
        first, second = _two(3)
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
    first, second = _two(4)
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
    first, second = _two(4)
    factor = np.array([2.0**power, 2.0**power, 1.0])
    scaled = [dataclasses.replace(s, points=s.points * factor) for s in (first, second)]
    with pytest.raises(InputError, match="coordinates"):
        compare(*scaled)


def test_place_in_the_plane_does_not_matter() -> None:
    rng = np.random.default_rng(5)
    first, second = (
        _cloud(np.unique(rng.integers(0, 60, (n, 2)), axis=0) / 4.0, 0.0, name)
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
        first, second = _two(seed, 3000)
        _same(
            compare(first, second, domain=domain, threads=1),
            compare(first, second, domain=domain, threads=2),
        )
        _same(compare(first, second, domain=domain), compare(first, second, domain=domain))


def test_input_is_left_as_it_was() -> None:
    first, second = (dataclasses.replace(s, unit="mm") for s in _two(8))
    before = first.points.copy(), second.points.copy()
    motion = np.eye(4)
    motion[2, 3] = 0.5
    result = compare(first, second, align=motion)
    assert np.array_equal(first.points, before[0])
    assert np.array_equal(second.points, before[1])
    assert result.surfaces == (first, second)
    assert np.array_equal(result.transform, motion)


def test_nodes_are_the_inputs_bit_for_bit() -> None:
    first, second = _two(9)
    for factor in (1.0, 1e-90, 1e90):
        pair = [
            dataclasses.replace(s, points=s.points * [factor, factor, 1.0]) for s in (first, second)
        ]
        united = compare(*pair).united
        for surface, node in zip(pair, (united.node_1, united.node_2), strict=True):
            there = {tuple(place) for place in united.nodes[node].tolist()}
            assert there == {tuple(place) for place in surface.points[:, :2].tolist()}


def test_a_motion_moves_the_second_surface() -> None:
    first, second = _two(10)
    angle = 0.3
    motion = np.eye(4)
    motion[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    motion[:3, 3] = [0.1, -0.2, 0.05]
    moved = second.points @ motion[:3, :3].T + motion[:3, 3]
    by_hand = compare(first, dataclasses.replace(second, points=moved))
    _close(compare(first, second, align=motion).measures, by_hand.measures)
    # a frame moves both
    both = compare(first, second, frame=motion)
    by_hand = compare(
        *(
            dataclasses.replace(s, points=s.points @ motion[:3, :3].T + motion[:3, 3])
            for s in (first, second)
        )
    )
    _close(both.measures, by_hand.measures)


def test_weight_of_one_and_two() -> None:
    first, second = _two(11)
    plain = compare(first, second).measures

    def weighted(weight: Callable[[Floats], Floats]) -> Measures:
        return compare(first, second, weight=lambda x, y: weight(x)).measures

    _close(weighted(np.ones_like), plain)
    _close(weighted(lambda x: np.full_like(x, 2.0)), plain, rho_V_mu=2.0 * plain.rho_V)
    left = weighted(lambda x: np.asarray(x <= 0.5, np.float64))
    right = weighted(lambda x: np.asarray(x > 0.5, np.float64))
    assert left.rho_V_mu + right.rho_V_mu == pytest.approx(plain.rho_V, rel=1e-9)


# values anyone can recompute


def test_gaussian_bell() -> None:
    x, y = np.meshgrid(np.linspace(-5.0, 5.0, 100), np.linspace(-5.0, 5.0, 100))
    nodes = np.column_stack((x.ravel(), y.ravel()))
    bell = _cloud(nodes, np.exp(-(nodes**2).sum(axis=1)), "bell")
    corners = _cloud(np.array([[-5.0, -5.0], [5.0, -5.0], [5.0, 5.0], [-5.0, 5.0]]), 0.0, "flat")
    flat = _cloud(nodes, 0.0, "flat")
    for other in (corners, flat):
        for domain in DOMAINS:
            m = compare(bell, other, domain=domain, max_edge=np.inf).measures
            assert 3.13821 <= m.volume_above <= 3.14498
            assert m.volume_below == 0.0
            assert m.area_compared == pytest.approx(100.0, rel=1e-12)
            assert m.mean_abs * 100.0 == pytest.approx(m.volume_above, rel=1e-12)


def test_franke() -> None:
    def franke(x: Floats, y: Floats) -> Floats:
        x, y = 9.0 * x, 9.0 * y
        return np.asarray(
            0.75 * np.exp(-((x - 2.0) ** 2 + (y - 2.0) ** 2) / 4.0)
            + 0.75 * np.exp(-((x + 1.0) ** 2) / 49.0 - (y + 1.0) / 10.0)
            + 0.5 * np.exp(-((x - 7.0) ** 2 + (y - 3.0) ** 2) / 4.0)
            - 0.2 * np.exp(-((x - 4.0) ** 2) - (y - 7.0) ** 2)
        )

    errors = []
    for side in (40, 80, 160):
        nodes = _lattice(side + 1, side + 1)
        surface = _cloud(nodes, franke(*nodes.T), "franke")
        found = compare(surface, _cloud(_lattice(2, 2), 0.0, "flat"), max_edge=np.inf).measures
        errors.append(abs(found.volume_above - found.volume_below - 0.40696959))
    assert errors[2] < 2e-5
    assert errors[0] > 3.5 * errors[1] > 12.0 * errors[2]


def test_inclined_plane() -> None:
    for first in (_lattice(2, 2), _lattice(8, 8), _lattice(4, 9)):
        for second in (_lattice(2, 2), _lattice(3, 6)):
            m = compare(
                _cloud(first, first[:, 0]), _cloud(second, 0.5), max_edge=np.inf, domain="data"
            ).measures
            assert m.mean_abs == pytest.approx(0.25, rel=1e-12)
            assert m.rms == pytest.approx(1.0 / math.sqrt(12.0), rel=1e-12)
            assert m.volume_above == pytest.approx(0.125, rel=1e-12)
            assert m.volume_below == pytest.approx(0.125, rel=1e-12)
            assert m.mean_signed == pytest.approx(0.0, abs=1e-15)
            assert m.max_abs == 0.5
            assert m.area_compared == pytest.approx(1.0, rel=1e-12)


def test_planes_are_compared_exactly_on_any_nodes() -> None:
    """Both linear: nodal and exact reading agree, whatever the triangles."""
    rng = np.random.default_rng(12)
    first, second = rng.random((80, 2)), rng.random((50, 2))
    m = compare(
        _cloud(first, first @ [1.0, 2.0]),
        _cloud(second, second @ [-1.0, 0.5] + 0.8),
        domain="hull",
        exact=True,
    ).measures
    assert m.exact is not None
    # the nodal reading leaves out triangles that are not inside both hulls as a whole
    assert m.area_compared <= m.exact.area_compared
    inner = compare(
        _cloud(np.concatenate((first, _lattice(2, 2))), 0.0),
        _cloud(np.concatenate((second, _lattice(2, 2))), 1.0),
        exact=True,
        max_edge=np.inf,
    ).measures
    assert inner.exact is not None
    assert inner.exact.area_compared == pytest.approx(inner.area_compared, rel=1e-12)
    assert inner.exact.mean_abs == pytest.approx(1.0, rel=1e-12)


# stopping


STAGES = ["triangulate", "spanning trees", "interface", "interpolate", "measures", "done"]


@pytest.mark.parametrize("threads", [1, 2])
def test_progress_tells_the_stages_in_order(threads: int) -> None:
    told: list[tuple[str, float]] = []
    compare(*_two(13))  # the first comparison of all speaks of compiling too
    result = compare(*_two(13), threads=threads, progress=lambda *what: told.append(what))
    stages = list(dict.fromkeys(stage for stage, _ in told))
    assert stages == STAGES
    shares = [share for _, share in told]
    assert shares == sorted(shares)
    assert (shares[0], shares[-1]) == (0.0, 1.0)
    parts = [v for k, v in result.seconds.items() if k != "total"]
    assert max(parts) <= result.seconds["total"]


@pytest.mark.parametrize("stage", STAGES)
def test_cancelling_leaves_nothing_behind(stage: str) -> None:
    first, second = _two(14)
    expected = compare(first, second)
    threads = threading.active_count()

    def stop(reached: str, share: float) -> None:
        if reached == stage:
            raise Cancelled

    with pytest.raises(Cancelled):
        compare(first, second, progress=stop)
    assert threading.active_count() == threads
    _same(compare(first, second), expected)


# what cannot be compared


LINE = np.column_stack((np.arange(5.0), 2.0 * np.arange(5.0)))
GOOD = _cloud(_lattice(5, 5), 0.0, "good.ply")
BAD: list[tuple[str, Surface, dict[str, Any], str]] = [
    ("one_line", _cloud(LINE, 0.0, "bad.ply"), {}, "bad.ply: all nodes lie on one line"),
    ("two_nodes", _cloud(LINE[:2], 0.0, "bad.ply"), {}, "bad.ply: 2 nodes; at least 3"),
    ("no_node", _cloud(LINE[:0], 0.0, "bad.ply"), {}, "bad.ply: 0 nodes; at least 3"),
    ("one_place", _cloud(LINE[[0] * 9], 0.0, "bad.ply"), {}, "bad.ply: 1 distinct nodes; at"),
    (
        "two_places",
        _cloud(LINE[[0, 1] * 9], 0.0, "bad.ply"),
        {"duplicates": "max"},
        "bad.ply: 2 distinct nodes; at least 3",
    ),
    (
        "two_values",
        _cloud(np.concatenate((_lattice(3, 3), _lattice(3, 3))), np.arange(18.0), "bad.ply"),
        {},
        "bad.ply: not one-valued: 9 places",
    ),
    ("elsewhere", _cloud(_lattice(4, 4) + 50.0, 0.0, "bad.ply"), {}, "bad.ply.*no common area"),
    ("far_away", _cloud(_lattice(4, 4) + 1e12, 0.0, "bad.ply"), {}, "bad.ply.*no common area"),
    (
        "no_area",
        Surface(GOOD.points, np.array([[0, 1, 2]], np.int32), "bad.ply"),
        {},  # the nodes that no triangle uses are no part of it
        "bad.ply.*all nodes lie on one line",
    ),
    ("nothing_short", GOOD, {"max_edge": 1e-9}, "good.ply and good.ply: no common area"),
]


@pytest.mark.parametrize(
    ("bad", "options", "message"), [b[1:] for b in BAD], ids=[b[0] for b in BAD]
)
def test_what_cannot_be_compared(bad: Surface, options: dict[str, Any], message: str) -> None:
    for pair in ((bad, GOOD), (GOOD, bad)):
        with pytest.raises(InputError, match=message) as caught:
            compare(*pair, **options)
        assert "\n" not in str(caught.value)


def test_coordinates_that_span_too_much() -> None:
    nodes = _lattice(3, 3) * 1e140
    nodes[0] = [1e-140, 0.0]
    with pytest.raises(InputError, match="span too many magnitudes"):
        compare(_cloud(nodes, 0.0), GOOD)


def test_hulls_that_touch_have_no_common_area() -> None:
    beside = _cloud(_lattice(5, 5) + np.array([1.0, 0.0]), 0.0, "beside.ply")
    with pytest.raises(InputError, match=r"^good\.ply and beside\.ply: no common area to compare$"):
        compare(GOOD, beside, domain="hull")
    assert compare(GOOD, beside, domain="plane").measures.area_compared == pytest.approx(2.0)


def test_duplicates_as_told() -> None:
    nodes = np.concatenate((_lattice(3, 3), _lattice(3, 3)))
    torn = _cloud(nodes, np.repeat([1.0, 4.0], 9), "torn.ply")
    for how, value in (("mean", 2.5), ("max", 4.0), ("min", 1.0)):
        result = compare(torn, GOOD, duplicates=how, max_edge=np.inf)  # type: ignore[arg-type]
        assert result.measures.mean_abs == pytest.approx(value)
        assert result.grids[0].merged == 9
        assert result.options.duplicates == how


def test_a_pair_of_unlike_sizes_is_questioned() -> None:
    def square(side: float, name: str) -> Surface:
        return dataclasses.replace(_cloud(_lattice(5, 5, side), 0.0, name), unit="mm")

    assert compare(square(5.0, "a"), square(1.0, "b")).warnings == ()
    (question,) = compare(square(6.5, "a"), square(1.0, "b")).warnings
    assert question.startswith("a and b: one is 6.5 times as large as the other")
