"""Ctrl-C, a polite kill and a closed terminal end the program soon, wherever they meet it."""

import os
import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from surfcmp_core.cli.statuses import INTERRUPTED
from surfcmp_core.system.children import end_children
from surfcmp_core.system.whole_files import drop_unfinished

PATIENCE = 0.3
"""Seconds that what was begun has for ending itself; a kernel, say, takes longer."""

_SHOW_CURSOR = "\x1b[?25h"


@contextmanager
def stopping_soon() -> Iterator[None]:
    """Let SIGINT, SIGTERM and SIGHUP unwind the block; end the process where that takes too long.

    The second signal does not wait. Either way no output is left half-written and no child at
    work. Signals that are ignored (`nohup`, a script's background) stay so.

    Python hears a signal only between two of its own instructions, which a kernel is not; so a
    thread hears them too, from the pipe into which Python's handler in C writes their numbers.
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
    reader, writer = os.pipe()
    os.set_blocking(writer, False)
    watching = threading.Thread(target=_watch, args=(reader, {*before}), daemon=True)

    def stop(_signal: int, _frame: FrameType | None) -> None:
        sys.unraisablehook = lambda _fault: None  # destructors of what is only half made
        for one in before:
            signal.signal(one, lambda _signal, _frame: None)  # the thread hears the next
        end_children()
        raise KeyboardInterrupt

    pipe_before = signal.set_wakeup_fd(writer, warn_on_full_buffer=False)
    try:
        watching.start()
        for one in before:
            signal.signal(one, stop)
        yield
    finally:
        for one, handler in before.items():
            signal.signal(one, handler)
        signal.set_wakeup_fd(pipe_before)
        os.close(writer)
        watching.join()
        os.close(reader)
        sys.unraisablehook = told


def _watch(reader: int, signals: set[int]) -> None:
    """Begin to wait at the first of these signals, and do not wait longer at the second."""
    waiting = threading.Timer(PATIENCE, _abandon)
    waiting.daemon = True
    heard = 0
    while number := os.read(reader, 1):
        heard += number[0] in signals
        if heard == 1 and not waiting.is_alive():
            waiting.start()
        elif heard > 1:
            _abandon()
    waiting.cancel()


def _abandon() -> None:
    end_children()
    drop_unfinished()
    if sys.stderr.isatty():  # where a bar of progress may have hidden it
        os.write(sys.stderr.fileno(), _SHOW_CURSOR.encode())
    os._exit(INTERRUPTED)
