"""`surfcmp compare A B`."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from surfcmp_core.cli.bar import progress_bar
from surfcmp_core.cli.ends import WrongUsage, ending
from surfcmp_core.cli.shared_options import JsonOption, QuietOption, comparing, files_of
from surfcmp_core.comparing.options import Options
from surfcmp_core.comparing.request import compare_files
from surfcmp_core.report import OutputError, check_outputs, make_record, write_outputs
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
@comparing
def command(
    a: First,
    b: Second,
    options: Options,
    out: OutOption = None,
    json: JsonOption = False,
    quiet: QuietOption = False,
) -> None:
    """Compare two surfaces and print the measures."""
    results = out or []
    try:
        check_outputs(results, [a, b, *files_of(options)])
    except OutputError as fault:
        raise WrongUsage(f"--out {fault}") from None

    with progress_bar(quiet) as progress:
        comparison = compare_files(a, b, options, progress)
        record = make_record(comparison)
        if results:
            progress("write", 1.0)
            write_outputs(comparison, record, results)
    if json:
        sys.stdout.buffer.write(json_bytes(record))
    elif not quiet:
        from surfcmp_core.cli.table import show

        show(record)
