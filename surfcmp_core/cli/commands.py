"""All commands of `surfcmp`."""

import os
import sys
from collections.abc import Sequence
from io import TextIOWrapper
from pathlib import Path
from typing import Annotated

import typer

from surfcmp_core.cli import batch, compare, info, thin
from surfcmp_core.cli.statuses import INTERRUPTED
from surfcmp_core.cli.stopping import stopping_soon

commands = typer.Typer(
    name="surfcmp",
    add_completion=False,
    pretty_exceptions_enable=False,
    no_args_is_help=True,
    epilog="Without a command: surfcmp [A [B]] opens the window.",
    help="Compare two surfaces z = F(x, y) given on unstructured grids of different density.",
)
commands.command("compare")(compare.command)
commands.command("batch")(batch.command)
commands.command("info")(info.command)
commands.command("thin")(thin.command)


def _version(asked: bool) -> None:
    if asked:
        import surfcmp_core

        typer.echo(f"surfcmp {surfcmp_core.__version__}")
        raise typer.Exit


@commands.callback()
def _options(
    version: Annotated[
        bool,
        typer.Option("--version", is_eager=True, callback=_version, help="Show the version."),
    ] = False,
) -> None:
    """Take the options that belong to no command."""


def run_command(arguments: Sequence[str]) -> int:
    """Run the command that the arguments name; return its exit status."""
    _make_streams_usable()
    with stopping_soon():
        try:
            commands(list(arguments), prog_name="surfcmp")
        except SystemExit as end:
            # 1 is typer's word for a reader that went away.
            return INTERRUPTED if end.code == 1 else int(end.code or 0)
    return 0


def _make_streams_usable() -> None:
    """Let text go out whatever the terminal's letters are, and nowhere where there is no stream."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, Path(os.devnull).open("w", encoding="utf-8"))  # noqa: SIM115
        elif isinstance(stream := getattr(sys, name), TextIOWrapper):
            stream.reconfigure(errors="replace")
