"""The exact reading against overlays cut in rationals, and against Monte-Carlo values."""

import json
import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from surfcmp_core.errors import Cancelled
from surfcmp_core.measures import (
    Covered,
    measure,
)
from surfcmp_core.triangulation import is_flat
from tests.core.overlay_pairs import LAST, Pair, check, near, nodal_area


def pair_of(*clouds: list[tuple[float, float, float]]) -> Pair | None:
    """Merge what stands at one place; None where a cloud has no triangle."""
    unique = [
        np.array([(x, y, z) for (x, y), z in {(x, y): z for x, y, z in c}.items()]) for c in clouds
    ]
    if any(len(c) < 3 or is_flat(c[:, :2]) for c in unique):
        return None
    return Pair(*unique)


lattice_node = st.tuples(st.integers(0, 4), st.integers(0, 4), st.integers(-2, 2))
free_node = st.tuples(st.floats(-3.0, 7.0), st.floats(-3.0, 7.0), st.floats(-2.0, 2.0))
lattice_cloud = st.lists(lattice_node, min_size=3, max_size=7)
free_cloud = st.lists(free_node, min_size=3, max_size=7)
cloud = st.one_of(
    lattice_cloud, free_cloud.map(lambda c: [(round(x, 2), round(y, 2), z) for x, y, z in c])
)


@settings(max_examples=60)
@given(cloud, cloud, st.integers(0, 3))
@example([(0, 0, 0), (5, 1, 0), (-2, 1, 0)], [(0, 4.88, 0), (5, 1, 0), (-1, 1, 0)], 0)  # touch
@example([(0, 0, 0), (0, 1, 0), (1, 1, 0)], [(0, 0, 0), (0, 2, 0), (1, 0, 0)], 0)
def test_against_all_triples_in_rationals(
    one: list[tuple[float, float, float]], two: list[tuple[float, float, float]], holes: int
) -> None:
    pair = pair_of(one, two)
    if pair is not None:
        for surface in pair.surfaces:
            surface.valid[:holes] = False
        check(pair)


def test_strip_across_a_triangle() -> None:
    # No node of the strip is near the triangle it crosses, whose corners are all outside it.
    strip = [(-20.0, 3.0, 0.0), (-20.0, 4.0, 1.0), (30.0, 3.2, 2.0), (30.0, 4.2, -1.0)]
    triangle = [(0.0, 0.0, 0.5), (10.0, 0.0, 0.0), (5.0, 10.0, 1.0)]
    for clouds in ((strip, triangle), (triangle, strip)):
        pair = pair_of(*clouds)
        assert pair is not None
        assert pair.united.origin.max() > 0
        check(pair)
        assert pair.measure()[1].area_compared > 6.0


@pytest.mark.parametrize("third", [(3.0, 1.0, -1.0), (1.0, 3.0, -1.0)])
def test_triangle_with_two_corners_on_an_edge(third: tuple[float, float, float]) -> None:
    kite = [(0.0, 0.0, 1.0), (6.0, -5.0, 0.0), (6.0, 6.0, 2.0), (-5.0, 6.0, -1.0)]
    triangle = [(1.0, 1.0, 0.5), (3.0, 3.0, 1.0), third]
    for clouds in ((kite, triangle), (triangle, kite)):
        pair = pair_of(*clouds)
        assert pair is not None
        assert pair.measure()[1].area_compared == pytest.approx(2.0)
        check(pair)


def test_star_of_two_triangles() -> None:
    # All three edges of the larger one run through the smaller one, a triangle of T.
    small, large = (
        [
            (r * math.cos(k * 2.0943951 + turn), r * math.sin(k * 2.0943951 + turn), z)
            for k in range(3)
        ]
        for r, turn, z in ((1.0, 0.0, 1.0), (1.5, 1.0471976, -1.0))
    )
    for clouds in ((small, large), (large, small)):
        pair = pair_of(*clouds)
        assert pair is not None
        assert pair.united.origin.max() > 0
        check(pair)


