"""`surfcmp info FILE`."""

from pathlib import Path
from typing import Annotated

import typer
from rich.text import Text

from surfcmp_core.cli.ends import ending
from surfcmp_core.cli.shared_options import NoDataOption, UnitOption
from surfcmp_core.cli.sight import data_rows, sight_rows
from surfcmp_core.cli.table import columns, console
from surfcmp_core.domain.layers import MIXED
from surfcmp_core.io import Facts, facts_of, read_surface
from surfcmp_core.names import one_line
from surfcmp_core.report.numbers import figure, thousands

File = Annotated[Path, typer.Argument(metavar="FILE", help="A surface.", show_default=False)]

_LONGEST = 60
"""Characters of what stands beside a count in the table; the rest stands below it."""


@ending
def command(file: File, unit: UnitOption = None, no_data: NoDataOption = None) -> None:
    """Say what a file holds: nodes, triangles, extents, what is seen of it, where it has data."""
    surface = read_surface(file, unit=unit, no_data=no_data or ())
    with_data, among_layers = data_rows(surface)
    rows = columns("", "")
    for title, found in (
        ("", fact_rows(facts_of(surface), among_layers)),
        ("seen with --project auto", sight_rows(surface)),
        ("data where no --max-edge is given", with_data),
    ):
        if found and title:
            rows.add_row()
            rows.add_row(Text(title, "bold"))
        for name, text in found:
            rows.add_row("  " + name, text)
    out = console()
    out.print(Text(one_line(file), "bold"))
    out.print(rows)
    for note, count in surface.changed.items():
        if len(note) > _LONGEST:
            out.print(Text.assemble(("warning: ", "bold yellow"), f"{thousands(count)} {note}"))


def fact_rows(facts: Facts, among_layers: float) -> list[tuple[str, str]]:
    """Return what is known of one surface, a row for each fact."""
    unit = facts.unit or ""
    return [
        ("kind", facts.kind),
        ("nodes", thousands(facts.nodes)),
        ("triangles", thousands(facts.triangles)),
        *(
            (axis, f"{figure(low)} to {figure(high)}, extent {figure(high - low)} {unit}".rstrip())
            for axis, low, high in zip("xyz", facts.low, facts.high, strict=True)
        ),
        ("unit", facts.unit or "not stated (mm is assumed)"),
        *([("axes", facts.space)] if facts.space else []),
        ("one-valued", _one_valued(facts, among_layers)),
        ("repeated nodes", thousands(facts.repeated)),
        *(
            (reason, thousands(count))
            for reason, count in (facts.dropped | facts.changed).items()
            if len(reason) <= _LONGEST
        ),
        ("SHA-256", facts.sha256),
    ]


def _one_valued(facts: Facts, among_layers: float) -> str:

    if facts.one_valued and among_layers <= MIXED:
        return "yes, seen along z"
    faults = []
    if among_layers > MIXED:
        faults.append(f"{100 * among_layers:.3g} % of the nodes lie among nodes of another layer")
    if facts.contradicting:
        faults.append(f"{thousands(facts.contradicting)} nodes share x, y with one of another z")
    if facts.folded:
        faults.append(f"{100 * facts.folded:.3g} % of the area, seen along z, folds over")
    return "no: " + "; ".join(faults)
