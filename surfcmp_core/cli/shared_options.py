"""The options that `compare` and `batch` share, described once."""

from pathlib import Path
from typing import Annotated, Literal

import typer

DomainOption = Annotated[
    Literal["data", "hull", "plane"],
    typer.Option(
        "--domain", help="Compare where both have data, inside both hulls, or over all of T."
    ),
]
MaxEdgeOption = Annotated[
    float | None,
    typer.Option(
        "--max-edge",
        metavar="X",
        help="Longest edge over which a cloud has data, in the result's unit; inf: no limit.",
        show_default="follows the spacing of the nodes around",
    ),
]
ExactOption = Annotated[
    bool, typer.Option("--exact", help="Integrate over the overlay of T1 and T2 as well.")
]
ToleranceOption = Annotated[
    list[float] | None,
    typer.Option(
        "--tolerance",
        metavar="X",
        help="Share of the area within X, in the result's unit; repeatable.",
        show_default="0.5, 1, 2",
    ),
]
DuplicatesOption = Annotated[
    Literal["refuse", "mean", "max", "min"],
    typer.Option("--duplicates", help="What to do with nodes of equal x, y and different z."),
]
UnitOption = Annotated[
    Literal["mm", "cm", "m", "um", "in", "ft", "us-ft"] | None,
    typer.Option(
        "--unit", help="Unit of the files' coordinates, whatever they say; converted to mm."
    ),
]
NoDataOption = Annotated[
    list[float] | None,
    typer.Option(
        "--no-data",
        metavar="X",
        help="Leave out nodes with this value of x, y or z, in the file's unit; nan: all that is "
        "not finite; repeatable.",
    ),
]
WeightOption = Annotated[
    Path | None,
    typer.Option(
        "--weight", metavar="FILE", help="Weight µ: x, y, µ at the nodes of a surface file."
    ),
]
AlignOption = Annotated[
    str,
    typer.Option(
        "--align",
        metavar="none|icp|FILE",
        help="Move B onto A: not at all, by best fit, or by the 4×4 matrix in FILE, whose lengths "
        "are in the unit of A's file (with --unit: in that one).",
    ),
]
ProjectOption = Annotated[
    str,
    typer.Option(
        "--project",
        metavar="auto|z|view:X,Y,Z",
        help="Look along z, along the direction that shows most, or along X, Y, Z of A's file.",
    ),
]
ThreadsOption = Annotated[int, typer.Option("--threads", metavar="N", min=1, help="Threads.")]
QuietOption = Annotated[bool, typer.Option("--quiet", help="No table and no progress.")]
JsonOption = Annotated[
    bool,
    typer.Option("--json", help="Print the .json document, and nothing else."),
]
VerifyOption = Annotated[
    bool,
    typer.Option(
        "--verify", help="Check all that must hold of the result, slowly, also the other way round."
    ),
]
