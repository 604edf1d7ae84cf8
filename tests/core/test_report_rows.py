"""Numbers as text are Python's own, to the letter."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core.report.decimals import ROOM
from surfcmp_core.report.rows import rows_of

DOUBLES = st.floats(allow_nan=False, allow_infinity=False)
INTEGERS = st.integers(-(2**63), 2**63 - 1)


def written(values: NDArray[np.float64]) -> list[str]:
    """Give each value as rows have it."""
    none = np.zeros(len(values), np.uint8)
    text = b"".join(rows_of([values], [none], none, [""])).decode()
    return [row.removesuffix(",0,") for row in text.splitlines()]


def expected(values: NDArray[np.float64]) -> list[str]:
    return [repr(value) for value in values.tolist()]


@given(st.lists(DOUBLES, min_size=1, max_size=50))
def test_any_double(values: list[float]) -> None:
    array = np.array(values)
    assert written(array) == expected(array)


def test_doubles_of_all_magnitudes() -> None:
    bits = np.random.default_rng(1).integers(0, 2**64, 200_000, np.uint64).view(np.float64)
    array = bits[np.isfinite(bits)]
    assert written(array) == expected(array)


@pytest.mark.parametrize("digits", range(1, 18))
def test_decimals_of_few_digits(digits: int) -> None:
    rng = np.random.default_rng(digits)
    numbers = rng.integers(10 ** (digits - 1), 10**digits, 3000)
    powers = rng.integers(-320, 308 - digits, 3000)
    array = np.array([float(f"{n}e{p}") for n, p in zip(numbers, powers, strict=True)])
    array = np.concatenate((array, numbers.astype(np.float64), numbers / 1000.0))
    assert written(array) == expected(array)


@pytest.mark.parametrize("base", [2, 10])
def test_powers_and_their_neighbours(base: int) -> None:
    powers = [float(base) ** k for k in range(-1100, 1100) if base**k < 2**1024]
    array = np.array([power for power in powers if power < math.inf])
    near = [np.nextafter(array, limit) for limit in (0.0, math.inf)]
    array = np.concatenate((array, *near, -array))
    array = array[np.isfinite(array)]
    assert written(array) == expected(array)
    assert max(map(len, written(array))) < ROOM


@given(st.lists(st.tuples(DOUBLES, DOUBLES, INTEGERS, st.integers(0, 2)), min_size=1, max_size=9))
def test_rows(rows: list[tuple[float, float, int, int]]) -> None:
    words = ["yes", "", "größer"]
    x, y, whole, word = (np.array(column) for column in zip(*rows, strict=True))
    y[::2] = math.nan
    text = b"".join(rows_of([x, y], [whole], word.astype(np.uint8), words)).decode()
    assert text == "".join(
        f"{one!r},{'' if math.isnan(two) else repr(two)},{number},{words[which]}\n"
        for one, two, number, which in zip(
            x.tolist(), y.tolist(), whole.tolist(), word.tolist(), strict=True
        )
    )


def test_many_rows_come_in_parts() -> None:
    count = 200_000
    values = np.arange(count) / 8.0
    none = np.zeros(count, np.uint8)
    parts = [len(bytes(part).splitlines()) for part in rows_of([values], [none], none, ["x"])]
    assert sum(parts) == count
    assert all(one >= two for one, two in pairwise(parts))
    assert len(parts) > 1
    assert written(values) == expected(values)
