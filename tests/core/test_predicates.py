"""Predicates against whole numbers of any size: their signs are always right."""

import os
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from itertools import permutations
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from surfcmp_core.predicates import (
    compare_lengths,
    compare_tangent_circles,
    in_circle,
    in_disc,
    orientation,
    scalar_product,
    twice_area,
)
from tests.core import oracles
from tests.core.predicate_cases import COMPILED, Cases, blocks, whole_range

pytestmark = pytest.mark.plain

PREDICATES: dict[str, tuple[Callable[..., float], Callable[..., Any], int]] = {
    "orientation": (orientation, oracles.orientation, 3),
    "in_circle": (in_circle, oracles.in_circle, 4),
    "compare_lengths": (compare_lengths, oracles.compare_lengths, 4),
    "compare_tangent_circles": (compare_tangent_circles, oracles.compare_tangent_circles, 4),
    "scalar_product": (scalar_product, oracles.scalar_product, 4),
    "twice_area": (twice_area, oracles.orientation, 3),
}

Four = list[oracles.Place]
whole = st.integers(-8, 8)
place = st.tuples(whole, whole)


def _check_signs(name: str, cases: Cases) -> int:
    """Compare all signs of a block; return how many cases are ties."""
    predicate, oracle, _ = PREDICATES[name]
    found = np.sign([predicate(*case) for case in cases.tolist()])
    expected = oracles.sign(oracle(*oracles.exact(cases.T)))
    wrong = np.flatnonzero(found != expected)
    assert wrong.size == 0, f"{name}{tuple(cases[wrong[0]].tolist())} is not {expected[wrong[0]]}"
    return int((expected == 0).sum())


@pytest.mark.parametrize("name", PREDICATES)
def test_signs_are_exact(name: str) -> None:
    # 49 000 cases each where compiled
    ties = sum(_check_signs(name, cases) for cases in blocks(PREDICATES[name][2], seed=1))
    assert ties > 0


@pytest.mark.parametrize("name", PREDICATES)
def test_signs_are_exact_over_the_whole_range(name: str) -> None:
    _check_signs(name, whole_range(PREDICATES[name][2], seed=2))


def _check_values(name: str, cases: Cases) -> None:
    predicate, oracle, _ = PREDICATES[name]
    for case in cases.tolist():
        found = Fraction(predicate(*case))
        expected = oracle(*map(Fraction, case))
        assert abs(found - expected) <= abs(expected) / 2**47, f"{name}{tuple(case)}"


