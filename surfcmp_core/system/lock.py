"""Files that belong to a process as long as it lives, however it ends.

The system itself lets go of such a lock when its process is gone; numbers of processes tell less,
for they are given anew, and mean nothing on another machine or in another container.
"""

import os
import sys
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO

if sys.platform == "win32":
    import msvcrt
else:
    import fcntl


def make_held(path: Path) -> BinaryIO:
    """Make a file and hold it until the stream is closed.

    Where the file system knows no locks the file is made all the same, and nobody takes it over.

    Raises
    ------
    OSError
        The file is there, or cannot be made.
    """
    while True:
        stream = path.open("x+b")
        with suppress(OSError):
            _lock(stream, wait=True)
        if _is_at(stream, path):
            return stream
        stream.close()  # taken over before it was held


def take_over(path: Path) -> BinaryIO | None:
    """Hold a file whose process has ended; None where it has not, or where nobody can tell."""
    try:
        stream = path.open("r+b")
    except OSError:
        return None
    with suppress(OSError):
        _lock(stream, wait=False)
        if _is_at(stream, path):
            return stream
    stream.close()
    return None


def drop(stream: BinaryIO, path: Path) -> None:
    """Remove a held file.

    Raises
    ------
    OSError
        It cannot be removed.
    """
    if sys.platform == "win32":  # which removes no open file
        stream.close()
    with stream:
        path.unlink(missing_ok=True)


def _lock(stream: BinaryIO, *, wait: bool) -> None:
    if sys.platform == "win32":
        msvcrt.locking(stream.fileno(), msvcrt.LK_LOCK if wait else msvcrt.LK_NBLCK, 1)
    else:
        fcntl.flock(stream, fcntl.LOCK_EX if wait else fcntl.LOCK_EX | fcntl.LOCK_NB)


def _is_at(stream: BinaryIO, path: Path) -> bool:
    """Whether a file still has its name."""
    try:
        return os.path.samestat(os.fstat(stream.fileno()), path.stat())
    except FileNotFoundError:
        return False
