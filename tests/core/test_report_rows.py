"""Numbers as text are read as the same to the last bit."""

import math
from itertools import pairwise

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core.report.rows import rows_of

DOUBLES = st.floats(allow_nan=False, allow_infinity=False)
INTEGERS = st.integers(-(2**63), 2**63 - 1)


def written(values: NDArray[np.float64]) -> list[str]:
    """Give each value as rows have it."""
    none = np.zeros(len(values), np.uint8)
    text = b"".join(rows_of([values], [none], none, [""])).decode()
    return [row.removesuffix(",0,") for row in text.splitlines()]


def same(values: NDArray[np.float64]) -> bool:
    read = np.array([float(text) for text in written(values)])
    return np.array_equal(read.view(np.int64), values.view(np.int64))


@given(st.lists(DOUBLES, min_size=1, max_size=50))
def test_any_double(values: list[float]) -> None:
    assert same(np.array(values))


def test_doubles_of_all_magnitudes() -> None:
    bits = np.random.default_rng(1).integers(0, 2**64, 200_000, np.uint64).view(np.float64)
    assert same(bits[np.isfinite(bits)])


@given(st.lists(st.tuples(DOUBLES, DOUBLES, INTEGERS, st.integers(0, 2)), min_size=1, max_size=9))
def test_rows(rows: list[tuple[float, float, int, int]]) -> None:
    words = ["yes", "", "größer"]
    x, y, whole, word = (np.array(column) for column in zip(*rows, strict=True))
    y[::2] = math.nan
    text = b"".join(rows_of([x, y], [whole], word.astype(np.uint8), words)).decode()
    assert text.endswith("\n")
    found = [row.split(",") for row in text.splitlines()]
    assert len(found) == len(rows)
    for (one, two, number, end), one_x, one_y, row in zip(found, x, y, rows, strict=True):
        assert float(one) == one_x
        assert two == "" if math.isnan(one_y) else float(two) == one_y
        assert int(number) == row[2]
        assert end == words[row[3]]


def test_many_rows_come_in_parts() -> None:
    count = 200_000
    values = np.arange(count) / 8.0
    none = np.zeros(count, np.uint8)
    parts = [len(bytes(part).splitlines()) for part in rows_of([values], [none], none, ["x"])]
    assert sum(parts) == count
    assert all(one >= two for one, two in pairwise(parts))
    assert len(parts) > 1
    assert same(values)
