"""Processes killed at random moments of writing: what is there afterwards is whole."""

import os
import random
import signal
import sys
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

KILLS = 50


def kill_at_random(
    folder: Path,
    save: Callable[[int], None],
    is_whole: Callable[[], bool],
    seed: int,
    kills: int = KILLS,
) -> None:
    """Save in processes that are killed, and see after each that what lies there is whole.

    Every second one is killed at any moment, the others just after they have begun to write.

    Parameters
    ----------
    folder
        Into which all is saved; nothing else is in it.
    save
        Saves something, each number another thing, under the same names.
    is_whole
        Opens what was saved last.
    """
    print(f"seed {seed}", flush=True)
    moments = random.Random(seed)
    save(0)  # from here on all is loaded, and a forked process begins to write at once
    for thread in threading.enumerate():  # such as wait for compiling: a fork would stop them
        if thread is not threading.current_thread():
            thread.join()
    begin = time.perf_counter()
    save(1)
    lasts = time.perf_counter() - begin
    names = found = set(os.listdir(folder))
    littered = 0
    for number in range(2, 2 + kills):
        child = os.fork()
        if child == 0:
            save(number)
            os._exit(0)
        if number % 2:
            end = time.monotonic() + 2.0 * lasts
            while not _writes(folder, found) and time.monotonic() < end:
                time.sleep(1e-4)  # the processor is the child's
            time.sleep(0.002 * moments.random())
        else:
            time.sleep(lasts * moments.random())
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        found = set(os.listdir(folder))
        assert found >= names
        strange = found - names
        assert all(name.startswith(".") and name.endswith(".part") for name in strange), strange
        littered += bool(strange)
        assert is_whole(), f"kill {number}"
    save(2 + kills)
    assert set(os.listdir(folder)) == names  # the next run has cleaned up
    assert is_whole()
    assert littered > kills // 10, "killed when nothing was being written"
    print(f"{kills} kills, {littered} of them while a file was being written")


def _writes(folder: Path, known: set[str]) -> bool:
    """Whether something stands in another file than those known."""
    with suppress(FileNotFoundError):  # moved meanwhile
        return any(one.name not in known and one.stat().st_size for one in os.scandir(folder))
    return False


def seed_of(arguments: list[str]) -> int:
    """Take the seed that was asked for, else a new one."""
    return int(arguments[0]) if arguments else random.SystemRandom().randrange(1 << 32)


def is_killable() -> bool:
    return hasattr(os, "fork") and sys.platform != "win32"
