"""T of sets that broke other programs, moved as data is met: right, or refused with the reason."""

from collections import Counter
from pathlib import Path

import numpy as np
import pytest

from tests.core.moved_sets import FEW, FLAT, MOTIONS, NO_AREA, moved, others, outcome
from tests.core.node_sets import node_sets
from tests.pairs import FAMILIES, Nodes, distinct, pair_of

FIXTURES: dict[str, tuple[str, ...]] = {
    # ok, fewer than three distinct nodes, all on one line, no area in numbers; a motion each
    "CDT": ("93 1 0 0",) * 6,
    "delaunator": ("16 0 0 0",) * 6,
    "delaunator-cpp": ("4 0 0 0",) * 6,
    "earcut": ("117 1 0 0",) * 6,
    "geos": ("49 2 3 0", "49 2 3 0", "47 3 4 0", "52 2 0 0", "51 2 1 0", "49 2 3 0"),
    "jts": ("79 1 0 0", "79 1 0 0", "77 2 1 0", "79 1 0 0", "79 1 0 0", "79 1 0 0"),
    "manifold": ("205 4 3 0", "201 7 4 0", "200 8 4 0", "207 5 0 0", "205 4 3 0", "205 4 3 0"),
    "pcl": ("8 0 0 0",) * 6,
    "robust-predicates": ("8 0 0 0",) * 6,
    "spade": ("100 2 10 0", "85 15 12 0", "85 17 10 0", "98 4 10 0", "100 2 10 0", "100 2 10 0"),
    "startin": ("6 0 2 0", "6 0 2 0", "6 0 2 0", "7 0 0 1", "6 0 2 0", "6 0 2 0"),
}
"""Folder of fixtures to the outcomes under each of the motions; coordinates far away fall together
and on lines, turned ones off them."""


def outcomes(sets: dict[str, Nodes], motion: str) -> str:
    """Count the outcomes of sets against a half and a shifted copy of themselves."""
    found: Counter[str] = Counter()
    for name, nodes in sets.items():
        first = moved(nodes, motion)
        for second in others(first):
            try:
                found[outcome(first, second)] += 1
            except Exception as error:
                error.add_note(f"{name}, {motion}")
                raise
    return " ".join(str(found[word]) for word in ("ok", FEW, FLAT, NO_AREA))


@pytest.mark.parametrize("folder", FIXTURES)
def test_sets_of_others(folder: str, shared: Path) -> None:
    path = shared / "fixtures" / folder
    if not path.is_dir():
        pytest.skip(f"{path.parent}: no fixtures of others here")
    sets = {name: nodes for name, nodes in node_sets(path).items() if len(distinct(nodes)) >= 3}
    found = {motion: outcomes(sets, motion) for motion in MOTIONS}
    assert found == dict(zip(MOTIONS, FIXTURES[folder], strict=True))


def test_no_folder_is_missing(shared: Path) -> None:
    others_programs = {path.name for path in (shared / "fixtures").iterdir() if path.is_dir()}
    assert others_programs - {"attack", "malformed", "reports"} == set(FIXTURES)


def _lines(rng: np.random.Generator) -> Nodes:
    """Nodes on one line."""
    return np.outer(rng.permutation(40), [3.0, -2.0])


def _needle(rng: np.random.Generator) -> Nodes:
    """Nodes a last bit off one line."""
    nodes = _lines(rng) + 100.0
    nodes[::3] = np.nextafter(nodes[::3], np.inf)
    return nodes


def _polygons(rng: np.random.Generator) -> Nodes:
    """Rings one in the other, closed by their first node as outlines are: repetitions."""
    turns = np.linspace(0.0, 2.0 * np.pi, 33)
    rings = [np.column_stack((np.cos(turns), np.sin(turns))) * r for r in (1.0, 3.0, 3.5, 40.0)]
    return np.concatenate([*rings, rings[1]])


def _map(rng: np.random.Generator) -> Nodes:
    """Places in metres on a map, to the centimetre, in clusters."""
    centres = rng.integers(0, 40_000, (8, 2))[rng.integers(0, 8, 400)]
    places = centres + np.round(rng.normal(size=(400, 2)) * 30.0, 2)
    return places + np.array([2_600_000.0, 1_200_000.0])


def _all_magnitudes(rng: np.random.Generator) -> Nodes:
    return rng.choice([-1.0, 1.0], (300, 2)) * 10.0 ** rng.uniform(-5, 30, (300, 2))


def _few(rng: np.random.Generator) -> Nodes:
    corners = np.array([[0.0, 0.0], [0.0, 7.0], [7.0, 0.0], [0.0, 0.0]])
    return corners + rng.integers(0, 3, (4, 2))


KINDS = (_lines, _needle, _polygons, _map, _all_magnitudes, _few)
OWN = {
    "as is": "104 0 4 0",
    "+1e6": "96 6 6 0",
    "+1e8": "96 6 6 0",
    "turned": "108 0 0 0",
    "*1e-12": "106 0 2 0",
    "*1e12": "104 0 4 0",
}
"""The outcomes of sets of our own making."""


@pytest.mark.parametrize("motion", MOTIONS)
def test_sets_of_our_own(motion: str) -> None:
    sets = {kind.__name__: kind(np.random.default_rng(7)) for kind in KINDS}
    for family in FAMILIES:
        for seed in (1, 2):
            sets[f"{family} {seed}"] = pair_of(family, seed, most=150).first
    assert outcomes(sets, motion) == OWN[motion]
