"""Cases to measure: a united triangulation, made directly."""

import dataclasses
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from surfcmp_core.measures import (
    Covered,
    Measures,
    TriangleValues,
    measure,
)

Floats = NDArray[np.float64]
Function = Callable[[Floats, Floats], Floats]


@dataclasses.dataclass
class Case:
    nodes: Floats
    label: NDArray[np.uint8]
    triangles: NDArray[np.int32]
    z1: Floats
    z2: Floats
    compared: NDArray[np.bool_]
    node_weight: Floats | None = None
    triangle_weight: Floats | None = None

    def measure(self, **changed: Any) -> tuple[TriangleValues, Measures]:
        given: dict[str, Any] = {f.name: getattr(self, f.name) for f in dataclasses.fields(self)}
        further = {
            "tolerances": (0.0, 0.125, 0.5, 1.0),
            "footprint_1": Covered(1.0),
            "footprint_2": Covered(4.0),
            "hausdorff": (0.0, 0.0),
        }
        return measure(**(given | further | changed))


def lattice(
    side: int, low: float, high: float, turned: int = 0
) -> tuple[Floats, NDArray[np.int32]]:
    """Nodes and triangles of a square; each cell's diagonal is drawn (0: all one way)."""
    x, y = np.meshgrid(np.linspace(low, high, side), np.linspace(low, high, side))
    number = np.arange(side * side).reshape(side, side)
    a, b = number[:-1, :-1].ravel(), number[:-1, 1:].ravel()
    c, d = number[1:, 1:].ravel(), number[1:, :-1].ravel()
    other = np.random.default_rng(turned).integers(0, 2, len(a)) * (turned > 0) == 1
    first = np.where(other[:, None], np.column_stack([a, b, d]), np.column_stack([a, b, c]))
    second = np.where(other[:, None], np.column_stack([b, c, d]), np.column_stack([a, c, d]))
    triangles = np.concatenate([first, second]).astype(np.int32)
    return np.column_stack([x.ravel(), y.ravel()]), triangles


def over_lattice(side: int, low: float, high: float, f: Function, turned: int = 0) -> Measures:
    nodes, triangles = lattice(side, low, high, turned)
    z = f(nodes[:, 0], nodes[:, 1])
    label = np.full(len(nodes), 3, np.uint8)
    compared = np.ones(len(triangles), bool)
    return Case(nodes, label, triangles, z, np.zeros(len(z)), compared).measure()[1]


def random_case(seed: int = 0, side: int = 12) -> Case:
    """A jittered lattice with noisy surfaces, all labels, a few triangles left out."""
    rng = np.random.default_rng(seed)
    nodes, triangles = lattice(side, 0.0, 3.0, turned=seed + 1)
    nodes += rng.uniform(-0.4, 0.4, nodes.shape) / side
    z1, z2 = rng.normal(0.0, 0.5, (2, len(nodes)))
    z2[rng.random(len(z2)) < 0.2] = 0.0
    z1[z2 == 0.0] = 0.0
    label = rng.integers(1, 4, len(nodes)).astype(np.uint8)
    compared = rng.random(len(triangles)) < 0.8
    return Case(nodes, label, triangles, z1, z2, compared, rng.random(len(nodes)))


def near(value: Any, rel: float) -> Any:
    return pytest.approx(value, rel=rel, abs=0.0)


def numbers(measures: Measures) -> dict[str, float]:
    flat = dataclasses.asdict(measures)
    del flat["exact"]
    return flat | {f"within {k}": v for k, v in flat.pop("within_tolerance").items()}


def representative(case: Case) -> NDArray[np.bool_]:
    return np.asarray(np.bitwise_or.reduce(case.label[case.triangles], axis=1) == 3)
