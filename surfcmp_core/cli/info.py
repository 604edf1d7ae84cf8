"""`surfcmp info FILE`."""

from pathlib import Path
from typing import Annotated

import typer

from surfcmp_core.cli.ends import ending
from surfcmp_core.cli.options import UnitOption
from surfcmp_core.io import Facts
from surfcmp_core.report.numbers import figure, thousands

File = Annotated[Path, typer.Argument(metavar="FILE", help="A surface.", show_default=False)]


@ending
def command(file: File, unit: UnitOption = None) -> None:
    """Say what a file holds: nodes, triangles, extents, what is seen of it, where it has data."""
    from rich.text import Text

    from surfcmp_core.cli.sight import data_rows, sight_rows
    from surfcmp_core.cli.table import columns, console
    from surfcmp_core.io import facts_of, read_surface
    from surfcmp_core.names import one_line

    surface = read_surface(file, unit=unit)
    rows = columns("", "")
    for title, found in (
        ("", fact_rows(facts_of(surface))),
        ("seen with --project auto", sight_rows(surface)),
        ("data where no --max-edge is given", data_rows(surface)),
    ):
        if found and title:
            rows.add_row()
            rows.add_row(Text(title, "bold"))
        for name, text in found:
            rows.add_row("  " + name, text)
    out = console()
    out.print(Text(one_line(file), "bold"))
    out.print(rows)


def fact_rows(facts: Facts) -> list[tuple[str, str]]:
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
        ("one-valued", _one_valued(facts)),
        ("repeated nodes", thousands(facts.repeated)),
        *((reason, thousands(count)) for reason, count in (facts.dropped | facts.changed).items()),
        ("SHA-256", facts.sha256),
    ]


def _one_valued(facts: Facts) -> str:
    if facts.one_valued:
        return "yes, seen along z"
    faults = []
    if facts.contradicting:
        faults.append(f"{thousands(facts.contradicting)} nodes share x, y with one of another z")
    if facts.folded:
        faults.append(f"{100 * facts.folded:.3g} % of the area, seen along z, folds over")
    return "no: " + "; ".join(faults)
