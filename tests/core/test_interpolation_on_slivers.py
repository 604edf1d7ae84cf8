"""Planes are met to some last bits on triangles of any shape, above all on those of rounding only.

On turned grids the hulls of T1 and T2 are lined with triangles whose height is the rounding of the
coordinates, and nodes of the other grid lie in them.
"""

from fractions import Fraction

import numpy as np
import pytest
from numpy.typing import NDArray

from surfcmp_core import Surface, compare
from surfcmp_core.comparing.options import Domain
from surfcmp_core.grid import safe_scale
from surfcmp_core.interpolation import interpolate
from surfcmp_core.localisation import locate_from
from surfcmp_core.triangulation import Triangulation, triangulate
from tests.pairs import FAMILIES, Nodes, distinct, pair_of

Floats = NDArray[np.float64]
EPSILON = 2.0**-53
WEIGHTS = 2.0**-45
"""Bound on the error of barycentric weights, each a quotient of areas off by at most 2⁻⁴⁷."""


def turned_grid(side: int, degrees: float, offset: float) -> Nodes:
    """A square lattice, moved along x by a share of a cell and then turned."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    x, y = np.meshgrid(np.arange(side) + offset, np.arange(side) + 0.0)
    cells = np.column_stack((x.ravel(), y.ravel()))
    return np.column_stack((c * cells[:, 0] + s * cells[:, 1], c * cells[:, 1] - s * cells[:, 0]))


def check_planes(first: Nodes, second: Nodes) -> int:
    """Interpolate planes known at `first` in `second`; count the places that lie on slivers."""
    scale = safe_scale(first, second)
    target, queries = triangulate(first * scale), second * scale
    found = locate_from(target, queries, np.zeros(len(queries), np.int32))
    inside = found < target.real
    corners = target.triangles[found[inside]]
    for k in range(2):  # a coordinate itself, not rounded at all
        z = np.ascontiguousarray(target.nodes[:, k])
        values = interpolate(target, z, queries, found)
        assert np.array_equal(np.isnan(values), ~inside)
        spread = np.ptp(z[corners], axis=1)
        error = np.abs(values[inside] - queries[inside, k])
        assert (error <= WEIGHTS * spread + 2 * EPSILON * np.abs(queries[inside, k])).all()
        _check_continued(target, z, queries[~inside], found[~inside])
    _check_mean(target, queries[inside], found[inside])
    a, b, c = (target.nodes[corners[:, k]] for k in range(3))
    u, v = b - a, c - a
    height = np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / np.hypot(*(u - v).T)
    return int((height < 8 * EPSILON * np.abs(target.nodes).max()).sum())


def _check_mean(target: Triangulation, queries: Nodes, found: NDArray[np.int32]) -> None:
    """What is found between values of any kind is a mean of them."""
    z = np.random.default_rng(0).normal(size=len(target.nodes)) ** 9
    values = interpolate(target, z, queries, found)
    corners = z[target.triangles[found]]
    assert (values >= corners.min(axis=1)).all()
    assert (values <= corners.max(axis=1)).all()


def _check_continued(
    target: Triangulation, z: Floats, queries: Nodes, found: NDArray[np.int32]
) -> None:
    """Outside the hull: the value at the nearest place, every edge of the hull tried."""
    edges = target.start[3 * target.real :].reshape(-1, 3)[:, :2].tolist()
    at = [(Fraction(x), Fraction(y)) for x, y in target.nodes.tolist()]
    values = interpolate(target, z, queries, found, continued=True)
    for value, place in zip(values[:30].tolist(), queries[:30].tolist(), strict=True):
        px, py = map(Fraction, place)
        best = None
        for a, b in edges:
            (ax, ay), (bx, by) = at[a], at[b]
            dx, dy = bx - ax, by - ay
            t = ((px - ax) * dx + (py - ay) * dy) / (dx * dx + dy * dy)
            t = min(max(t, Fraction(0)), Fraction(1))
            square = (ax + t * dx - px) ** 2 + (ay + t * dy - py) ** 2
            if best is None or square < best[0]:
                best = square, Fraction(z[a]) + t * (Fraction(z[b]) - Fraction(z[a])), z[a], z[b]
        assert best is not None
        slack = WEIGHTS * abs(best[2] - best[3]) + 2 * EPSILON * max(abs(best[2]), abs(best[3]))
        assert abs(Fraction(value) - best[1]) <= slack


@pytest.mark.parametrize("family", FAMILIES)
def test_planes_are_met_on_all_families(family: str) -> None:
    for seed in range(11, 15):
        pair = pair_of(family, seed)
        check_planes(pair.first, pair.second)


@pytest.mark.parametrize("factor", [1.0, 1e-12, 1e12])
@pytest.mark.parametrize("shift", [0.0, 1e6])
def test_planes_are_met_on_turned_grids(factor: float, shift: float) -> None:
    slivers = 0
    for side, degrees in ((4, 30.0), (10, 17.0), (23, 45.0), (40, 0.001), (31, 61.3)):
        for offset in (0.5, 0.25, 1.0 / 3.0):
            grids = turned_grid(side, degrees, 0.0), turned_grid(side, degrees, offset)
            first, second = (distinct(grid * factor + shift) for grid in grids)
            if min(len(first), len(second)) == side * side:  # else rounding has merged nodes
                slivers += check_planes(first, second)
                slivers += check_planes(second, first)
    assert slivers > 100 or factor < 1.0


@pytest.mark.parametrize("domain", ["data", "hull", "plane"])
@pytest.mark.parametrize(("side", "degrees"), [(4, 30.0), (30, 17.0), (100, 30.0)])
def test_one_plane_on_turned_grids_does_not_differ(
    domain: Domain, side: int, degrees: float
) -> None:
    surfaces = []
    for offset in (0.0, 0.5):
        nodes = turned_grid(side, degrees, offset)
        z = 0.5 * nodes[:, 0] - 0.25 * nodes[:, 1] + 3.0
        surfaces.append(Surface(np.column_stack((nodes, z))))
    result = compare(*surfaces, domain=domain)
    differ = np.abs(result.z1 - result.z2)
    if domain == "plane":  # beyond its hull a surface goes on level
        within = compare(*surfaces, domain="hull")
        differ[np.isnan(within.z1 - within.z2)] = np.nan
    differ = differ[~np.isnan(differ)]
    largest = float(np.abs(np.concatenate([s.points[:, 2] for s in surfaces])).max())
    assert len(differ) > side * side / 2
    assert differ.max() <= 4 * EPSILON * 2 * largest
    if domain != "plane":
        assert result.measures.max_abs <= 4 * EPSILON * 2 * largest
        assert result.measures.rho_V <= result.measures.max_abs * result.compared.sum()
