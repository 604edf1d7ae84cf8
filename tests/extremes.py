"""Surfaces of any finite numbers, and all that is computed with them: ``python -m tests.extremes``.

Kernels trust what they are given, so this runs in a process of its own: whatever the numbers, there
is a finite result or one line that says what is wrong.
"""

import argparse
import sys
import traceback
import warnings
from collections.abc import Callable
from dataclasses import asdict
from typing import Any

import numpy as np

from surfcmp_core import Surface, compare
from surfcmp_core.alignment import best_fit
from surfcmp_core.comparing.cloud_data import data_of_cloud
from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.errors import InputError
from surfcmp_core.grid.thinning import thin_to_spacing
from surfcmp_core.projection.placement import place
from tests.pairs import Nodes


def _cloud(seed: int) -> Nodes:
    return np.random.default_rng(seed).random((50 + 25 * seed, 3)) * [100.0, 100.0, 5.0]


def _with_some(value: float, share: float) -> Nodes:
    points = _cloud(1)
    points[np.random.default_rng(0).random(len(points)) < share, 2] = value
    return points


def _mixed(powers: tuple[int, int], axes: tuple[int, ...]) -> Nodes:
    """All magnitudes from one power of ten to another, either sign."""
    points, rng = _cloud(1), np.random.default_rng(0)
    for axis in axes:
        size = 10.0 ** rng.integers(*powers, len(points)).astype(np.float64)
        points[:, axis] *= size * rng.choice([-1.0, 1.0], len(points))
    return points


def _stretched(factor: float, axes: tuple[int, ...]) -> Nodes:
    points = _cloud(1)
    points[:, axes] *= factor
    return points


def _moved(shift: float, axis: int) -> Nodes:
    points = _cloud(1)
    points[:, axis] += shift
    return points


EXTREMES: dict[str, Nodes] = {
    **{
        f"z {value:g} at {share:g}": _with_some(value, share)
        for value in (1e160, -1.797e308, 1e150, 1e76, -1e74, 3.4028235e38, 5e-324)
        for share in (1.0, 0.1, 0.02)
    },
    **{
        f"times {factor:g} along {axes}": _stretched(factor, axes)
        for factor in (1e306, 1e149, 1e70, 1e-70, 1e-100, 5e-324)
        for axes in ((0, 1), (2,), (0, 1, 2), (1,))
    },
    **{
        f"moved by {shift:g} along {axis}": _moved(shift, axis)
        for shift in (1e9, 1e15, 1e20, -1.7e308)
        for axis in (0, 2)
    },
    "all magnitudes": _mixed((-300, 300), (0, 1, 2)),
    "many magnitudes of x, y": _mixed((-60, 60), (0, 1)),
    "many magnitudes of z": _mixed((-300, 70), (2,)),
    "some magnitudes of x": _mixed((-12, 12), (0,)),
    "z = 0": _stretched(0.0, (2,)),
    "a node far away": np.concatenate((_cloud(1), [[1e70, 1e70, 0.0]])),
    "a node far from cells of nothing": np.concatenate((_cloud(1) * 1e-20, [[1e17, 1e40, 0.0]])),
}


def _mesh(points: Nodes, name: str) -> Surface:
    """Triangles without order, over and across each other."""
    faces = np.arange(3 * (len(points) // 3), dtype=np.int32).reshape(-1, 3)
    return Surface(points, faces, name=name)


def _asked(pair: tuple[Surface, Surface]) -> list[Callable[[], object]]:
    """All that is computed with two surfaces."""
    options: list[dict[str, Any]] = [
        {"exact": True, "verify": True},
        {"domain": "hull", "verify": True},
        {"domain": "plane", "verify": True, "weight": lambda x, y: np.hypot(x / 1e60, y / 1e60)},
    ]
    return [
        *(lambda o=o: compare(*pair, duplicates="mean", **o) for o in options),  # type: ignore[misc]
        lambda: place(*pair, "auto"),
        lambda: place(*pair, (1.0, 2.0, 3.0)),
        lambda: best_fit(*pair),
        lambda: data_of_cloud(pair[0]),
        lambda: thin_to_spacing(pair[0], 3.0),
    ]


def _refuse_infinities(result: Comparison) -> None:
    for measures in (result.measures, result.measures.exact):
        for key, value in asdict(measures).items() if measures else ():
            numbers = value.values() if isinstance(value, dict) else [value]
            is_mean_of_nothing = key == "mean_abs_interface" and not measures.area_interface
            if not (key == "exact" or is_mean_of_nothing or np.isfinite([*numbers]).all()):
                raise AssertionError(f"{key} is not finite: {measures}")


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.extremes", description=__doc__)
    parser.add_argument("--part", type=int, default=0, help="which of them")
    parser.add_argument("--parts", type=int, default=1, help="of how many")
    chosen = parser.parse_args()
    warnings.simplefilter("error")
    done = refused = wrong = 0
    for name in list(EXTREMES)[chosen.part :: chosen.parts]:
        points, other = EXTREMES[name], _cloud(2)
        cloud = Surface(points, name="one")
        said = set()
        for pair in (
            (cloud, Surface(other, name="two")),
            (Surface(other, name="two"), cloud),
            (_mesh(points, "one"), _mesh(other, "two")),
            (cloud, Surface(points[::-1] * 0.75, name="two")),
        ):
            for work in _asked(pair):
                try:
                    found = work()
                    if isinstance(found, Comparison):
                        _refuse_infinities(found)
                    done += 1
                except InputError as fault:
                    refused += 1
                    said.add(str(fault))
                except Exception as fault:  # whatever it is, it is a find
                    wrong += 1
                    last = traceback.extract_tb(fault.__traceback__)[-1]
                    print(f"WRONG {name}: {fault!r} ({last.filename}, line {last.lineno})")
        for line in sorted(said):
            print(f"{name}: {line}", flush=True)
    print(f"{done} done, {refused} refused, {wrong} wrong")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
