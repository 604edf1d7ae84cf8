"""How commands end: what they raise becomes an exit status."""

import functools
import os
import sys
import traceback
from collections.abc import Callable
from pathlib import Path

import typer

from surfcmp_core.cli.statuses import CANNOT_COMPARE, INTERRUPTED, WRONG_USAGE, complain
from surfcmp_core.errors import OptionError, SurfcmpError


class WrongUsage(SurfcmpError):  # noqa: N818 - not a fault of the program
    """The arguments ask for something that does not exist; the message is one line."""


def ending[**P](command: Callable[P, None]) -> Callable[P, None]:
    """Turn what a command raises into its exit status and one line, not a traceback.

    `python -X dev` shows the traceback of a fault of the program.
    """

    @functools.wraps(command)
    def ended(*args: P.args, **kwargs: P.kwargs) -> None:
        try:
            command(*args, **kwargs)
            sys.stdout.flush()
        except typer.Exit:
            raise
        except WrongUsage as fault:
            complain(str(fault))
            raise typer.Exit(WRONG_USAGE) from None
        except OptionError as fault:
            complain(f"--{fault.option.replace('_', '-')}: must be {fault.must}")
            raise typer.Exit(WRONG_USAGE) from None
        except SurfcmpError as fault:
            complain(str(fault))
            raise typer.Exit(CANNOT_COMPARE) from None
        except MemoryError:
            complain("not enough memory for this input")
            raise typer.Exit(CANNOT_COMPARE) from None
        except BrokenPipeError:
            _forget_standard_output()
            raise typer.Exit(INTERRUPTED) from None
        except OSError as fault:
            complain(f"{fault.filename or 'standard output'}: {fault.strerror or fault}")
            _forget_standard_output()
            raise typer.Exit(CANNOT_COMPARE) from None
        except Exception as fault:
            if sys.flags.dev_mode:
                raise
            place = traceback.extract_tb(fault.__traceback__)[-1]
            complain(
                f"internal error, please report it: {type(fault).__name__}: {str(fault)[:200]} "
                f"({Path(place.filename).name}, line {place.lineno})"
            )
            raise typer.Exit(CANNOT_COMPARE) from None

    return ended


def _forget_standard_output() -> None:
    """Keep the interpreter from flushing, on its way out, into a pipe that nobody reads."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, sys.stdout.fileno())
    os.close(nowhere)
