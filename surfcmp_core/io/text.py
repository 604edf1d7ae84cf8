"""Text as readers need it: decoded lines, and tables of numbers in them."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from surfcmp_core.errors import InputError


def decode(data: bytes) -> str:
    r"""Text of a file with or without a byte-order mark, its lines ended by ``\n``.

    What is not UTF-8 is read as Windows-1252, a superset of Latin-1: µ is the same letter there and
    in most other code pages, and no letter is lost.
    """
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        text = data.decode("utf-16", "replace")
    elif b"\0" in data[:4] and data[:1].isascii():
        text = data.decode("utf-16-le" if data[1:2] == b"\0" else "utf-16-be", "replace")
    else:
        try:
            text = data.decode("utf-8-sig")
        except UnicodeDecodeError:
            text = data.decode("cp1252", "replace")
    return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text


def filled_lines(text: str) -> list[str]:
    """Lines that are neither blank nor, as a whole, a comment after ``#``."""
    return [
        line
        for line in text.split("\n")
        # most lines begin with a digit or a sign, which stand after "#": the short way
        if line and (line[0] > "#" or ((start := line.lstrip()) and start[0] != "#"))
    ]


def table[T: np.generic](rows: Sequence[str], columns: Sequence[int], dtype: type[T]) -> NDArray[T]:
    """Numbers in the given columns of rows separated by white space.

    Parameters
    ----------
    rows : sequence of str
        None of them blank.
    columns : sequence of int
        Which columns, counted from 0; there may be more.
    dtype : type
        `numpy.float64`, rounded as exactly as Python does, or `numpy.int64`.

    Returns
    -------
    (n, len(columns)) array of `dtype`

    Raises
    ------
    InputError
        Where a row is shorter or holds something else; it quotes the row.
    """
    if not rows or not columns:
        return np.empty((len(rows), len(columns)), dtype)
    kind = "whole numbers" if dtype is np.int64 else "numbers"
    return load(rows, dtype, f"{len(columns)} {kind} expected", usecols=columns, ndmin=2)


def load(rows: Sequence[str], dtype: DTypeLike, expected: str, **options: Any) -> NDArray[Any]:
    """`numpy.loadtxt`, with an error that quotes the first row it cannot read."""

    def attempt(first: int, last: int) -> NDArray[Any]:
        return np.loadtxt(rows[first:last], dtype, comments=None, **options)

    first, last = 0, len(rows)
    try:
        return attempt(first, last)
    except ValueError:
        while last - first > 1:  # the first bad row is in rows[first:last]
            middle = (first + last) // 2
            try:
                attempt(first, middle)
                first = middle
            except ValueError:
                last = middle
    raise InputError(expected, row=rows[first])
