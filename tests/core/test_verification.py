"""What must hold of every comparison is checked; what does not hold is never a number."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.__main__ import main
from surfcmp_core import Comparison, Surface, compare
from surfcmp_core.comparing import stages
from surfcmp_core.comparing.verification import (
    check_chains,
    check_cover,
    check_exchange,
    check_half_edges,
    check_measures,
    check_nodes,
    check_sums,
    check_united,
    check_values,
)
from surfcmp_core.errors import InputError, Violation
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import half_edges
from surfcmp_core.united import United
from tests.pairs import FAMILIES, Nodes, pair_of


def _surface(nodes: Nodes, seed: int, name: str) -> Surface:
    rng = np.random.default_rng(seed)
    return Surface(np.column_stack((nodes, rng.normal(size=len(nodes)))), name=name, unit="mm")


@pytest.fixture(scope="module")
def pair() -> tuple[Surface, Surface]:
    rng = np.random.default_rng(1)
    return _surface(rng.random((90, 2)), 1, "one"), _surface(rng.random((80, 2)), 2, "two")


@pytest.fixture(scope="module")
def result(pair: tuple[Surface, Surface]) -> Comparison:
    return compare(*pair, domain="hull", exact=True, verify=True)


@pytest.fixture(scope="module")
def exchanged(pair: tuple[Surface, Surface]) -> Comparison:
    return compare(*pair[::-1], domain="hull", exact=True)


def _areas(united: United) -> Any:
    a, b, c = united.nodes[united.triangles.T]
    u, v = b - a, c - a
    return 0.5 * (u[:, 0] * v[:, 1] - v[:, 0] * u[:, 1])


def _without_one(united: United) -> United:
    return replace(united, triangles=united.triangles[1:])


def _one_twice(united: United) -> United:
    triangles = united.triangles.copy()
    triangles[7] = triangles[8]
    return replace(united, triangles=triangles)


def _another_corner(united: United) -> United:
    triangles = united.triangles.copy()
    apart = np.flatnonzero(~np.isin(np.arange(len(united.nodes)), triangles[5]))
    triangles[5, 1] = apart[0]
    return replace(united, triangles=triangles)


def _turned_over(united: United) -> United:
    triangles = united.triangles.copy()
    triangles[5] = triangles[5, ::-1]
    return replace(united, triangles=triangles)


def _a_node_pulled_across(united: United) -> United:
    """All edges fit, but triangles lie over each other."""
    nodes = united.nodes.copy()
    inner = int(np.argmin(np.abs(nodes - 0.5).sum(axis=1)))
    nodes[inner] = (0.05, 0.06)
    return replace(united, nodes=nodes)


def _a_node_left_out(united: United) -> United:
    nodes = np.concatenate((united.nodes, [[0.5, 0.5]]))
    return replace(united, nodes=nodes)


COVERS = {
    _without_one: "Euler",
    _one_twice: "cover the convex hull once",
    _another_corner: "cover the convex hull once|in no triangle",
    _turned_over: "cover the convex hull once",
    _a_node_pulled_across: "turned over",
    _a_node_left_out: "Euler",
}


@pytest.mark.parametrize("wrong", COVERS, ids=lambda f: f.__name__.strip("_"))
def test_a_wrong_cover_shows(wrong: Callable[[United], United], result: Comparison) -> None:
    united, (first, second) = wrong(result.united), result.triangulations
    check_cover(result.united, first, second, _areas(result.united))
    with pytest.raises(Violation, match=COVERS[wrong]):
        check_cover(united, first, second, _areas(united), threads=2)


def test_a_violation_is_one_line_and_the_input_is_kept(
    pair: tuple[Surface, Surface],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(
        "surfcmp_core.comparing.verification.evidence.user_state_path", lambda name: tmp_path / name
    )
    unite = stages.unite
    monkeypatch.setattr(stages, "unite", lambda *args: _one_twice(unite(*args)))
    files = [tmp_path / "one.xyz", tmp_path / "two.xyz"]
    for file, surface in zip(files, pair, strict=True):
        np.savetxt(file, surface.points, fmt="%.17g")
    out = tmp_path / "result.json"
    assert main(["compare", *map(str, files), "--out", str(out)]) == 3
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err.count("\n") == 1
    assert "one.xyz and two.xyz: a fault of this program, please report it: the triang" in told.err
    assert not out.exists()
    (kept,) = (tmp_path / "surfcmp" / "violations").iterdir()
    assert str(kept) in told.err
    with np.load(kept) as arrays:
        assert np.array_equal(arrays["points_1"], pair[0].points)
        assert np.array_equal(arrays["points_2"], pair[1].points)
        assert json.loads(str(arrays["options"]))["domain"] == "data"
        assert "faces_1" not in arrays
    more = tmp_path / "three.xyz"
    more.write_bytes(files[0].read_bytes())
    table = tmp_path / "table.json"
    assert main(["batch", *map(str, [*files, more]), "--out", str(table)]) == 3
    assert [("fault of this program" in p["error"]) for p in json.loads(table.read_text())["pairs"]]


def _flipped(united: United) -> United:
    """T after an edge between two triangles is turned: it is not Delaunay any longer."""
    edges = half_edges(united.triangles, len(united.nodes))
    assert edges is not None
    start, twin = edges
    real = len(united.triangles)
    for h in range(3 * real):
        k = int(twin[h])
        if k >= 3 * real:
            continue
        a, b, c = (start[h // 3 * 3 + (h + i) % 3] for i in range(3))
        a, b, c = (
            start[h],
            start[h - 2 if h % 3 == 2 else h + 1],
            start[h + 2 if h % 3 == 0 else h - 1],
        )
        d = start[k + 2 if k % 3 == 0 else k - 1]
        triangles = start[: 3 * real].reshape(-1, 3).copy()
        triangles[h // 3], triangles[k // 3] = (a, d, c), (d, b, c)
        if _areas(replace(united, triangles=triangles)).min() > 0:
            return replace(united, triangles=triangles)
    raise AssertionError


def _changed(name: str, change: Callable[[Any], None]) -> Callable[[United], United]:
    def changed(united: United) -> United:
        array = getattr(united, name).copy()
        change(array)
        return replace(united, **{name: array})

    return changed


def _next_chains(united: United) -> United:
    """Two triangles of one chain that are no neighbours change places."""
    inside = np.flatnonzero(united.chain == np.argmax(np.bincount(united.chain + 1)[1:]))
    order = np.arange(len(united.triangles))
    order[inside[[1, 4]]] = order[inside[[4, 1]]]
    return replace(united, triangles=united.triangles[order])


UNITED: dict[str, tuple[Callable[[United], United], str]] = {
    "an edge flipped": (_flipped, "1 edges of T are not Delaunay|not of T"),
    "a triangle missing": (_without_one, "T is no triangulation"),
    "label": (_changed("label", lambda a: a.__setitem__(0, 2)), "the wrong label"),
    "origin": (_changed("origin", lambda a: a.__setitem__(0, 3 - a[0])), "not of T. as said"),
    "closed": (_changed("chain_closed", lambda a: a.__setitem__(0, not a[0])), "closed as it says"),
    "chain": (_changed("chain", lambda a: a.__setitem__(-1, -1)), "interface|made of"),
    "order in a chain": (_next_chains, "beside the one before"),
    "tree": (_changed("tree1", lambda a: a.__setitem__(0, a[1])), "does not span"),
    "tree elsewhere": (_changed("tree1", lambda a: a.__setitem__((0, 0), 85)), "tree"),
    "node": (_changed("nodes", lambda a: a.__setitem__(3, a[3] + 1e-9)), "not where it is"),
}


@pytest.mark.parametrize("kind", UNITED)
def test_what_is_wrong_with_T_shows(kind: str, result: Comparison) -> None:
    wrong, said = UNITED[kind]
    check_united(result.united, *result.triangulations)
    with pytest.raises(Violation, match=said):
        check_united(wrong(result.united), *result.triangulations)


def test_a_longer_tree_shows(result: Comparison) -> None:
    united, first = result.united, result.triangulations[0]
    tree = united.tree1.copy()
    edges = {
        frozenset(e) for t in first.triangles.tolist() for e in zip(t, t[1:] + t[:1], strict=True)
    }
    for edge in edges - {frozenset(e) for e in tree.tolist()}:
        for k in range(len(tree)):
            trial = tree.copy()
            trial[k] = sorted(edge)
            try:
                check_united(replace(united, tree1=trial), *result.triangulations)
            except Violation as fault:
                if "shortest" in str(fault):
                    return
    raise AssertionError


def _broken(triangulation: Triangulation, place: int, value: int) -> Triangulation:
    twin = triangulation.twin.copy()
    twin[place] = value
    return triangulation._replace(twin=twin)


def test_half_edges_that_do_not_fit_show(result: Comparison) -> None:
    first = result.triangulations[0]
    with pytest.raises(Violation, match="do not fit"):
        check_half_edges(_broken(first, 0, 1))
    with pytest.raises(Violation, match="not where it is"):
        check_nodes(result.united, result.triangulations[1], first)
    check_chains(result.united)


VALUES: dict[str, Callable[[Comparison], Comparison]] = {
    "F̂": lambda r: replace(r, z1=r.z1 + 1e-9 * (r.united.label != 1)),
    "F": lambda r: replace(r, z2=r.z2 + 1e-15 * (r.united.label == 2)),
    "too near": lambda r: replace(
        r, measures=replace(r.measures, hausdorff_1_2=r.measures.hausdorff_1_2 * 0.9)
    ),
}


@pytest.mark.parametrize("kind", VALUES)
def test_wrong_values_show(kind: str, result: Comparison) -> None:
    check_values(result)
    with pytest.raises(Violation):
        check_values(VALUES[kind](result))


SUMS = ("rho_V", "rho_delta_V", "mean_abs", "mean_abs_interface", "mean_signed", "rms", "max_abs")
SUMS += ("p50", "p90", "p95", "volume_below", "area_compared", "area_interface")


@pytest.mark.parametrize("name", SUMS)
def test_wrong_sums_show(name: str, result: Comparison, exchanged: Comparison) -> None:
    check_sums(result)
    check_exchange(result.measures, exchanged.measures)
    value = getattr(result.measures, name)
    wrong = replace(result.measures, **{name: value * 1.02 + 1e-3 * (value == 0)})
    with pytest.raises(Violation, match=name):
        check_sums(replace(result, measures=wrong))
    with pytest.raises(Violation, match=name):
        check_exchange(wrong, exchanged.measures)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"rho_V": np.nan}, "rho_V is nan"),
        ({"coverage_1": np.inf}, "coverage_1 is inf"),
        ({"coverage_2": 1.01}, "coverage_2 is 1.01"),
        ({"mean_abs_interface": np.nan}, "mean_abs_interface is nan"),
        ({"rms": 0.0}, "mean_abs is above rms"),
        ({"max_abs": 0.0}, "rms is above max_abs"),
        ({"mean_signed": -9.0}, "mean_signed is above mean_abs"),
        ({"p90": 0.0}, "p50 is above p90"),
        ({"volume_above": 0.0}, "volumes"),
        ({"within_tolerance": {"1": 1.1}}, "beyond 0 to 1"),
        ({"within_tolerance": {"1": 0.9, "10": 0.8}}, "larger tolerance has less"),
        ({"area_interface": 9.0}, "interface is larger"),
        ({"rho_delta_V": 1e9}, "rho_delta_V is above"),
    ],
)
def test_measures_out_of_order_show(change: dict[str, Any], said: str, result: Comparison) -> None:
    check_measures(result.measures)
    with pytest.raises(Violation, match=said):
        check_measures(replace(result.measures, **change))


@pytest.mark.parametrize("domain", ["data", "hull", "plane"])
@pytest.mark.parametrize("family", FAMILIES)
def test_all_holds_on_all_families(family: str, domain: Any) -> None:
    for seed in range(20, 23):
        grids = pair_of(family, seed)
        first = _surface(grids.first, seed, "one")
        second = _surface(grids.second, seed + 1, "two")
        try:
            compare(first, second, domain=domain, exact=True, verify=True)
        except InputError as refused:
            told = str(refused)
            assert "no common area" in told
