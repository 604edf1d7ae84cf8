"""How the numbers of a table are written: decimal marks, and marks between thousands."""

import re
from collections.abc import Callable, Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError

_BLANKS = "\u00a0\u2007\u2009\u202f"
"""Blanks that no line is broken at; between digits they part thousands, never columns."""
_ALIKE = str.maketrans(dict.fromkeys(_BLANKS, " ") | {"\u2019": "'"})
_THREE = re.compile(r"[+-]?[1-9]\d{0,2}[.,]\d{3}")
_SOME = 1000
_END = r"(?:[eE][+-]?\d+)?|[+-]?(?:nan|inf(?:inity)?)"


def _pattern(between: str, decimal: str) -> re.Pattern[str]:
    point = re.escape(decimal)
    whole = rf"\d+(?:{point}\d*)?|{point}\d+"
    if between:
        whole += rf"|\d{{1,3}}(?:{re.escape(between)}\d{{3}})+(?:{point}\d*)?"
    return re.compile(rf"[+-]?(?:{whole}){_END}", re.IGNORECASE)


_NOTATIONS = {
    (between, decimal): _pattern(between, decimal)
    for decimal, between in product(".,", ("", ".", ",", "'", " "))
    if between != decimal
}
"""What may stand between thousands, and ahead of decimals."""


def is_number(field: str) -> bool:
    """Tell whether a field holds a number in any notation."""
    field = field.translate(_ALIKE)
    return any(pattern.fullmatch(field) for pattern in _NOTATIONS.values())


def is_odd(text: str) -> bool:
    """Tell whether a text holds marks that only ever part thousands."""
    return "'" in text or (not text.isascii() and any(mark in text for mark in _BLANKS + "\u2019"))


def numbers_in(
    columns: Sequence[Sequence[str]], rows: Sequence[str], expected: str
) -> NDArray[np.float64]:
    """Read columns of numbers, all in one notation.

    Parameters
    ----------
    columns : sequence of sequence of str
        Fields of each column, without blanks around.
    rows : sequence of str
        The rows they stand in, for messages.
    expected : str
        How a message about a field that is no number begins.

    Returns
    -------
    (n, c) float64

    Raises
    ------
    InputError
        No one notation fits every field, or two do that mean different numbers.
    """
    first: dict[str, int] = {}
    for row, fields in enumerate(zip(*columns, strict=True)):
        for field in fields:
            first.setdefault(field, row)
    texts = {field: field.translate(_ALIKE) for field in first}
    fitting, farthest = [], next(iter(first), "")
    for notation, pattern in _NOTATIONS.items():
        wrong = next((one for one, text in texts.items() if not pattern.fullmatch(text)), None)
        if wrong is None:
            fitting.append(notation)
        elif first[wrong] >= first[farthest]:
            farthest = wrong
    if not fitting:
        if is_number(farthest):
            expected = f"{farthest!r} is written in another way than the numbers before it"
        raise InputError(expected, row=rows[first[farthest]])

    without = [notation for notation in fitting if not notation[0]]
    chosen, *others = without[:1] or fitting
    values = {field: _value(text, *chosen) for field, text in texts.items()}
    for other, (field, text) in product(others, texts.items()):
        if _value(text, *other) != values[field]:
            raise _undecided(field, rows[first[field]])
    points = np.array([[values[field] for field in column] for column in columns]).T
    if without:
        refuse_thousands(points, lambda row, column: columns[column][row], rows, chosen[1])
    return points


def refuse_thousands(
    points: NDArray[np.float64],
    field: Callable[[int, int], str],
    rows: Sequence[str],
    decimal: str,
) -> None:
    """Refuse a column in which 999 is followed by 1.000, which may be one or a thousand.

    Parameters
    ----------
    points : (n, c) float64
        As read with `decimal` ahead of decimals, and nothing between thousands.
    field : callable
        Gives the text at a row and a column.
    rows : sequence of str
        The rows, for messages.
    decimal : str

    Raises
    ------
    InputError
        Some numbers of a column have no decimals, and all others exactly three and no 0 ahead: no
        program that writes decimals writes them so.
    """
    for column in range(points.shape[1]):
        values = np.abs(points[:, column])
        if not (_may_be_thousands(values[:_SOME]) and _may_be_thousands(values)):
            continue
        whole = values == np.rint(values)
        inside = np.flatnonzero(whole & (values > 0)).tolist()
        if not any(decimal not in field(row, column) for row in inside):
            continue
        suspect = None
        for row in sorted((*np.flatnonzero(~whole).tolist(), *inside)):
            text = field(row, column)
            if decimal in text:
                if not _THREE.fullmatch(text):
                    suspect = None
                    break
                suspect = row if suspect is None else suspect
        if suspect is not None:
            raise _undecided(field(suspect, column), rows[suspect])


def _may_be_thousands(values: NDArray[np.float64]) -> bool:
    """Tell whether all are 0, or from 1 to 999.999 with three decimals at most."""
    with np.errstate(all="ignore"):
        thousandths = values * 1000.0
        near = np.abs(thousandths - np.rint(thousandths)) < 1e-6
    return bool(((values == 0) | (near & (values >= 1.0) & (values < 1000.0))).all())


def _value(text: str, between: str, decimal: str) -> float:
    return float((text.replace(between, "") if between else text).replace(decimal, "."))


def _undecided(field: str, row: str) -> InputError:
    return InputError(f"{field!r} may be thousands or decimals", row=row)
