"""From a document to what the window shows; runs beside the window."""

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from app.model.document import Document
from app.scene.content import Content, content_of
from surfcmp_core.progress import Progress
from surfcmp_core.surface import Surface


@dataclass(frozen=True, slots=True, eq=False)
class Compared:
    """A document and what came of it."""

    document: Document
    content: Content


def compared(document: Document, progress: Progress) -> Compared:
    """Read both files, compare them and prepare the picture.

    Raises
    ------
    InputError
        If a file cannot be read or the surfaces cannot be compared.
    Cancelled
        If `progress` says so.
    """
    progress("read", 0.0)
    from surfcmp_core import compare  # the core's kernels load beside the window

    one, two = document.paths
    assert one is not None
    assert two is not None
    options = document.options
    surfaces = [_surface(path, progress) for path in (one, two)]
    comparison = compare(
        surfaces[0],
        surfaces[1],
        domain=options.domain,
        max_edge=options.max_edge,
        exact=options.exact,
        tolerances=options.tolerances,
        duplicates=options.duplicates,
        threads=options.threads,
        progress=progress,
    )
    progress("picture", 1.0)
    return Compared(document, content_of(comparison))


def _surface(path: Path, progress: Progress) -> Surface:
    progress("read", 0.0)
    status = path.stat() if path.exists() else None
    stamp = (status.st_mtime_ns, status.st_size) if status else (0, 0)
    return _read(path, stamp)


@lru_cache(maxsize=2)
def _read(path: Path, _stamp: tuple[int, int]) -> Surface:
    """Read a file once for as long as it does not change."""
    from surfcmp_core import read_surface

    return read_surface(path)
