"""The options of every command that compares, described once."""

import functools
import inspect
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

from surfcmp_core.comparing.options import NOT_MOVED, Options

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


def _options(
    *,
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
    threads: ThreadsOption = 2,
    verify: VerifyOption = False,
) -> Options:
    known: dict[str, Any] = {"none": NOT_MOVED, "icp": "icp"}
    return Options(
        domain=domain,
        max_edge=max_edge,
        exact=exact,
        tolerances=tuple(tolerance or (0.5, 1.0, 2.0)),
        duplicates=duplicates,
        unit=unit,
        no_data=tuple(no_data or ()),
        weight=weight,
        align=known.get(align, Path(align)),
        project=project,
        threads=threads,
        verify=verify,
    )


def comparing(command: Callable[..., None]) -> Callable[..., None]:
    """Give a command all options of a comparison; it gets them as its argument `options`.

    Raises
    ------
    OptionError
        When called with one that means nothing.
    """
    asked = inspect.signature(_options).parameters
    own = inspect.signature(command).parameters

    @functools.wraps(command)
    def asking(**given: Any) -> None:
        options = _options(**{name: given.pop(name) for name in asked})
        command(**given, options=options)

    shown = [one for one in own.values() if one.name != "options"]
    first = [one for one in shown if one.default is inspect.Parameter.empty]
    rest = [one for one in shown if one not in first]
    every = [
        one.replace(kind=inspect.Parameter.KEYWORD_ONLY) for one in (*first, *asked.values(), *rest)
    ]
    asking.__signature__ = inspect.Signature(every)  # type: ignore[attr-defined]
    return asking


def files_of(options: Options) -> list[Path]:
    """Name the files that options read, so that no result is written over them."""
    named = (options.weight, options.align)
    return [one for one in named if isinstance(one, Path)]
