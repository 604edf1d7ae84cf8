"""Ctrl-C, a polite kill and a closed terminal end the program soon, wherever they meet it."""

import os
import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from surfcmp_core.cli.statuses import INTERRUPTED

PATIENCE = 3
"""Seconds that what was begun has for ending itself; compiling, say, takes longer."""

_SHOW_CURSOR = "\x1b[?25h"


@contextmanager
def stopping_soon() -> Iterator[None]:
    """Let SIGINT, SIGTERM and SIGHUP unwind the block; end the process where that takes too long.

    The second signal does not wait. Either way no output is left half-written. Signals that are
    ignored (`nohup`, a script's background) stay so.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = {
        one: handler
        for name in ("SIGINT", "SIGTERM", "SIGHUP")
        if (one := getattr(signal, name, None))
        and (handler := signal.getsignal(one)) != signal.SIG_IGN
    }
    told = sys.unraisablehook

    def stop(_signal: int, _frame: FrameType | None) -> None:
        sys.unraisablehook = lambda _fault: None  # destructors of what is only half made
        for one in before:
            signal.signal(one, _abandon)
        if hasattr(signal, "alarm"):
            signal.signal(signal.SIGALRM, _abandon)
            signal.alarm(PATIENCE)
        raise KeyboardInterrupt

    try:
        for one in before:
            signal.signal(one, stop)
        yield
    finally:
        if hasattr(signal, "alarm"):
            signal.alarm(0)
        for one, handler in before.items():
            signal.signal(one, handler)
        sys.unraisablehook = told


def _abandon(_signal: int, _frame: FrameType | None) -> None:
    from surfcmp_core.report.outputs import drop_unfinished

    drop_unfinished()
    if sys.stderr.isatty():  # where a bar of progress may have hidden it
        os.write(sys.stderr.fileno(), _SHOW_CURSOR.encode())
    os._exit(INTERRUPTED)
