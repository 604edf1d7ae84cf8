"""Reads hostile files and tells what became of each.

``python -m tests.program.hostile_reading FOLDER PART PARTS``: one line of JSON for each file,
ahead of it one with its name, so that a file that ends the process is known.
"""

import contextlib
import io
import json
import resource
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np

from tests.program.hostile_files import hostile

MEMORY = 2 << 30
"""Octets above the start at which the system refuses more."""


def _read(path: Path) -> dict[str, Any]:
    """Read as the library does, and where it refuses once more as the program does."""
    from app.__main__ import main
    from surfcmp_core.errors import InputError
    from surfcmp_core.io import read_surface

    spoken, warned = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(spoken), contextlib.redirect_stderr(warned):
        begin = time.process_time()  # of all threads; wall time on a busy machine tells little
        try:
            surface = read_surface(path)
        except InputError as error:
            fault = str(error)
        else:
            seconds = time.process_time() - begin
            used = surface.points if surface.faces is None else surface.points[surface.faces]
            sound = bool(np.isfinite(used).all()) and len(surface.points) >= 3
            silent = not (spoken.getvalue() + warned.getvalue())
            return {"outcome": "read", "seconds": seconds, "sound": sound and silent}
        seconds = time.process_time() - begin
        status = main(["info", str(path)])
    lines = warned.getvalue().splitlines()
    told = len(lines) == 1 and path.name in lines[0] and lines[0].isprintable()
    alike = fault.startswith(f"{path}: ") and fault.isprintable() and len(fault) < 500
    sound = status == 3 and told and alike and not spoken.getvalue()
    said = [line[:500] for line in lines[:3]]
    return {"outcome": "refused", "seconds": seconds, "sound": sound, "said": said}


def _peak() -> int:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


def main(folder: Path, part: int, parts: int) -> None:
    """Read every so manieth file; the peak of memory is that of all before, too."""
    import laspy  # noqa: F401 - its memory is not the files'
    import mapbox_earcut  # noqa: F401

    import app.__main__  # noqa: F401
    import surfcmp_core.cli.info  # noqa: F401

    marker = folder / "armed"
    used = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (used + MEMORY, used + MEMORY))
    for k, (name, ending, made) in enumerate(hostile(marker)):
        if k % parts != part:
            continue
        print(json.dumps({"name": name}), flush=True)
        path = folder / f"scan_{k}.{ending}"
        content = made()
        path.write_bytes(content)
        size = len(content)
        del content
        before = _peak()
        result = _read(path)
        path.unlink()
        result |= {"name": name, "size": size, "octets": _peak() - before}
        print(json.dumps({**result, "ran": marker.exists()}), flush=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]))
