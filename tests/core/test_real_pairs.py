"""Pairs of real scans and terrain, where they are at hand."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from surfcmp_core import Comparison, Surface, compare
from surfcmp_core.triangulation import triangulate
from tests.invariants import (
    Merged,
    check_delaunay,
    check_half_edges,
    check_many_chains,
    check_nodes,
    check_triangles,
)

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
class RealPair:
    names: tuple[str, str]
    comparison: Comparison
    monte_carlo: dict[str, Any]


def _surface(folder: Path, name: str) -> Surface:
    path = folder / f"{name}.npz"
    if not path.is_file():
        pytest.skip(f"{path} is absent")
    with np.load(path) as arrays:
        faces = arrays["faces"].astype(np.int32) if "faces" in arrays else None
        points = arrays["points"].astype(np.float64)
    return Surface(points, faces if faces is not None and len(faces) else None, name)


@pytest.fixture(scope="module", params=PAIRS, ids=lambda pair: pair[0])
def real(request: pytest.FixtureRequest, shared: Path) -> RealPair:
    first, second = (_surface(shared / "data", name) for name in request.param)
    values = json.loads((shared / "data" / "pairs_monte_carlo.json").read_text())
    (value,) = (v for v in values if {v["a"], v["b"]} == {first.name, second.name})
    if value["a"] != first.name:
        value["mean_signed"] *= -1.0
    return RealPair(request.param, compare(first, second, domain="hull", exact=True), value)


def test_no_pair_is_missing(shared: Path) -> None:
    entries = json.loads((shared / "data" / "manifest.json").read_text())
    listed = {frozenset((e["name"], other)) for e in entries for other in e["pairs_with"]}
    assert listed == {frozenset(pair) for pair in PAIRS}


def test_real_grids_are_triangulated(real: RealPair) -> None:
    for triangulation in real.comparison.triangulations:
        check_half_edges(triangulation)
        if triangulation.real < 100_000:
            check_delaunay(triangulation, ties=50)


def test_real_grids_are_merged(real: RealPair) -> None:
    united = real.comparison.united
    merged = Merged(united, *real.comparison.triangulations)
    check_nodes(merged)
    check_triangles(merged, triangulate(united.nodes).triangles)
    check_many_chains(united)


def test_areas_add_up(real: RealPair) -> None:
    result = real.comparison
    compared = result.compared
    assert compared.any()
    assert np.array_equal(np.isnan(result.area), ~compared)
    assert np.nansum(result.area) == pytest.approx(result.measures.area_compared, rel=1e-12)
    total = np.nansum(result.area * result.mean_abs)
    assert total / np.nansum(result.area) == pytest.approx(result.measures.mean_abs, rel=1e-12)
    signed = np.nansum(result.area * result.mean_signed)
    volumes = result.measures.volume_above - result.measures.volume_below
    assert signed == pytest.approx(volumes, rel=1e-9, abs=1e-9 * total)


def test_mean_difference_is_near_that_of_random_places(real: RealPair) -> None:
    found, known = real.comparison.measures, real.monte_carlo
    assert 0.95 <= found.mean_abs / known["mean_abs"] <= 1.16
    # the exact reading has no excuse
    assert found.exact is not None
    assert found.exact.area_compared == pytest.approx(known["area"], rel=3e-3)
    slack = 4.0 * known["se"] / known["area"]
    assert found.exact.mean_abs == pytest.approx(known["mean_abs"], abs=slack)
    assert found.exact.mean_signed == pytest.approx(known["mean_signed"], abs=slack)


def test_roles_exchanged(real: RealPair) -> None:
    first, second = real.comparison.surfaces
    swapped = compare(second, first, domain="hull").measures
    found = real.comparison.measures
    for name in ("mean_abs", "rms", "max_abs", "rho_V", "rho_delta_V", "p90", "area_compared"):
        assert getattr(swapped, name) == pytest.approx(getattr(found, name), rel=1e-9), name
    assert swapped.mean_signed == pytest.approx(-found.mean_signed, rel=1e-9)


def test_where_both_have_data(real: RealPair) -> None:
    result = compare(*real.comparison.surfaces)
    measures = result.measures
    assert 0.3 < measures.coverage_1 <= 1.0 + 1e-9
    assert 0.3 < measures.coverage_2 <= 1.0 + 1e-9
    assert measures.area_compared <= real.comparison.measures.area_compared * (1.0 + 1e-12)
    assert 0.0 < measures.mean_abs <= measures.rms <= measures.max_abs
    assert measures.p50 <= measures.p90 <= measures.p95 <= measures.max_abs
    for z in (result.z1, result.z2):
        assert not np.isnan(z[result.united.triangles[result.compared]]).any()