def test_nothing_in_common() -> None:
    pair = Pair(
        np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]]),
        np.array([[5.0, 0.0, 1.0], [6.0, 0.0, 1.0], [5.0, 1.0, 1.0]]),
    )
    values, found = pair.measure()
    assert np.isnan(values.area).all()
    assert found.area_compared == found.rho_V == 0.0
    assert math.isnan(found.mean_abs)


def random_pair(seed: int, n1: int, n2: int, offset: float = 0.0, shrink: float = 1.0) -> Pair:
    rng = np.random.default_rng(seed)
    one, two = rng.random((n1, 3)), rng.random((n2, 3))
    two[:, :2] = 0.4 + two[:, :2] * shrink
    for points in (one, two):
        points[:, :2] += offset
        points[:, 2] = np.sin(5.0 * (points[:, 0] - offset)) + 0.05 * points[:, 2]
    return Pair(one, two)


@pytest.mark.parametrize(
    ("n1", "n2", "offset", "shrink"),
    [
        (300, 300, 0.0, 1.0),
        (300, 20, 0.0, 1.0),
        (20, 300, 1e6, 1.0),
        (30, 300, 0.0, 1e-6),
        (300, 300, 0.0, 0.5),
    ],
)
def test_areas_fill_what_both_hulls_cover(n1: int, n2: int, offset: float, shrink: float) -> None:
    pair = random_pair(0, n1, n2, offset, shrink)
    values, found = pair.measure()
    assert found.area_compared == pytest.approx(pair.hulls_in_common(), rel=1e-11, abs=0.0)
    assert np.nansum(values.area) == near(found.area_compared, 1e-13)
    volume = np.nansum(values.area * values.mean_abs)
    assert volume == near(found.volume_above + found.volume_below, 1e-13)


def test_tiny_cluster_on_a_long_edge() -> None:
    # Where the edge runs is uncertain by 1e-7 of the cluster: either side must draw it alike.
    kite = np.array([[0.1, 0.2, 1.0], [6.3, -5.1, 0.0], [6.1, 6.7, 2.0], [-5.9, 6.3, -1.0]])
    cluster = np.random.default_rng(7).random((100, 3))
    cluster[:, :2] = np.array([3.1, 3.45]) + 1e-9 * (cluster[:, :2] - 0.5)
    for clouds in ((kite, cluster), (cluster, kite)):
        pair = Pair(*clouds)
        assert pair.measure()[1].area_compared == pytest.approx(
            pair.hulls_in_common(), rel=1e-12, abs=0.0
        )


@pytest.mark.parametrize("shift", [0.0, 0.5, 0.25])
def test_lattices(shift: float) -> None:
    x, y = np.meshgrid(np.arange(12.0), np.arange(12.0))
    one = np.column_stack([x.ravel(), y.ravel(), (x * y).ravel() % 7.0])
    two = one - np.array([shift, shift, 0.25])
    pair = Pair(one, two)
    _, found = pair.measure()
    assert found.area_compared == near((11.0 - shift) ** 2, 1e-13)
    if shift == 0.0:
        assert found.mean_signed == found.mean_abs == found.max_abs == found.p50 == 0.25


def test_equal_surfaces_differ_by_nothing() -> None:
    points = np.random.default_rng(1).random((200, 3)) + np.array([0.0, 0.0, 1e6])
    _, found = Pair(points, points[::-1].copy()).measure()
    assert found.max_abs == found.rho_V == found.rms == found.mean_signed == 0.0
    assert found.within_tolerance == {"0.25": 1.0, "1": 1.0}