@pytest.mark.parametrize("name", ["twice_area", "scalar_product"])
def test_values_are_right_but_for_their_last_bits(name: str) -> None:
    for cases in blocks(PREDICATES[name][2], seed=6):
        _check_values(name, cases[: len(cases) // 4])
    _check_values(name, whole_range(PREDICATES[name][2], seed=7))


@pytest.mark.parametrize(("file", "name"), [("orient2d", "orientation"), ("incircle", "in_circle")])
def test_signs_others_have_found(file: str, name: str, shared: Path) -> None:
    path = shared / "fixtures" / "robust-predicates" / f"{file}.txt"
    if not path.is_file():
        pytest.skip(f"{path} is absent")
    rows = np.loadtxt(path)
    predicate = PREDICATES[name][0]
    found = [np.sign(predicate(*row[1:-1].tolist())) for row in rows]
    assert len(rows) == 1000
    assert np.array_equal(found, rows[:, -1])


def test_smaller_of_two_circles_by_their_radii() -> None:
    rng = np.random.default_rng(3)
    asked = 0
    for case in rng.integers(-5, 6, (4000, 8)).tolist():
        vx, vy, ux, uy, *rest = case
        wx, wy = ux - vx, uy - vy
        squares = [(x - vx) ** 2 + (y - vy) ** 2 for x, y in (rest[:2], rest[2:])]
        along = [(x - vx) * wx + (y - vy) * wy for x, y in (rest[:2], rest[2:])]
        if min(along) <= 0:
            continue
        a, b = (Fraction(s, 2 * t) for s, t in zip(squares, along, strict=True))
        assert np.sign(compare_tangent_circles(*map(float, case))) == oracles.sign(a - b)
        asked += 1
    assert asked > 500


def _turned_left(four: Four) -> Four:
    """Make the first three counter-clockwise; four different places."""
    a, b, c, p = four
    side = oracles.orientation(*a, *b, *c)
    assume(side != 0 and p not in (a, b, c))
    return [a, b, c, p] if side > 0 else [a, c, b, p]


def _asked(four: Four, shift: tuple[int, int] = (0, 0), scale: float = 1.0) -> bool:
    return in_disc(*((v + shift[k % 2]) * scale for k, v in enumerate(sum(four, ()))))


def test_disc_of_a_triangle_with_ties_broken() -> None:
    rng = np.random.default_rng(4)
    ties = 0
    for cases in blocks(4, seed=5):
        part = cases[: len(cases) // 2]
        numbers = oracles.exact(part).tolist()
        for case, (ax, ay, bx, by, cx, cy, px, py) in zip(part.tolist(), numbers, strict=True):
            side = oracles.orientation(ax, ay, bx, by, cx, cy)
            if side == 0 or (px, py) in ((ax, ay), (bx, by), (cx, cy)):
                continue
            a, b, c = (ax, ay), (bx, by), (cx, cy)
            if side < 0:
                b, c = c, b
                case[2:6] = [*case[4:6], *case[2:4]]
            ties += oracles.in_circle(*a, *b, *c, px, py) == 0
            assert in_disc(*case) == oracles.in_disc(a, b, c, (px, py)), case
    assert ties > 3
    # whole-numbered squares and rectangles, where all is ties
    for _ in range(2000 if COMPILED else 100):
        (x, y), (w, h), (u, v) = rng.integers(-4, 5, (3, 2)).tolist()
        corners = [(x, y), (x + w, y + h), (x + w + u, y + h + v), (x + u, y + v)]
        if len(set(corners)) < 4 or w * u + h * v != 0:
            continue
        four = [corners[k] for k in rng.permutation(4)]
        if oracles.orientation(*four[0], *four[1], *four[2]) < 0:
            four[1], four[2] = four[2], four[1]
        assert _asked(four) == oracles.in_disc(*four)


@given(st.lists(place, min_size=4, max_size=4), place, st.integers(-40, 40))
def test_disc_does_not_depend_on_how_it_is_asked(
    four: Four, shift: tuple[int, int], power: int
) -> None:
    a, b, c, p = _turned_left(four)
    inside = oracles.in_disc(a, b, c, p)
    assert _asked([a, b, c, p]) == _asked([b, c, a, p]) == _asked([c, a, b, p]) == inside
    assert _asked([a, b, c, p], shift) == inside
    assert _asked([a, b, c, p], shift, 2.0**power) == inside


@given(st.lists(place, min_size=4, max_size=4))
def test_one_diagonal_of_a_convex_quadrangle_is_right(four: Four) -> None:
    for a, b, c, d in permutations(four):
        sides = [
            oracles.orientation(*u, *v, *w)
            for u, v, w in ((a, b, c), (b, c, d), (c, d, a), (d, a, b))
        ]
        if min(sides) > 0:
            across = _asked([a, b, c, d])
            assert across == _asked([c, d, a, b])
            assert across != _asked([b, c, d, a])
            assert across != _asked([d, a, b, c])


@pytest.mark.skipif(not COMPILED, reason="this is the interpreted run")
def test_signs_are_exact_interpreted() -> None:
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", __file__]
    done = subprocess.run(
        [*command, "-k", "exact or ties or radii"],
        env=os.environ | {"NUMBA_DISABLE_JIT": "1"},
        cwd=Path(__file__).parents[2],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert "14 passed" in done.stdout
