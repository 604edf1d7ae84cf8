"""`surfcmp`: a command, or the window; nothing is imported for the one that the other needs."""

from collections.abc import Callable, Sequence
from pathlib import Path

from surfcmp_core.cli import NAMES
from surfcmp_core.cli.statuses import CANNOT_COMPARE, INTERRUPTED, WRONG_USAGE, complain

Window = Callable[[list[Path]], int]
"""Opens the window on at most two files; returns its exit status."""


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
    try:
        if arguments and (arguments[0] in NAMES or arguments[0].startswith("-")):
            from surfcmp_core.cli.commands import run_command

            return run_command(arguments)
        return _open(window, arguments)
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
