"""Where results go: every output is checked before the work and complete or absent after it."""

import os
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import BinaryIO

from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.names import one_line
from surfcmp_core.report.data_files import write_csv, write_json, write_npz
from surfcmp_core.report.mesh_files import write_ply, write_vtp
from surfcmp_core.report.page import write_html
from surfcmp_core.report.pictures import write_pdf, write_png
from surfcmp_core.report.record import Record
from surfcmp_core.system.whole_files import OutputError, beside, reason, write_all

Writer = Callable[[Comparison, Record, BinaryIO], None]

WRITERS: dict[str, Writer] = {
    ".json": write_json,
    ".npz": write_npz,
    ".csv": write_csv,
    ".vtp": write_vtp,
    ".ply": write_ply,
    ".html": write_html,
    ".pdf": write_pdf,
    ".png": write_png,
}
"""The formats of results, by the ending of the file's name."""


def check_outputs(
    paths: Iterable[Path], inputs: Iterable[Path], endings: Iterable[str] = tuple(WRITERS)
) -> None:
    """Find out before the work whether its results can be written.

    Raises
    ------
    OutputError
        Unknown ending, folder absent or not writable, file named twice, or one of the inputs.
    """
    known = tuple(endings)
    used = {os.path.realpath(path) for path in inputs}
    seen: set[str] = set()
    for path in paths:
        name, target = one_line(path), os.path.realpath(path)
        if path.suffix.lower() not in known:
            raise OutputError(f"{name}: unknown ending; known are {' '.join(known)}")
        if target in used or any(_same(target, other) for other in used):
            raise OutputError(f"{name}: is an input and will not be overwritten")
        if target in seen:
            raise OutputError(f"{name}: named twice")
        seen.add(target)
        if os.path.isdir(target):
            raise OutputError(f"{name}: is a folder")
        if os.path.exists(target) and not os.access(target, os.W_OK):
            raise OutputError(f"{name}: is read-only")
        probe = beside(Path(target))
        try:
            probe.open("xb").close()
            probe.unlink(missing_ok=True)
        except OSError as fault:
            raise OutputError(f"{name}: {reason(fault)}") from fault


def write_outputs(comparison: Comparison, document: Record, paths: Iterable[Path]) -> None:
    """Write a comparison to files; the endings say the formats.

    Raises
    ------
    OutputError
        A file cannot be written; then none of them has been touched.
    """
    write_all(
        {
            path: lambda stream, path=path: WRITERS[path.suffix.lower()](  # type: ignore[misc]
                comparison, document, stream
            )
            for path in paths
        }
    )


def _same(one: str, other: str) -> bool:
    return os.path.exists(one) and os.path.exists(other) and os.path.samefile(one, other)
