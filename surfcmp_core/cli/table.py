"""Tables on standard output, for people."""

import sys
from typing import Literal

from rich.console import Console
from rich.table import Table
from rich.text import Text

from surfcmp_core.report.meanings import NOTES, lines
from surfcmp_core.report.numbers import with_unit
from surfcmp_core.report.provenance import (
    alignment_rows,
    base_name,
    count_rows,
    left_out_rows,
    view_rows,
)
from surfcmp_core.report.record import Record

_WIDTH = 100
"""Columns, where no terminal says how wide it is."""


def show(document: Record) -> None:
    """Print the measures, counts and warnings of a comparison."""
    unit = document["options"]["unit"]
    first, second = (base_name(one["file"]) for one in document["inputs"])
    out = console()
    out.print(Text.assemble("\n", (first, "bold"), "  −  ", (second, "bold")))
    out.print(Text(f"d = z1 − z2 in {unit}; 1 is the first file, 2 the second", "dim"))

    rows = columns("", "right", "", "")
    group = ""
    measures = lines(document["measures"], unit)
    for line in measures:
        if line.group != group:
            group = line.group
            rows.add_row()
            rows.add_row(Text(group, "bold"))
        value, symbol = with_unit(line.value, line.power, unit)
        rows.add_row(
            "  " + line.name, Text(value, "bold"), Text(symbol, "dim"), Text(line.text, "dim")
        )
    out.print(rows)
    shown = {line.group for line in measures}
    for group, note in NOTES.items():
        if group not in shown:
            continue
        out.print(Text(f"\n{group}: {note}", "dim"))

    groups = {
        "View": view_rows(document),
        "Counts": [*count_rows(document), *left_out_rows(document)],
    }
    if document["alignment"]["method"] != "none":
        groups["Alignment"] = alignment_rows(document)
    for title, facts in groups.items():
        out.print(Text(f"\n{title}", "bold"))
        table = columns("", "")
        for name, text in facts:
            table.add_row("  " + name, text)
        out.print(table)
    out.print()
    for warning in document["warnings"]:
        out.print(Text.assemble(("warning: ", "bold yellow"), warning))


def console() -> Console:
    """Return standard output, as wide as its terminal."""
    return Console(width=None if sys.stdout.isatty() else _WIDTH, highlight=False, markup=False)


def columns(*justified: str) -> Table:
    """Return a table without lines, its columns justified as said ("" for left)."""
    table = Table(box=None, pad_edge=False, show_header=False, padding=(0, 2, 0, 0))
    for place, justify in enumerate(justified):
        last = place == len(justified) - 1
        side: Literal["left", "right"] = "right" if justify == "right" else "left"
        table.add_column(justify=side, no_wrap=not last, overflow="fold")
    return table
