"""`surfcmp`: which command, and how it ends."""

import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from types import FrameType
from typing import Annotated

import typer

from surfcmp_core.cli import batch, compare, info
from surfcmp_core.cli.ends import CANNOT_COMPARE, INTERRUPTED, WRONG_USAGE, complain

Window = Callable[[list[Path]], int]
"""Opens the window on at most two files; returns its exit status."""

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
NAMES = tuple(str(one.name) for one in commands.registered_commands)


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


def run(arguments: Sequence[str], window: Window) -> int:
    """Do what the arguments say.

    Parameters
    ----------
    arguments
        Of the command line, without the program's name.
    window
        Called when no command is named.

    Returns
    -------
    int
        0 done, 2 wrong usage, 3 the input cannot be compared, 130 interrupted.
    """
    with _termination_like_ctrl_c():
        return _run(arguments, window)


def _run(arguments: Sequence[str], window: Window) -> int:
    try:
        if arguments and (arguments[0] in NAMES or arguments[0].startswith("-")):
            commands(list(arguments), prog_name="surfcmp")
            return 0
        return _open(window, arguments)
    except SystemExit as end:
        # 1 is typer's word for a reader that went away.
        return INTERRUPTED if end.code == 1 else int(end.code or 0)
    except KeyboardInterrupt:
        return INTERRUPTED


def _open(window: Window, arguments: Sequence[str]) -> int:
    paths = [Path(argument) for argument in arguments]
    if len(paths) > 2:
        complain(f"{len(paths)} files; the window takes at most two (see surfcmp --help)")
        return WRONG_USAGE
    for path in paths:
        if not path.is_file():
            known = ", ".join(NAMES)
            complain(f"{path}: no such file, nor a command (commands are {known})")
            return CANNOT_COMPARE
    return window(paths)


@contextmanager
def _termination_like_ctrl_c() -> Iterator[None]:
    """Let a polite kill clean up as Ctrl-C does."""

    def stop(_signal: int, _frame: FrameType | None) -> None:
        raise KeyboardInterrupt

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGTERM, stop)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)
