"""Comparisons whose values anyone can recompute."""

import math

import numpy as np
import pytest

from surfcmp_core import compare
from tests.core.small_surfaces import DOMAINS, Floats, cloud, lattice


def test_gaussian_bell() -> None:
    x, y = np.meshgrid(np.linspace(-5.0, 5.0, 100), np.linspace(-5.0, 5.0, 100))
    nodes = np.column_stack((x.ravel(), y.ravel()))
    bell = cloud(nodes, np.exp(-(nodes**2).sum(axis=1)), "bell")
    corners = cloud(np.array([[-5.0, -5.0], [5.0, -5.0], [5.0, 5.0], [-5.0, 5.0]]), 0.0, "flat")
    flat = cloud(nodes, 0.0, "flat")
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
        nodes = lattice(side + 1, side + 1)
        surface = cloud(nodes, franke(*nodes.T), "franke")
        found = compare(surface, cloud(lattice(2, 2), 0.0, "flat"), max_edge=np.inf).measures
        errors.append(abs(found.volume_above - found.volume_below - 0.40696959))
    assert errors[2] < 2e-5
    assert errors[0] > 3.5 * errors[1] > 12.0 * errors[2]


def test_inclined_plane() -> None:
    for first in (lattice(2, 2), lattice(8, 8), lattice(4, 9)):
        for second in (lattice(2, 2), lattice(3, 6)):
            m = compare(
                cloud(first, first[:, 0]), cloud(second, 0.5), max_edge=np.inf, domain="data"
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
        cloud(first, first @ [1.0, 2.0]),
        cloud(second, second @ [-1.0, 0.5] + 0.8),
        domain="hull",
        exact=True,
    ).measures
    assert m.exact is not None
    # the nodal reading leaves out triangles that are not inside both hulls as a whole
    assert m.area_compared <= m.exact.area_compared
    inner = compare(
        cloud(np.concatenate((first, lattice(2, 2))), 0.0),
        cloud(np.concatenate((second, lattice(2, 2))), 1.0),
        exact=True,
        max_edge=np.inf,
    ).measures
    assert inner.exact is not None
    assert inner.exact.area_compared == pytest.approx(inner.area_compared, rel=1e-12)
    assert inner.exact.mean_abs == pytest.approx(1.0, rel=1e-12)
