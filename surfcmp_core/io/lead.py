"""What stands ahead of the numbers of a table: comments, headers, a count of rows."""

import csv
import re
from collections.abc import Iterator
from dataclasses import dataclass, field

from surfcmp_core.errors import InputError
from surfcmp_core.io.headings import are_units
from surfcmp_core.io.notation import is_number
from surfcmp_core.names import quoted

_COMMENT = re.compile(r"\s*(?:#+|//+|%+)")
_SEPARATOR = re.compile(r'"?sep=(.)"?', re.IGNORECASE)
MOST_COLUMNS = 1000
"""More are no table of nodes."""
_AHEAD = 1000
_MOST = 100
"""Rows without numbers that may stand ahead."""
_BRACKETS = re.compile(r"[(\[{<][^()\[\]{}<>]*[)\]}>]")


@dataclass(slots=True)
class Lead:
    """What stands ahead of the numbers."""

    rows: list[tuple[str, bool]] = field(default_factory=list)
    """Rows that may be headings, and whether they are comments."""
    comments: list[str] = field(default_factory=list)
    """Lines of comment, with their marks."""
    declared: int | None = None
    """Number of rows."""
    delimiter: str | None = None
    """Of the first row of numbers; None for white space."""
    end: int = 0
    """Where in the text the numbers begin."""


def lead_of(text: str) -> Lead:
    """Read up to the first row of three numbers or more.

    Parameters
    ----------
    text : str
        Of the whole file.

    Returns
    -------
    Lead

    Raises
    ------
    InputError
        There is none.
    """
    lead = Lead()
    given: str | None = None
    while lead.end < len(text):
        after = text.find("\n", lead.end) + 1 or len(text)
        line = text[lead.end : after].rstrip("\n")
        if mark := _COMMENT.match(line):
            lead.rows.append((line[mark.end() :].strip(), True))
            lead.comments.append(line)
        elif found := _SEPARATOR.fullmatch(line.strip(" ")):
            given = found[1]
        elif line.strip():
            lead.delimiter = given or delimiter_of(line)
            fields = split(line, lead.delimiter)
            numbers = _count_numbers(fields)
            if len(fields) == 1 and fields[0].isdecimal() and lead.declared is None:
                lead.declared = int(fields[0][:18])
            elif (numbers >= 3 or numbers == len(fields)) and not _counts(
                fields, text[after : after + 1000]
            ):
                return lead
            elif len(lead.rows) - len(lead.comments) == _MOST:
                break
            else:
                lead.rows.append((line, False))
        lead.end = after
    last = [row for row, comment in lead.rows if not comment][-1:]
    told = f", only such as {quoted(last[0].strip())}" if last else ""
    raise InputError(f"it holds no rows of numbers{told}")


def delimiter_of(row: str) -> str | None:
    """Find what parts the fields of a row; None for white space."""
    if ";" in row:
        return ";"
    blank = split(row, None)
    if "\t" in row:
        tab = split(row, "\t")
        if _count_numbers(tab) >= 3 and ("," in row or len(tab) != len(blank)):
            return "\t"
    if "," not in row:
        return None
    comma = split(row, ",")
    decimals = _count_numbers(blank) >= 3 and not any(one.endswith(",") for one in blank)
    if decimals and (_count_numbers(comma) < 3 or any(" " in one for one in comma)):
        return None
    return ","


def split(row: str, delimiter: str | None) -> list[str]:
    """Part a row into its fields, without quotes and blanks around."""
    if delimiter:
        try:
            fields = next(csv.reader([row], delimiter=delimiter, skipinitialspace=True))
        except csv.Error as error:  # a field longer than any table has
            raise InputError(f"a row cannot be read: {error}") from None
    elif '"' in row:
        fields = re.findall(r'"[^"]*"|[^\s"]+', row)
    else:
        fields = row.split() if row.isascii() else re.split(r"[ \t]+", row.strip(" \t"))
    return [field.strip(' \t"') for field in fields]


def splittings(row: str, delimiter: str | None) -> Iterator[list[str]]:
    """Part a heading in every way: that of the numbers first; units belong to the name before."""
    for mark in dict.fromkeys((delimiter, ";", "\t", ",", None)):
        if mark is None or mark in row:
            yield split(row, mark)
    yield re.split(r"\s{2,}|\t", row.strip())
    spaced = _BRACKETS.sub(lambda found: f" {found[0]} ", row)
    merged: list[str] = []
    for word in re.findall(r'"[^"]*"|[(\[{<][^()\[\]{}<>]*[)\]}>]|[^\s"]+', spaced):
        if merged and (_BRACKETS.fullmatch(word) or are_units([word])):
            merged[-1] += " " + word
        else:
            merged.append(word.strip('"'))
    yield merged


def _count_numbers(fields: list[str]) -> int:
    return sum(map(is_number, fields[:MOST_COLUMNS]))


def _counts(fields: list[str], after: str) -> bool:
    """Tell a header that numbers the columns, as programs write for columns without names."""
    numbered = fields[1:] if fields[0] == "" else fields
    if numbered != [str(i) for i in range(len(numbered))]:
        return False
    following = after[: after.find("\n") % (len(after) + 1)]
    return fields[0] == "" or all("." in one for one in split(following, delimiter_of(following)))
