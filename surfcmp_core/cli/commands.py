"""All commands of `surfcmp`."""

import os
import sys
from collections.abc import Sequence
from importlib import import_module
from io import TextIOWrapper
from pathlib import Path
from typing import Annotated, Any, override

import typer
from typer.core import TyperGroup

import surfcmp_core
from surfcmp_core.cli import NAMES
from surfcmp_core.cli.statuses import INTERRUPTED
from surfcmp_core.cli.stopping import stopping_soon


class _Commands(TyperGroup):
    """Loads a command only when it is asked for: `--version` needs none of them."""

    @override
    def list_commands(self, ctx: Any) -> list[str]:
        return list(NAMES)

    @override
    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        if cmd_name not in NAMES:
            return None
        one = typer.Typer(add_completion=False)
        one.command(cmd_name)(import_module(f"surfcmp_core.cli.{cmd_name}").command)
        return typer.main.get_command(one)


commands = typer.Typer(
    name="surfcmp",
    cls=_Commands,
    add_completion=False,
    pretty_exceptions_enable=False,
    no_args_is_help=True,
    epilog="Without a command: surfcmp [A [B]] opens the window.",
    help="Compare two surfaces z = F(x, y) given on unstructured grids of different density.",
)


def _version(asked: bool) -> None:
    if asked:
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
