"""Small surfaces to compare, and comparisons that are to be the same."""

import dataclasses

import numpy as np
from numpy.typing import NDArray

from surfcmp_core import Comparison, Surface
from surfcmp_core.comparing.options import Domain
from surfcmp_core.measures import Measures
from tests.pairs import Nodes

Floats = NDArray[np.float64]
DOMAINS: list[Domain] = ["data", "hull", "plane"]


def cloud(nodes: Nodes, z: Floats | float, name: str = "scan") -> Surface:
    return Surface(np.column_stack((nodes, np.broadcast_to(z, len(nodes)))), name=name)


def lattice(columns: int, rows: int, side: float = 1.0) -> Nodes:
    x, y = np.meshgrid(np.linspace(0.0, side, columns), np.linspace(0.0, side, rows))
    return np.column_stack((x.ravel(), y.ravel()))


def height_at(nodes: Nodes) -> Floats:
    x, y = nodes.T
    return np.asarray(np.sin(3.0 * x) + 0.5 * np.cos(5.0 * y) * x)


def two_surfaces(seed: int, n: int = 400) -> tuple[Surface, Surface]:
    rng = np.random.default_rng(seed)
    first, second = rng.random((n, 2)), rng.random((n // 2, 2))
    return (
        cloud(first, height_at(first), "a"),
        cloud(second, height_at(second) + 0.1 * second[:, 0] - 0.04, "b"),
    )


def numbers_of(measures: Measures) -> dict[str, float]:
    values: dict[str, float] = {}
    for field in dataclasses.fields(measures):
        value = getattr(measures, field.name)
        if isinstance(value, dict):
            values |= {f"within {k}": v for k, v in value.items()}
        elif value is not None and field.name != "exact":
            values[field.name] = value
    return values


def assert_same(a: Comparison, b: Comparison) -> None:
    """Compare all arrays and measures bit for bit."""
    for name in ("nodes", "label", "triangles", "origin", "chain", "chain_closed", "tree1"):
        assert np.array_equal(getattr(a.united, name), getattr(b.united, name)), name
    for name in ("z1", "z2", "reason", "area", "mean_abs", "mean_signed"):
        assert np.array_equal(getattr(a, name), getattr(b, name), equal_nan=name != "reason"), name
    one, other = numbers_of(a.measures), numbers_of(b.measures)
    assert all(np.array_equal(one[k], other[k], equal_nan=True) for k in one | other)
