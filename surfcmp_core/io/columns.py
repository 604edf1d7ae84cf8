"""Read .xyz, .txt and .csv: three or more columns of text."""

import csv
import re

import numpy as np

from surfcmp_core.errors import InputError
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.text import decode, filled_lines, load, quoted
from surfcmp_core.io.units import unit_in


def read_columns(data: bytes) -> Raw:
    """Nodes of a table separated by white space, commas or semicolons.

    Its first three columns, or those that its header names x, y and z. Between semicolons decimals
    may follow a comma. Lines that begin with ``#``, ``//`` or ``%``, one header (a row without any
    number) and one count of rows may stand ahead of the numbers.
    """
    text = decode(data)
    comments: list[str] = []
    header: list[str] = []
    declared: int | None = None
    rows = filled_lines(text)
    for first, row in enumerate(rows):  # noqa: B007 - where the numbers begin
        delimiter = ";" if ";" in row else "," if "," in row else None
        if delimiter == ";":
            row = _with_points(row)
        fields = next(csv.reader([row], delimiter=delimiter)) if delimiter else row.split()
        fields = [field.strip(' \t"') for field in fields]
        if row.lstrip().startswith(("//", "%")):
            comments.append(row)
        elif len(fields) == 1 and fields[0].isdecimal() and declared is None:
            declared = int(fields[0][:18])
        elif not header and not any(map(_is_number, fields)):
            header = [field.lower() for field in fields]
        else:
            break
    else:
        raise InputError("it holds no rows of numbers")

    rows = rows[first:]
    if delimiter == ";":
        rows = [_with_points(row) for row in rows]
    width = len(fields)
    if width < 3:
        raise InputError(f"three columns or more expected, {width} in the row {quoted(rows[0])}")
    if declared not in (None, len(rows)):
        raise InputError(f"{declared} rows declared, {len(rows)} found")
    wanted = _named(header) if len(header) == width else None
    wanted = wanted or [0, 1, 2]
    dtype = np.dtype([(f"{i}", "f8" if i in wanted else "U1") for i in range(width)])
    expected = f"{width} columns, x, y and z numbers, expected"
    columns = load(rows, dtype, expected, delimiter=delimiter, quotechar='"', ndmin=1)
    points = np.stack([columns[f"{i}"] for i in wanted], axis=1)
    comments += [line for line in text[:2000].split("\n") if line.lstrip().startswith("#")]
    return Raw(points, unit=unit_in(tuple(comments)))


def _named(header: list[str]) -> list[int] | None:
    """Find x, y and z by their names, which a unit may follow: ``x``, ``x (mm)``, ``x_mm``."""
    for names in (header, [re.sub("[^a-z].*", "", name) for name in header]):
        if all(names.count(axis) == 1 for axis in "xyz"):
            return [names.index(axis) for axis in "xyz"]
    return None


def _with_points(row: str) -> str:
    """Write decimal commas, which only tables with semicolons can have, as points."""
    return row.replace(",", ".")


def _is_number(field: str) -> bool:
    try:
        float(field)
    except ValueError:
        return False
    return True
