"""Large tables as text: rows of numbers and a word each, separated by commas."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import kernel
from surfcmp_core.report.decimals import ROOM, put_integer, put_real

_AT_ONCE = 1 << 16
"""Rows that are written at once."""
_COMMA, _LINE_FEED = b",\n"


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
        One or more; in their shortest decimals, as `repr` has them; nothing for NaN.
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
    letters = np.frombuffer("".join(words).encode(), np.uint8)
    ends = np.cumsum([len(one.encode()) for one in words])
    longest = ROOM * (len(reals) + len(integers)) + max(len(one.encode()) for one in words) + 1
    text = np.empty(min(len(word), _AT_ONCE) * longest, np.uint8)
    for first in range(0, len(word), _AT_ONCE):
        part = slice(first, first + _AT_ONCE)
        columns = np.column_stack([column[part] for column in reals]).view(np.uint64)
        wholes = np.column_stack([column[part].astype(np.int64) for column in integers])
        yield text[: _put_rows(columns, wholes, word[part], letters, ends, text)].tobytes()


@kernel
def _put_rows(
    reals: NDArray[np.uint64],
    integers: NDArray[np.int64],
    word: NDArray[np.uint8],
    letters: NDArray[np.uint8],
    ends: NDArray[np.int64],
    text: NDArray[np.uint8],
) -> int:
    """Write rows to text[0:]; reals come as bits, word w is ``letters[ends[w - 1]:ends[w]]``."""
    no_number = np.uint64(0x7FF0000000000000)
    at = 0
    for row in range(len(word)):
        for column in range(reals.shape[1]):
            bits = reals[row, column]
            if bits & no_number != no_number:
                at = put_real(bits, text, at)
            text[at] = _COMMA
            at += 1
        for column in range(integers.shape[1]):
            at = put_integer(integers[row, column], text, at)
            text[at] = _COMMA
            at += 1
        w = word[row]
        begin = ends[w - 1] if w > 0 else 0
        for k in range(begin, ends[w]):
            text[at] = letters[k]
            at += 1
        text[at] = _LINE_FEED
        at += 1
    return at
