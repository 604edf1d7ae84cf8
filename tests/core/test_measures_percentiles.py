"""Area-weighted percentiles against areas expanded to integer multiplicities."""

import math
from fractions import Fraction
from random import Random

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from surfcmp_core.measures.percentiles import area_percentiles

pytestmark = pytest.mark.plain

PERCENTS = (0, 1, 50, 90, 95, 100)

values = st.one_of(
    st.sampled_from([0.0, 5e-324, 0.1, 0.1 + 2.0**-56, 1.0, 1e300]), st.floats(0.0, 1e6)
)


def slow(pairs: list[tuple[float, float]], percent: int) -> float:
    """Add areas in rationals, in the order of the values."""
    total = sum((Fraction(a) for _, a in pairs), Fraction(0))
    below = Fraction(0)
    for value, area in sorted(pairs):
        below += Fraction(area)
        if below > 0 and 100 * below >= percent * total:
            return value
    raise AssertionError


def fast(pairs: list[tuple[float, float]]) -> list[float]:
    v, a = np.array(pairs).T
    return area_percentiles(v, a, PERCENTS)


@given(st.lists(st.tuples(values, st.integers(1, 20)), min_size=1, max_size=60))
@example([(0.0, 1)])
@example([(1.0, 10), (0.0, 9)])
def test_integer_areas_are_multiplicities(pairs: list[tuple[float, int]]) -> None:
    expanded = sorted(v for v, a in pairs for _ in range(a))
    expected = [expanded[max(0, -(-p * len(expanded) // 100) - 1)] for p in PERCENTS]
    assert fast([(v, float(a)) for v, a in pairs]) == expected


@given(
    st.lists(st.tuples(values, st.floats(1e-3, 1e3)), min_size=1, max_size=60),
    st.randoms(use_true_random=False),
)
def test_any_areas_in_any_order(pairs: list[tuple[float, float]], random: Random) -> None:
    expected = [slow(pairs, p) for p in PERCENTS]
    assert fast(pairs) == expected
    random.shuffle(pairs)
    assert fast(pairs) == expected


def test_equal_areas_that_are_no_binary_fractions_tie_exactly() -> None:
    v = np.arange(100.0)
    for area in (0.1, 1e-200, 1e200, 5e-324):
        assert area_percentiles(v, np.full(100, area), (50, 90, 95)) == [49.0, 89.0, 94.0]


def test_many_values_over_many_octaves() -> None:
    rng = np.random.default_rng(1)
    v = np.exp(rng.normal(-3.0, 9.0, 50_000))
    a = rng.uniform(0.1, 2.0, 50_000)
    pairs = list(zip(v.tolist(), a.tolist(), strict=True))
    assert area_percentiles(v, a, (50, 90, 95)) == [slow(pairs, p) for p in (50, 90, 95)]


def test_nothing_has_no_percentile() -> None:
    assert all(math.isnan(v) for v in area_percentiles(np.empty(0), np.empty(0), PERCENTS))
