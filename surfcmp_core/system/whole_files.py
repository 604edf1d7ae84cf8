"""Files that are written completely or not at all, whatever happens meanwhile."""

import os
import secrets
import sys
import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO

from surfcmp_core.errors import SurfcmpError
from surfcmp_core.names import one_line
from surfcmp_core.system.lock import drop, make_held, take_over

_unfinished: set[Path] = set()
"""Files that are being written beside their places."""


class OutputError(SurfcmpError):
    """A result cannot be written; the message names the file and the fault."""


def write_all(contents: Mapping[Path, Callable[[BinaryIO], None]]) -> None:
    """Write files beside their places, then move all there at once.

    What a process that was killed has left beside them is removed.

    Raises
    ------
    OutputError
        A file cannot be written; then none of them has been touched.
    """
    places = {path: Path(os.path.realpath(path)) for path in contents}
    staged = {path: beside(target) for path, target in places.items()}
    streams: dict[Path, BinaryIO] = {}
    aside: dict[Path, Path] = {}
    path = Path()
    try:
        for folder in {target.parent for target in places.values()}:
            _remove_what_is_left(folder)
        for path, write in contents.items():
            _unfinished.add(staged[path])
            streams[path] = make_held(staged[path])
            write(streams[path])
            streams[path].flush()
            os.fsync(streams[path].fileno())  # else a power cut leaves a name without contents
        if sys.platform == "win32":  # which moves no open file
            for stream in streams.values():
                stream.close()
        for path, target in places.items():
            if target.is_dir():
                raise OutputError(f"{one_line(path)}: is a folder")
        for path, target in places.items():
            _keep_aside(target, aside)
            os.replace(staged[path], target)
    except BaseException as fault:
        _put_back(aside)
        if (first := _of_the_disk(fault)) is None:
            raise
        raise OutputError(f"{one_line(path)}: {reason(first)}") from fault
    finally:
        for stream in streams.values():
            with suppress(OSError):  # what could not be written cannot be flushed either
                stream.close()
        for temporary in (*staged.values(), *aside.values()):
            with suppress(OSError):  # its folder has vanished, or may be written no more
                temporary.unlink(missing_ok=True)
            _unfinished.discard(temporary)


def drop_unfinished() -> None:
    """Remove what is being written, where the process ends without unwinding."""
    for temporary in list(_unfinished):
        temporary.unlink(missing_ok=True)


def _of_the_disk(fault: BaseException | None) -> OSError | None:
    """Give what the disk said, of which a library may make another fault while it tidies up."""
    while fault is not None and not isinstance(fault, OSError):
        fault = fault.__cause__ or fault.__context__
    return fault


def _keep_aside(target: Path, aside: dict[Path, Path]) -> None:
    """Give the old file a second name, from which it comes back if a later one cannot be moved."""
    aside[target] = beside(target)
    with suppress(OSError):  # there is none, or the disk knows no second names
        os.link(target, aside[target])
        _unfinished.add(aside[target])


def _put_back(aside: Mapping[Path, Path]) -> None:
    for target, old in aside.items():
        with suppress(OSError):
            if old.exists():
                os.replace(old, target)


def beside(target: Path) -> Path:
    """Name a file that is to be moved to the target."""
    return target.with_name(f".surfcmp-{secrets.token_hex(6)}.part")


def reason(fault: OSError) -> str:
    """Say why a file cannot be written."""
    if isinstance(fault, FileNotFoundError | NotADirectoryError):
        return "its folder does not exist"
    return f"cannot be written ({fault.strerror or fault})"


def _remove_what_is_left(folder: Path) -> None:
    for path in folder.glob(".surfcmp-*.part"):
        with suppress(OSError):
            # Windows: nobody holds a file at the moment when it is moved
            if sys.platform == "win32" and time.time() - path.stat().st_mtime < 3600.0:
                continue
            if (held := take_over(path)) is not None:
                drop(held, path)
