"""Pairs of real scans and terrain, where they are at hand, and of our own making always."""

import json
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.tri import LinearTriInterpolator, Triangulation

from surfcmp_core import Comparison, Surface, compare
from surfcmp_core.comparing.verification import check_chains, check_half_edges, check_nodes
from surfcmp_core.triangulation import triangulate
from tests.invariants import (
    Merged,
    check_delaunay,
    check_triangles,
)
from tests.scans import MADE_PAIRS

PAIRS = [
    ("ct_skin", "ct_skull"),
    ("face_avg_f18", "face_avg_f66"),
    ("face_demo_10k", "face_demo_1k"),
    ("face_ict_neutral", "face_ict_smile"),
    ("face_nricp_source", "face_nricp_target"),
    ("jaw_crowns_pred_L0", "jaw_crowns_ref_L0"),
    ("large_pozo_fl8706", "large_pozo_fl8707"),
    ("terrain_leo_20180606", "terrain_leo_20180920"),
    ("terrain_ttp_2015", "terrain_ttp_2023"),
]


@dataclass
class ScannedPair:
    names: tuple[str, str]
    comparison: Comparison
    monte_carlo: dict[str, Any]


@pytest.fixture(scope="module", params=[*PAIRS, *MADE_PAIRS], ids=lambda pair: pair[0])
def scanned(request: pytest.FixtureRequest, scan: Callable[[str], Surface]) -> ScannedPair:
    first, second = (
        replace(surface, points=surface.points.astype(np.float64))
        for surface in map(scan, request.param)
    )
    result = compare(first, second, domain="hull", exact=True)
    if request.param in MADE_PAIRS:
        return ScannedPair(request.param, result, _at_random_places(result))
    folder = request.getfixturevalue("shared") / "data"
    values = json.loads((folder / "pairs_monte_carlo.json").read_text())
    (value,) = (v for v in values if {v["a"], v["b"]} == {first.name, second.name})
    if value["a"] != first.name:
        value["mean_signed"] *= -1.0
    return ScannedPair(request.param, result, value)


def _at_random_places(result: Comparison) -> dict[str, float]:
    """Ask matplotlib for the difference at random places, all over both triangulations."""
    nodes = result.united.nodes
    low, high = nodes.min(axis=0), nodes.max(axis=0)
    places = np.random.default_rng(1).uniform(low, high, (200_000, 2))
    heights = []
    for grid, t in zip(result.grids, result.triangulations, strict=True):
        linear = LinearTriInterpolator(Triangulation(*grid.nodes.T, t.triangles), grid.z)
        heights.append(linear(*places.T).filled(np.nan))
    d = heights[0] - heights[1]
    box = float(np.prod(high - low))
    share = np.isfinite(d)
    area = box * float(share.mean())
    absolute = np.where(share, np.abs(d), 0.0)
    return {
        "mean_abs": float(np.abs(d[share]).mean()),
        "mean_signed": float(d[share].mean()),
        "area": area,
        "se": box * float(absolute.std()) / len(places) ** 0.5,
    }


def test_no_pair_is_missing(shared: Path) -> None:
    entries = json.loads((shared / "data" / "manifest.json").read_text())
    listed = {frozenset((e["name"], other)) for e in entries for other in e["pairs_with"]}
    assert listed == {frozenset(pair) for pair in PAIRS}


def test_grids_are_triangulated(scanned: ScannedPair) -> None:
    for triangulation in scanned.comparison.triangulations:
        check_half_edges(triangulation)
        if triangulation.real < 100_000:
            check_delaunay(triangulation, ties=50)


def test_grids_are_merged(scanned: ScannedPair) -> None:
    united = scanned.comparison.united
    merged = Merged(united, *scanned.comparison.triangulations)
    check_nodes(merged.united, merged.first, merged.second)
    check_triangles(merged, triangulate(united.nodes).triangles)
    check_chains(united)


def test_areas_add_up(scanned: ScannedPair) -> None:
    result = scanned.comparison
    compared = result.compared
    assert compared.any()
    assert np.array_equal(np.isnan(result.area), ~compared)
    assert np.nansum(result.area) == pytest.approx(result.measures.area_compared, rel=1e-12)
    total = np.nansum(result.area * result.mean_abs)
    assert total / np.nansum(result.area) == pytest.approx(result.measures.mean_abs, rel=1e-12)
    signed = np.nansum(result.area * result.mean_signed)
    volumes = result.measures.volume_above - result.measures.volume_below
    assert signed == pytest.approx(volumes, rel=1e-9, abs=1e-9 * total)


def test_mean_difference_is_near_that_of_random_places(scanned: ScannedPair) -> None:
    found, known = scanned.comparison.measures, scanned.monte_carlo
    assert 0.95 <= found.mean_abs / known["mean_abs"] <= 1.16
    # the exact reading has no excuse
    assert found.exact is not None
    assert found.exact.area_compared == pytest.approx(known["area"], rel=3e-3)
    slack = 4.0 * known["se"] / known["area"]
    assert found.exact.mean_abs == pytest.approx(known["mean_abs"], abs=slack)
    assert found.exact.mean_signed == pytest.approx(known["mean_signed"], abs=slack)


def test_roles_exchanged(scanned: ScannedPair) -> None:
    first, second = scanned.comparison.surfaces
    swapped = compare(second, first, domain="hull").measures
    found = scanned.comparison.measures
    for name in ("mean_abs", "rms", "max_abs", "rho_V", "rho_delta_V", "p90", "area_compared"):
        assert getattr(swapped, name) == pytest.approx(getattr(found, name), rel=1e-9), name
    assert swapped.mean_signed == pytest.approx(-found.mean_signed, rel=1e-9)


def test_where_both_have_data(scanned: ScannedPair) -> None:
    result = compare(*scanned.comparison.surfaces)
    measures = result.measures
    assert 0.3 < measures.coverage_1 <= 1.0 + 1e-9
    assert 0.3 < measures.coverage_2 <= 1.0 + 1e-9
    assert measures.area_compared <= scanned.comparison.measures.area_compared * (1.0 + 1e-12)
    assert 0.0 < measures.mean_abs <= measures.rms <= measures.max_abs
    assert measures.p50 <= measures.p90 <= measures.p95 <= measures.max_abs
    for z in (result.z1, result.z2):
        assert not np.isnan(z[result.united.triangles[result.compared]]).any()
