"""From a document to what the window shows; runs beside the window."""

import time
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any

from app.jobs.region_measures import (
    RegionMeasures,
    measured_regions,
    region_of,
    weighted,
    with_tolerances,
)
from app.model.document import Document
from app.scene.borders import borders_of
from app.scene.content import Content, content_of
from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.comparing.options import Options
from surfcmp_core.comparing.request import compare_surfaces
from surfcmp_core.io import read_surface
from surfcmp_core.report import make_record
from surfcmp_core.surface import Surface
from surfcmp_core.system.progress import Progress


@dataclass(frozen=True, slots=True, eq=False)
class Compared:
    """A document and what came of it.

    Attributes
    ----------
    comparison : Comparison
        As the command line gives it, before any region's weight µ.
    record : dict
        The .json result.
    regions : tuple of RegionMeasures
        Of each region, and of the rest last; empty without regions.
    """

    document: Document
    comparison: Comparison
    record: dict[str, Any]
    content: Content
    regions: tuple[RegionMeasures, ...]


def compared(document: Document, before: Compared | None, progress: Progress) -> Compared:
    """Do what changed since `before`: everything, or only the measures.

    Raises
    ------
    InputError
        If a file cannot be read or the surfaces cannot be compared.
    Cancelled
        If `progress` says so.
    """
    progress("read", 0.0)
    found = None if before is None else _measured_anew(document, before)
    comparison = found or _compare(document, progress)
    progress("picture", 0.98)
    regions = document.regions
    number = region_of(comparison, regions)
    shown = weighted(comparison, regions, number)
    colours = [region.colour for region in regions]
    if before is not None and found is not None:
        borders = borders_of(comparison.united.triangles, number, colours) if regions else ()
        content = replace(before.content, comparison=shown, borders=borders)
    else:
        content = content_of(shown, region=number if regions else None, colours=colours)
    parts = measured_regions(comparison, regions, number)
    return Compared(document, comparison, make_record(comparison), content, parts)


def _measured_anew(document: Document, before: Compared) -> Comparison | None:
    """Return the comparison where nothing changed but tolerances and regions, else None."""
    if not document.same_places(before.document):
        return None
    if document.options == before.document.options:
        return before.comparison
    if document.options.exact:
        return None
    return with_tolerances(before.comparison, document.options.tolerances)


def _compare(document: Document, progress: Progress) -> Comparison:
    """Compare as the command line does, so that the numbers are the same."""
    one, two = document.paths
    assert one is not None
    assert two is not None
    options = document.options
    start = time.perf_counter()
    surfaces = _surface(one, options), _surface(two, options)
    seconds = time.perf_counter() - start
    return compare_surfaces(*surfaces, options, progress, seconds)


def _surface(path: Path, options: Options) -> Surface:
    status = path.stat() if path.exists() else None
    stamp = (status.st_mtime_ns, status.st_size) if status else (0, 0)
    return read_once(path, stamp, options.unit, options.no_data)


@lru_cache(maxsize=2)
def read_once(
    path: Path, _stamp: tuple[int, int], unit: str | None, no_data: tuple[float, ...] = ()
) -> Surface:
    """Read a file once for as long as it does not change."""
    return read_surface(path, unit=unit, no_data=no_data)
