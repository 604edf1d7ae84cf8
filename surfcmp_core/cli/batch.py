"""`surfcmp batch PATHS...`: all pairs of some files."""

import csv
import io
import json
import os
import time
from itertools import combinations
from pathlib import Path
from typing import Annotated, Any, BinaryIO

import typer
from rich.table import Table
from rich.text import Text

from surfcmp_core.cli.bar import progress_bar
from surfcmp_core.cli.ends import WrongUsage, ending
from surfcmp_core.cli.shared_options import QuietOption, comparing, files_of
from surfcmp_core.cli.statuses import CANNOT_COMPARE, complain
from surfcmp_core.cli.table import console
from surfcmp_core.comparing.options import Options
from surfcmp_core.comparing.request import compare_surfaces
from surfcmp_core.errors import InputError, Violation
from surfcmp_core.io import read_surface
from surfcmp_core.io.read import READERS
from surfcmp_core.names import one_line
from surfcmp_core.report import OutputError, check_outputs
from surfcmp_core.report.meanings import MEANINGS
from surfcmp_core.report.numbers import with_unit
from surfcmp_core.report.record import Record, make_record, now, program
from surfcmp_core.surface import Surface
from surfcmp_core.system.progress import Progress
from surfcmp_core.system.whole_files import write_all

Paths = Annotated[
    list[Path],
    typer.Argument(metavar="PATHS...", help="Files and folders of files.", show_default=False),
]
OutOption = Annotated[
    list[Path] | None,
    typer.Option("--out", metavar="FILE", help="Write the table; repeatable. Endings: .csv .json"),
]
_KEPT = 10_000_000
"""Nodes of read files that are kept for later pairs."""
_NOTES = 20
"""Warnings that are printed."""
_COLUMNS = ("mean_abs", "p95", "coverage_1", "coverage_2")


@ending
@comparing
def command(
    paths: Paths, options: Options, out: OutOption = None, quiet: QuietOption = False
) -> None:
    """Compare every file with every later one; a pair that fails does not stop the others."""
    results = out or []
    files = _files(paths, leave_out=results)
    try:
        check_outputs(results, [*files, *files_of(options)], (".csv", ".json"))
    except OutputError as fault:
        raise WrongUsage(f"--out {fault}") from None

    with progress_bar(quiet) as progress:
        done = _all_pairs(files, options, progress)
    write_all({path: _writer(path, done) for path in results})
    if not quiet:
        _show(done)
    if any("error" in one for one in done):
        raise typer.Exit(CANNOT_COMPARE)


def _files(paths: list[Path], leave_out: list[Path]) -> list[Path]:
    """Name the files, and in folders those that can be read; but no hidden ones, nor results."""
    results = {os.path.realpath(path) for path in leave_out}
    files: list[Path] = []
    for path in paths:
        if not path.is_dir():
            files.append(path)
            continue
        try:
            inside = sorted(path.iterdir())
        except OSError as fault:
            raise InputError(f"cannot be read: {fault.strerror}", where=(str(path),)) from None
        files += [
            one
            for one in inside
            if one.suffix.lower() in READERS
            and not one.name.startswith(".")
            and os.path.realpath(one) not in results
        ]
    files = list(dict.fromkeys(files))
    if len(files) < 2:
        raise WrongUsage(f"batch: two files or more are needed, found {len(files)}")
    return files


