"""Read .xyz, .txt and .csv: three or more columns of text."""

import re
from collections.abc import Sequence
from contextlib import suppress

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.io.headings import (
    HEIGHTS,
    WEIGHTS,
    Heading,
    are_units,
    axes_among,
    heading_of,
)
from surfcmp_core.io.lead import MOST_COLUMNS, Lead, lead_of, split, splittings
from surfcmp_core.io.notation import is_number, is_odd, numbers_in, refuse_thousands
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.stated_units import unit_in
from surfcmp_core.io.text import decode, filled_lines
from surfcmp_core.names import quoted

_MOST_COMMENTS = 100
_LONGEST_HEADER = 20_000
_SAMPLE = 50
"""Rows that are looked at to tell a number of the point from a coordinate."""
_REST_OF_THOUSANDS = re.compile(r"\d{3}[.,]\d*")
_DECIMALS = re.compile(r"0\d+")
_MARKS = re.compile(r"[;,\t]")
_TITLE = re.compile(r"\s*(?:columns?|fields?|header|format|spalten)\s*[:=]\s*", re.IGNORECASE)


def read_columns(data: bytes, *, weights: bool = False) -> Raw:
    """Nodes of a table separated by white space, commas, semicolons or tabs.

    Its columns are those that its heading names, a row or a comment ahead of the numbers; without
    one, the first three that hold numbers. All numbers are in one notation: with points or commas
    ahead of decimals, with or without marks between thousands. With `weights`, the heading may name
    a weight in the place of z.
    """
    text = decode(data)
    lead = lead_of(text)
    text = text[lead.end :]
    rows = filled_lines(text)
    if lead.declared not in (None, len(rows)):
        raise InputError(f"{lead.declared} rows declared, {len(rows)} found")
    first = split(rows[0], lead.delimiter)
    width = _filled(first)
    if not 3 <= width <= MOST_COLUMNS:
        number = "three columns or more" if width < 3 else f"at most {MOST_COLUMNS} columns"
        raise InputError(f"{number} expected, {width}", row=rows[0])
    heading = _heading(lead, rows, first, WEIGHTS if weights else HEIGHTS)
    sample = [split(row, lead.delimiter) for row in rows[:_SAMPLE]]
    wanted = list(heading.columns) if heading else _unnamed(sample)
    points = _numbers(text, rows, lead.delimiter, len(first), wanted)
    changed = {}
    if len(wanted) == 4:
        if np.array_equal(points[:, 0] - points[0, 0], np.arange(len(points))):
            points = points[:, 1:]
            changed["rows that begin with a number of the point, left out"] = len(points)
        points = points[:, :3]
    comments = tuple(lead.comments)
    unit, stated = heading.unit if heading else None, unit_in(comments)
    if unit and stated and unit != stated:
        raise InputError(f"its header says {unit}, a comment {stated}")
    return Raw(points, comments=comments, unit=unit, keeps_unit=True, changed=changed)


def _heading(
    lead: Lead, rows: Sequence[str], first: Sequence[str], heights: Sequence[str]
) -> Heading | None:
    """Find the row ahead that names x, y and z; None where only comments and titles are there.

    Raises
    ------
    InputError
        There is a row that should name them and does not; it quotes that row.
    """
    width = _filled(first)
    below: list[str] = []
    comments = 0
    for row, comment in reversed(lead.rows):
        comments += comment
        if comment and comments > _MOST_COMMENTS:
            continue  # of so many none is a heading
        row = row[:_LONGEST_HEADER]
        header = f"its header {quoted(row.strip(), 80)}"
        misfit = None
        named = 0
        for fields in splittings(_TITLE.sub("", row, count=1) if comment else row, lead.delimiter):
            count = _filled(fields)
            named = max(named, count)
            if count > MOST_COLUMNS or (comment and not 3 <= count <= len(first)):
                continue
            try:
                found = heading_of(fields, below, heights)
            except InputError as fault:
                raise InputError(f"{header} {fault.fault}") from None
            if found is None:
                if comment and count == width and axes_among(fields) > 1:
                    misfit = "does not name x, y and z once each"
            elif count == width or len(fields) == len(first):
                return found
            elif count == width - 1 and _begin_with_names(rows, lead.delimiter):
                x, y, z = (column + 1 for column in found.columns)
                return Heading((x, y, z), found.unit)
            elif not comment or found.columns != (0, 1, 2):
                misfit = f"names {count} columns, but {width} are in the row {quoted(rows[0])}"
            else:
                return found
        if misfit:
            raise InputError(f"{header} {misfit}")
        fields = split(row, lead.delimiter)
        if not below and are_units(fields):
            below = fields  # of a heading, which must stand above
        elif not comment and (named >= 3 or _MARKS.search(row)):
            raise InputError(f"{header} does not name x, y and z once each")
    if below and not lead.rows[-1][1]:
        raise InputError(f"its header {quoted(lead.rows[-1][0].strip(), 80)} names units only")
    return None


