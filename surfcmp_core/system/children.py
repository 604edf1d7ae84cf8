"""Processes that do a part of the work; they end where the work is given up."""

import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from surfcmp_core.errors import Cancelled

_running: set[subprocess.Popen[bytes]] = set()


@contextmanager
def child(
    program: str, arguments: Sequence[str] = (), pipe: int = subprocess.PIPE
) -> Iterator[subprocess.Popen[bytes]]:
    """Run a program of Python's in another process.

    Ctrl-C at a terminal does not reach it: who started it ends it.

    Parameters
    ----------
    program
        Its text.
    pipe
        What its standard input and output are.

    Raises
    ------
    OSError
        It cannot be started, or to or from it nothing goes.
    Cancelled
        It was ended by :func:`end_children`.
    """
    with subprocess.Popen(
        [sys.executable, "-c", program, *arguments],
        stdin=pipe,
        stdout=pipe,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    ) as process:
        _running.add(process)
        try:
            yield process
        except OSError:
            process.kill()
            if process not in _running:
                raise Cancelled from None
            raise
        except BaseException:
            process.kill()
            raise
        else:
            if process not in _running:
                raise Cancelled
        finally:
            _running.discard(process)


def end_children() -> None:
    """End all such processes; who waits for one is told by `Cancelled`."""
    while _running:
        _running.pop().kill()