def test_planes_have_one_reading() -> None:
    pair = random_pair(2, 60, 50, shrink=0.5)
    for surface, slope in zip(pair.surfaces, (0.5, -1.0), strict=True):
        surface.z[:] = surface.triangulation.nodes @ [slope, 0.25] - 0.4 * slope
    z_1, z_2 = (pair.united.nodes @ [slope, 0.25] - 0.4 * slope for slope in (0.5, -1.0))
    values, found = pair.measure()
    full = np.abs(values.area - nodal_area(pair)) <= 1e-12
    nodal, _ = measure(
        pair.united.nodes,
        pair.united.label,
        pair.united.triangles,
        z_1,
        z_2,
        full,
        footprint_1=Covered(1.0),
        footprint_2=Covered(1.0),
        **LAST,
    )
    assert values.mean_abs[full] == pytest.approx(nodal.mean_abs[full], rel=1e-10, abs=1e-14)
    assert values.mean_signed[full] == pytest.approx(nodal.mean_signed[full], rel=1e-10, abs=1e-14)
    assert found.max_abs >= np.nanmax(values.mean_abs)


def test_exchange_changes_signs_only() -> None:
    pair = random_pair(3, 150, 90, shrink=0.8)
    _, found = pair.measure()
    other = Pair(
        *(np.column_stack([g.nodes, g.z]) for g in reversed(pair.grids)),
    )
    _, exchanged = other.measure()
    assert exchanged.mean_signed == near(-found.mean_signed, 1e-12)
    assert exchanged.volume_above == near(found.volume_below, 1e-12)
    for key in ("area_compared", "mean_abs", "rms", "max_abs", "rho_V", "rho_delta_V", "p90"):
        assert getattr(exchanged, key) == near(getattr(found, key), 1e-12), key


def test_unit_of_length_is_a_power_of_two() -> None:
    pair = random_pair(4, 80, 80)
    values, found = pair.measure()
    small = random_pair(4, 80, 80)
    for nodes in (small.united.nodes, *(s.triangulation.nodes for s in small.surfaces)):
        nodes *= 2.0**-20
    small_values, same = small.measure(length=2.0**20)
    assert same == found
    assert np.array_equal(small_values.area, values.area, equal_nan=True)


def test_triangles_may_be_taken_a_few_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    pair = random_pair(6, 30, 30)
    _, found = pair.measure()
    shares: list[float] = []
    monkeypatch.setattr("surfcmp_core.measures.chunks.AT_ONCE", 7)
    assert pair.measure(progress=shares.append)[1] == found
    assert pair.measure(threads=3)[1] == found
    assert shares == sorted(shares)
    assert 0.9 < shares[-1] < 1.0


def test_progress_may_cancel() -> None:
    def stop(_share: float) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        random_pair(5, 10, 10).measure(progress=stop)


def pairs_of_scans() -> list[tuple[str, str]]:
    return [
        ("face_avg_f18", "face_avg_f66"),
        ("face_demo_10k", "face_demo_1k"),
        ("face_ict_neutral", "face_ict_smile"),
        ("face_nricp_source", "face_nricp_target"),
        ("jaw_crowns_pred_L0", "jaw_crowns_ref_L0"),
        ("ct_skin", "ct_skull"),
        ("terrain_ttp_2015", "terrain_ttp_2023"),
        ("terrain_leo_20180606", "terrain_leo_20180920"),
    ]


@pytest.mark.parametrize(("a", "b"), pairs_of_scans())
def test_monte_carlo_over_both_hulls(shared: Path, a: str, b: str) -> None:
    known = {
        (k["a"], k["b"]): k
        for k in json.loads((shared / "data/pairs_monte_carlo.json").read_text())
    }
    points = [np.load(shared / f"data/{name}.npz")["points"].astype(np.float64) for name in (a, b)]
    pair = Pair(*points)
    _, found = pair.measure()
    volume = found.volume_above + found.volume_below
    assert abs(volume - known[a, b]["int_abs"]) <= 4.0 * known[a, b]["se"]
    assert found.area_compared == pytest.approx(pair.hulls_in_common(), rel=1e-11, abs=0.0)