def _begin_with_names(rows: Sequence[str], delimiter: str | None) -> bool:
    """Tell rows that begin with a name for each, which their header has no name for."""
    begins = [split(row, delimiter)[0] for row in rows[:_SAMPLE]]
    named = not any(map(is_number, begins))
    return named or begins in ([str(i + start) for i in range(len(begins))] for start in (0, 1))


def _unnamed(sample: Sequence[Sequence[str]]) -> list[int]:
    """Choose the columns where no header names them: the first three that hold numbers.

    A fourth, ahead of them, may hold a number of each point.

    Raises
    ------
    InputError
        Something else than x, y and z seems to stand there.
    """
    numbers = [i for i, field in enumerate(sample[0]) if is_number(field)][:4]
    fields = [[row[i] if i < len(row) else "" for row in sample] for i in numbers]
    if len(numbers) < 3:
        return [0, 1, 2]  # refused where the numbers are read
    whole = [all(map(str.isdecimal, column)) for column in fields]
    if len(numbers) == 4 and len(sample) > 2 and whole[0]:
        if fields[0] == [str(int(fields[0][0]) + i) for i in range(len(sample))]:
            return numbers
        if all("." in field or "," in field for column in fields[1:] for field in column):
            raise InputError(
                "its first column holds whole numbers as points are numbered by; a header must "
                f"name x, y and z above the row {quoted(', '.join(sample[0]))}"
            )
    parted = any(
        whole[i] and all(_REST_OF_THOUSANDS.fullmatch(field) for field in fields[i + 1])
        for i in range(len(numbers) - 1)
    )
    if parted or any(_DECIMALS.fullmatch(field) for column in fields[1:] for field in column):
        raise InputError(
            "thousands or decimals seem to be taken apart; a header must name x, y and z above "
            f"the row {quoted(', '.join(sample[0]))}"
        )
    return numbers[:3]


def _numbers(
    text: str, rows: Sequence[str], delimiter: str | None, width: int, wanted: Sequence[int]
) -> NDArray[np.float64]:
    """Read the wanted columns: at once where all is plain, else after a look at every field."""
    decimal = "," if delimiter != "," and "," in text and "." not in text else "."
    plain = not is_odd(text) and (decimal == "," or delimiter == "," or "," not in text)
    if plain:
        dtype = np.dtype([(f"{i}", "f8" if i in wanted else "U1") for i in range(width)])
        lines = [row.replace(",", ".") for row in rows] if decimal == "," else rows
        with suppress(ValueError):
            table = np.loadtxt(
                lines, dtype, comments=None, delimiter=delimiter, quotechar='"', ndmin=1
            )
            points = np.stack([table[f"{i}"] for i in wanted], axis=1)
            refuse_thousands(
                points, lambda row, i: split(rows[row], delimiter)[wanted[i]], rows, decimal
            )
            return points
    expected = f"{width} columns, x, y and z numbers, expected"
    columns: list[list[str]] = [[] for _ in wanted]
    for row in rows:
        fields = split(row, delimiter)
        if len(fields) != width:
            raise InputError(expected, row=row)
        for column, i in zip(columns, wanted, strict=True):
            column.append(fields[i])
    return numbers_in(columns, rows, expected)


def _filled(fields: Sequence[str]) -> int:
    """Count fields up to the last that holds something."""
    return max((i + 1 for i, field in enumerate(fields) if field), default=0)
