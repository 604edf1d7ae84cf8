"""`surfcmp compare A B`."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from surfcmp_core.cli.bar import progress_bar
from surfcmp_core.cli.ends import WrongUsage, ending
from surfcmp_core.cli.pair import Settings, compare_files
from surfcmp_core.cli.shared_options import (
    AlignOption,
    DomainOption,
    DuplicatesOption,
    ExactOption,
    JsonOption,
    MaxEdgeOption,
    NoDataOption,
    ProjectOption,
    QuietOption,
    ThreadsOption,
    ToleranceOption,
    UnitOption,
    VerifyOption,
    WeightOption,
)
from surfcmp_core.report import OutputError, check_outputs, write_outputs
from surfcmp_core.report.data_files import json_bytes

First = Annotated[Path, typer.Argument(metavar="A", help="Surface 1.", show_default=False)]
Second = Annotated[Path, typer.Argument(metavar="B", help="Surface 2.", show_default=False)]
OutOption = Annotated[
    list[Path] | None,
    typer.Option(
        "--out",
        metavar="FILE",
        help="Write the result; repeatable. Endings: .json .npz .csv .vtp .ply .html .pdf .png",
    ),
]


@ending
def command(
    a: First,
    b: Second,
    domain: DomainOption = "data",
    max_edge: MaxEdgeOption = None,
    exact: ExactOption = False,
    tolerance: ToleranceOption = None,
    weight: WeightOption = None,
    align: AlignOption = "none",
    project: ProjectOption = "z",
    duplicates: DuplicatesOption = "refuse",
    unit: UnitOption = None,
    no_data: NoDataOption = None,
    out: OutOption = None,
    json: JsonOption = False,
    quiet: QuietOption = False,
    threads: ThreadsOption = 2,
    verify: VerifyOption = False,
) -> None:
    """Compare two surfaces and print the measures."""
    settings = Settings(
        domain=domain,
        max_edge=max_edge,
        exact=exact,
        tolerances=tuple(tolerance or (0.5, 1.0, 2.0)),
        duplicates=duplicates,
        unit=unit,
        no_data=tuple(no_data or ()),
        weight=weight,
        align=align,
        project=project,
        threads=threads,
        verify=verify,
    )
    settings.check()
    results = out or []
    files = [a, b, *([weight] if weight else [])]
    if align not in {"none", "icp"}:
        files.append(Path(align))
    try:
        check_outputs(results, files)
    except OutputError as fault:
        raise WrongUsage(f"--out {fault}") from None

    with progress_bar(quiet) as progress:
        comparison, document = compare_files((a, b), settings, progress)
        if results:
            progress("write", 1.0)
            write_outputs(comparison, document, results)
    if json:
        sys.stdout.buffer.write(json_bytes(document))
    elif not quiet:
        from surfcmp_core.cli.table import show

        show(document)
