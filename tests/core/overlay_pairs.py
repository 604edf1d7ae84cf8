"""Pairs of triangulations to lay over each other, and their measures in rationals."""

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from surfcmp_core.grid import Grid, box_of, grid_of, shared_nodes
from surfcmp_core.localisation import locate_from
from surfcmp_core.measures import (
    LinearSurface,
    Measures,
    TriangleValues,
    measure_exactly,
)
from surfcmp_core.spanning_tree import spanning_tree
from surfcmp_core.surface import Surface
from surfcmp_core.triangulation import triangulate
from surfcmp_core.united import United, unite

Floats = NDArray[np.float64]
Vector = tuple[Fraction, Fraction]

LAST: dict[str, Any] = {
    "tolerances": (0.25, 1.0),
    "hausdorff": (0.0, 0.0),
}


class Pair:
    """Two clouds, their triangulations and T, ready to be measured."""

    def __init__(self, points_1: Floats, points_2: Floats) -> None:
        clouds = Surface(points_1, name="surface 1"), Surface(points_2, name="surface 2")
        box = box_of(*clouds)
        self.grids: list[Grid] = [grid_of(c, duplicates="mean", box=box) for c in clouds]
        first, second = (triangulate(g.nodes, name=g.name) for g in self.grids)
        trees = spanning_tree(first), spanning_tree(second)
        self.united: United = unite(first, second, *trees, shared_nodes(*self.grids))
        found_1 = locate_from(first, second.nodes, np.zeros(len(second.nodes), np.int32))
        found_2 = locate_from(second, first.nodes, np.zeros(len(first.nodes), np.int32))
        self.surfaces = [
            LinearSurface(t, g.z, t.triangles, np.ones(t.real, bool), found)
            for t, g, found in zip((first, second), self.grids, (found_1, found_2), strict=True)
        ]

    def measure(self, **changed: Any) -> tuple[TriangleValues, Measures]:
        return measure_exactly(self.surfaces[0], self.surfaces[1], self.united, **(LAST | changed))

    def hulls_in_common(self) -> float:
        hulls = []
        for surface in self.surfaces:
            t = surface.triangulation
            ghosts = np.arange(t.real, len(t.start) // 3)
            onward = dict(
                zip(t.start[3 * ghosts + 1].tolist(), t.start[3 * ghosts].tolist(), strict=True)
            )
            walk = [next(iter(onward))]
            while onward[walk[-1]] != walk[0]:
                walk.append(onward[walk[-1]])
            hulls.append(exact(t.nodes[walk]))
        return float(area_of(cut(*hulls)))


def near(value: Any, rel: float) -> Any:
    return pytest.approx(value, rel=rel, abs=0.0)


def exact(nodes: Floats) -> list[Vector]:
    return [(Fraction(x), Fraction(y)) for x, y in nodes.tolist()]


def turn(a: Vector, b: Vector, c: Vector) -> Fraction:
    return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])


def keep_left(polygon: list[Vector], at: list[Fraction]) -> list[Vector]:
    """Cut where the linear function with these values at the corners is negative."""
    kept = []
    for k, p in enumerate(polygon):
        before = polygon[k - 1]
        if at[k - 1] * at[k] < 0:
            s = at[k - 1] / (at[k - 1] - at[k])
            kept.append((before[0] + s * (p[0] - before[0]), before[1] + s * (p[1] - before[1])))
        if at[k] >= 0:
            kept.append(p)
    return kept


def cut(polygon: list[Vector], by: list[Vector]) -> list[Vector]:
    for k, q in enumerate(by):
        if polygon:
            polygon = keep_left(polygon, [turn(by[k - 1], q, p) for p in polygon])
    return polygon


def area_of(polygon: list[Vector]) -> Fraction:
    fan = range(1, len(polygon) - 1)
    return sum((turn(polygon[0], polygon[k], polygon[k + 1]) for k in fan), Fraction(0)) / 2


def linear(corners: list[Vector], z: list[float]) -> Any:
    a, b, c = corners
    whole = turn(a, b, c)

    def value(p: Vector) -> Fraction:
        parts = turn(b, c, p), turn(c, a, p), turn(a, b, p)
        return sum((w * Fraction(v) for w, v in zip(parts, z, strict=True)), Fraction(0)) / whole

    return value


def product_over(polygon: list[Vector], f: list[Fraction], g: list[Fraction]) -> Fraction:
    """∬ f g of linear functions given at the corners."""
    total = Fraction(0)
    for k in range(1, len(polygon) - 1):
        i = (0, k, k + 1)
        fs, gs = [f[j] for j in i], [g[j] for j in i]
        both = sum((x * y for x, y in zip(fs, gs, strict=True)), Fraction(0))
        area = turn(polygon[0], polygon[k], polygon[k + 1]) / 2
        total += area * (both + sum(fs, Fraction(0)) * sum(gs, Fraction(0))) / 12
    return total