def _all_pairs(files: list[Path], options: Options, progress: Progress) -> list[Record]:
    """Compare each file with every later one; what fails is told once and kept as an error."""
    surfaces: dict[Path, Surface] = {}
    faults: dict[Path, InputError] = {}
    told: set[str] = set()

    def surface_of(path: Path) -> Surface:
        """Read a file, a bad one only once."""
        if path in faults:
            raise faults[path]
        if path not in surfaces:
            try:
                surfaces[path] = read_surface(path, unit=options.unit, no_data=options.no_data)
            except InputError as fault:
                faults[path] = fault
                raise
        return surfaces[path]

    pairs = list(combinations(files, 2))
    done: list[Record] = []
    for number, (first, second) in enumerate(pairs):

        def within(_stage: str, share: float, number: int = number) -> None:
            progress(f"pair {number + 1} of {len(pairs)}", (number + share) / len(pairs))

        within("read", 0.0)
        try:
            start = time.perf_counter()
            both = surface_of(first), surface_of(second)
            seconds = time.perf_counter() - start
            done.append(make_record(compare_surfaces(*both, options, within, seconds)))
        except (InputError, Violation, MemoryError) as fault:
            error = str(fault) or f"{first} and {second}: not enough memory"
            if error not in told:
                complain(error)
            told.add(error)
            names = [{"file": one_line(path)} for path in (first, second)]
            done.append({"inputs": names, "error": one_line(error)})
        if sum(len(one.points) for one in surfaces.values()) > _KEPT:
            surfaces = {first: surfaces[first]} if first in surfaces else {}
    return done


def _writer(path: Path, done: list[Record]) -> Any:
    def write_json(stream: BinaryIO) -> None:
        whole = {"schema": 1, "program": program(), "created": now(), "pairs": done}
        text = json.dumps(whole, indent=1, ensure_ascii=False, allow_nan=False)
        stream.write(text.encode() + b"\n")

    def write_csv(stream: BinaryIO) -> None:

        text = io.TextIOWrapper(stream, encoding="utf-8", newline="")
        keys = [one.key for one in MEANINGS if one.key != "within_tolerance"]
        tolerances = next(
            (list(one["measures"]["within_tolerance"]) for one in done if "error" not in one), []
        )
        table = csv.writer(text, lineterminator="\n")
        within_keys = [f"within_{t}" for t in tolerances]
        last = ["unit", "warnings", "error"]
        table.writerow(["file_1", "file_2", *keys, *within_keys, *last])
        for one in done:
            measures = one.get("measures", {})
            within = measures.get("within_tolerance", {})
            table.writerow(
                [one["inputs"][0]["file"], one["inputs"][1]["file"]]
                + [measures.get(key) for key in keys]
                + [within.get(t) for t in tolerances]
                + [one.get("options", {}).get("unit", "")]
                + ["; ".join(one.get("warnings", ())), one.get("error", "")]
            )
        text.detach()

    return write_json if path.suffix.lower() == ".json" else write_csv


def _show(done: list[Record]) -> None:

    powers = {one.key: one.power for one in MEANINGS}
    rows = Table(box=None, pad_edge=False, header_style="bold", padding=(0, 2, 0, 0))
    for name in ("1", "2"):
        rows.add_column(name, overflow="fold")
    for name in _COLUMNS:
        rows.add_column(name, justify="right", no_wrap=True)
    for one in done:
        names = [Text(Path(file["file"]).name) for file in one["inputs"]]
        if "error" in one:
            rows.add_row(*names, Text("failed", "red"))
            continue
        unit = one["options"]["unit"]
        cells = (with_unit(one["measures"][key], powers[key], unit) for key in _COLUMNS)
        rows.add_row(*names, *(f"{value} {symbol}" for value, symbol in cells))
    out = console()
    out.print(rows)
    told: dict[str, None] = {}
    for one in done:
        doubts = one["alignment"]["doubts"] if "error" not in one else ()
        for doubt in doubts:
            pair = " and ".join(Path(file["file"]).name for file in one["inputs"])
            out.print(Text.assemble(("warning: ", "bold yellow"), f"{pair}: {doubt}"))
        told |= dict.fromkeys(
            note for note in one.get("warnings", ()) if not note.endswith(tuple(doubts))
        )
    notes = list(told)
    for note in notes[:_NOTES]:
        out.print(Text.assemble(("warning: ", "bold yellow"), note))
    if len(notes) > _NOTES:
        out.print(f"and {len(notes) - _NOTES} warnings more: --out FILE.json has them all")
