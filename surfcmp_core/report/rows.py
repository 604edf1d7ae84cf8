"""Large tables as text: rows of numbers and a word each, separated by commas."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import orjson
from numpy.typing import NDArray

_AT_ONCE = 1 << 16
"""Rows that are written at once."""


def rows_of(
    reals: Sequence[NDArray[np.float64]],
    integers: Sequence[NDArray[Any]],
    word: NDArray[np.uint8],
    words: Sequence[str],
) -> Iterator[bytes]:
    """Write a table row by row: its reals, its integers, its word.

    Parameters
    ----------
    reals : sequence of (n,) float64
        One or more; in their shortest decimals that are read as the same; nothing for NaN.
    integers : sequence of (n,) integers
        One or more.
    word : (n,) uint8
        Number of the row's word.
    words : sequence of str
        Without commas, quotes and line feeds.

    Yields
    ------
    bytes
        Some of the rows in UTF-8, each of which ends in a line feed.
    """
    last = [one.encode() + b"\n" for one in words]
    for first in range(0, len(word), _AT_ONCE):
        part = slice(first, first + _AT_ONCE)
        numbers = _lines([column[part] for column in reals])
        wholes = _lines([column[part].astype(np.int64) for column in integers])
        ends = [last[number] for number in word[part].tolist()]
        yield b"".join(map(b"%b,%b,%b".__mod__, zip(numbers, wholes, ends, strict=True)))


def _lines(columns: Sequence[NDArray[Any]]) -> list[bytes]:
    """Write the rows of a table of numbers of one kind."""
    text = orjson.dumps(np.column_stack(columns), option=orjson.OPT_SERIALIZE_NUMPY)
    return text[2:-2].replace(b"null", b"").split(b"],[")
