"""Nodes on which predicates in plain floating point go wrong."""

import os
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

Cases = NDArray[np.float64]
"""One case a row: x and y of each node in turn."""

COMPILED = os.environ.get("NUMBA_DISABLE_JIT", "0") == "0"
SIZE = 1000 if COMPILED else 25
"""Cases a block."""

SCALES = (1.0, 2.0**-60, 2.0**60, 2.0**-180, 2.0**190, 1e50, 1e-50)


def _ulps(rng: np.random.Generator, cases: Cases) -> Cases:
    """Push coordinates a few last bits off, in two rows of three."""
    steps = rng.integers(-2, 3, cases.shape) * rng.integers(0, 3, (len(cases), 1)).clip(0, 1)
    last_bit = np.where(cases == 0.0, 2.0**-60, np.spacing(cases))
    return np.asarray(cases + steps * last_bit)


def _lattice(rng: np.random.Generator, nodes: int) -> Cases:
    return rng.integers(-6, 7, (SIZE, 2 * nodes)).astype(np.float64)


def _on_a_line(rng: np.random.Generator, nodes: int) -> Cases:
    origin, direction = rng.random((2, SIZE, 1, 2))
    steps = rng.integers(-20, 21, (SIZE, nodes, 1)) / 7.0
    return np.asarray(origin + steps * direction).reshape(SIZE, -1)


def _on_a_circle(rng: np.random.Generator, nodes: int) -> Cases:
    angle = rng.random((SIZE, nodes, 1)) * 7.0
    ring = np.concatenate((np.cos(angle), np.sin(angle)), axis=2) * rng.random((SIZE, 1, 1))
    return np.asarray(ring + rng.random((SIZE, 1, 2))).reshape(SIZE, -1)


def _on_whole_circles(rng: np.random.Generator, nodes: int) -> Cases:
    x, y = np.meshgrid(np.arange(-33, 34), np.arange(-33, 34))
    on = x * x + y * y == rng.choice([25, 65, 325, 1105])
    circle = np.column_stack((x[on], y[on])).astype(np.float64)
    places = circle[rng.integers(0, len(circle), (SIZE, nodes))]
    return np.asarray(places + rng.integers(-9, 10, (SIZE, 1, 2))).reshape(SIZE, -1)


def _far_away(rng: np.random.Generator, nodes: int) -> Cases:
    offset = rng.choice([1e6, 5e5, 1e9, -1e12, 2.0**40], (SIZE, 1))
    return np.asarray(offset + rng.integers(0, 8, (SIZE, 2 * nodes)) * rng.choice([0.1, 0.5, 1.0]))


def _all_magnitudes(rng: np.random.Generator, nodes: int) -> Cases:
    powers = rng.integers(-30, 30, (SIZE, 2 * nodes))
    digits = rng.choice([1.0, 1.0 + 2.0**-52, 1.5, 2.0 - 2.0**-52], powers.shape)
    signs = rng.choice([-1.0, 1.0], powers.shape)
    return np.asarray(np.ldexp(signs * digits, powers))


def _nearly_parallel(rng: np.random.Generator, nodes: int) -> Cases:
    """Whole numbers of up to 53 bits, whose cross products are -1, 0 or 1."""
    fibonacci = [0.0, 1.0]
    while fibonacci[-1] < 2.0**52:
        fibonacci.append(fibonacci[-1] + fibonacci[-2])
    first = rng.integers(0, len(fibonacci) - 4, (SIZE, 1)) + rng.integers(0, 3, (SIZE, nodes))
    places = np.array(fibonacci)[first[..., None] + np.arange(2)]
    places[rng.random((SIZE, nodes)) < 1.0 / nodes] = 0.0
    return places.reshape(SIZE, -1)


_KINDS = (
    _nearly_parallel,
    _lattice,
    _on_a_line,
    _on_a_circle,
    _on_whole_circles,
    _far_away,
    _all_magnitudes,
)


def blocks(nodes: int, seed: int) -> Iterator[Cases]:
    """Blocks of cases of so many nodes, in every kind and scale, rounded and not."""
    rng = np.random.default_rng(seed)
    for scale in SCALES:
        for kind in _KINDS:
            yield _ulps(rng, kind(rng, nodes)) * scale


def whole_range(nodes: int, seed: int) -> Cases:
    """Coordinates from the largest to the smallest power of two that are declared exact."""
    rng = np.random.default_rng(seed)
    powers = rng.choice([-187, -186, -100, 0, 100, 248, 249], (SIZE, 2 * nodes))
    digits = rng.choice([1.0, 1.0 + 2.0**-52, 2.0 - 2.0**-52, -1.5, -1.0, 0.0], powers.shape)
    return np.asarray(np.ldexp(digits, powers))