def by_brute_force(pair: Pair, weight: list[float]) -> tuple[NDArray[Any], dict[str, Fraction]]:
    """Area, ∬|d|, ∬d of every triangle of T, and further integrals, over all triples."""
    united = pair.united
    places = exact(united.nodes)
    rows = []
    totals = dict.fromkeys(("square", "weighted", "within", "whole"), Fraction(0))
    sides = [
        [
            (
                [(Fraction(x), Fraction(y)) for x, y in s.triangulation.nodes[t].tolist()],
                s.z[t].tolist(),
            )
            for t in s.triangulation.triangles[s.valid]
        ]
        for s in pair.surfaces
    ]
    for t in united.triangles.tolist():
        corners = [places[v] for v in t]
        mu = linear(corners, [weight[v] for v in t])
        row = [Fraction(0)] * 3
        weighted = Fraction(0)
        for corners_1, z_1 in sides[0]:
            part = cut(corners, corners_1)
            if area_of(part) == 0:
                continue
            for corners_2, z_2 in sides[1]:
                piece = cut(part, corners_2)
                if area_of(piece) == 0:
                    continue
                f_1, f_2 = linear(corners_1, z_1), linear(corners_2, z_2)
                d = [f_1(p) - f_2(p) for p in piece]
                ones = [Fraction(1)] * len(piece)
                row[0] += area_of(piece)
                row[2] += product_over(piece, d, ones)
                totals["square"] += product_over(piece, d, d)
                for sign in (1, -1):
                    half = keep_left(piece, [sign * v for v in d])
                    d_half = [sign * (f_1(p) - f_2(p)) for p in half]
                    row[1] += product_over(half, d_half, [Fraction(1)] * len(half))
                    weighted += product_over(half, d_half, [mu(p) for p in half])
                strip = keep_left(piece, [Fraction(1, 4) - v for v in d])
                if strip:
                    strip = keep_left(strip, [f_1(p) - f_2(p) + Fraction(1, 4) for p in strip])
                totals["within"] += area_of(strip)
        totals["weighted"] += weighted / area_of(corners)
        totals["whole"] += row[1] / area_of(corners)
        rows.append(row)
    return np.array(rows), totals


def check(pair: Pair, slack: float = 1e-12) -> None:
    weight = [(7 * v % 5) / 4.0 for v in range(len(pair.united.nodes))]
    values, found = pair.measure(node_weight=np.array(weight))
    rows, totals = by_brute_force(pair, weight)
    area, volume, signed = rows.astype(float).T
    height = float(max(abs(s.z).max() for s in pair.surfaces)) + 1.0
    most = slack * nodal_area(pair).max()
    # What is lost to rounding may be all that a triangle has.
    there = ~np.isnan(values.area)
    assert np.nan_to_num(values.area) == pytest.approx(area, rel=slack, abs=most)
    small = most * height
    assert (values.area * values.mean_abs)[there] == pytest.approx(
        volume[there], rel=slack, abs=small
    )
    assert (values.area * values.mean_signed)[there] == pytest.approx(
        signed[there], rel=slack, abs=small
    )
    whole = area.sum()
    if whole == 0.0:
        assert found.area_compared == 0.0
        return
    assert found.area_compared == pytest.approx(whole, rel=slack, abs=most)
    assert found.volume_above + found.volume_below == pytest.approx(
        volume.sum(), rel=slack, abs=small
    )
    assert found.volume_above - found.volume_below == pytest.approx(
        signed.sum(), rel=slack, abs=small
    )
    assert found.mean_abs == pytest.approx(volume.sum() / whole, rel=slack, abs=slack * height)
    assert found.rms**2 * whole == pytest.approx(
        float(totals["square"]), rel=slack, abs=small * height
    )
    assert found.within_tolerance["0.25"] * whole == pytest.approx(
        float(totals["within"]), rel=1e-9, abs=1e-9 * whole
    )
    assert found.rho_V == pytest.approx(float(totals["whole"]), rel=1e-9, abs=1e-9)
    assert found.rho_V_mu == pytest.approx(float(totals["weighted"]), rel=1e-9, abs=1e-9)


def nodal_area(pair: Pair) -> Floats:
    a, b, c = (pair.united.nodes[pair.united.triangles[:, k]] for k in range(3))
    u, v = b - a, c - a
    return np.asarray((u[:, 0] * v[:, 1] - v[:, 0] * u[:, 1]) / 2.0)
