"""From a document to what the window shows; runs beside the window."""

import time
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from app.jobs.region_measures import (
    RegionMeasures,
    measured_regions,
    region_of,
    weighted,
    with_tolerances,
)
from app.model.document import NOT_MOVED, Document
from app.scene.borders import borders_of
from app.scene.content import Content, content_of
from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.surface import Surface
from surfcmp_core.system.progress import Progress

_ASKED = ("weight", "align", "project", "view", "reversed")
"""Options that the comparison itself does not know."""


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
    comparison, record = found or _compare(document, progress)
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
    return Compared(document, comparison, record, content, parts)


def _measured_anew(
    document: Document, before: Compared
) -> tuple[Comparison, dict[str, Any]] | None:
    """Return the comparison where nothing changed but tolerances and regions, else None."""
    old = before.document
    tolerances = document.options.tolerances
    options = replace(old.options, tolerances=tolerances)
    if replace(old, options=options, regions=document.regions) != document:
        return None
    if old.options == document.options:
        return before.comparison, before.record
    if document.options.exact:
        return None
    comparison = with_tolerances(before.comparison, tolerances)
    from surfcmp_core.report import make_document

    kept = before.record["options"]
    asked = {key: kept[key] for key in _ASKED if key in kept}
    return comparison, make_document(comparison, asked, before.record["alignment"])


def _compare(document: Document, progress: Progress) -> tuple[Comparison, dict[str, Any]]:
    """Compare by the very function of the command line, so that the numbers are the same."""
    from surfcmp_core.cli.pair import Settings, compare_surfaces

    one, two = document.paths
    assert one is not None
    assert two is not None
    options, motion = document.options, document.motion
    start = time.perf_counter()
    surfaces = _surface(one, document.unit), _surface(two, document.unit)
    seconds = time.perf_counter() - start
    with TemporaryDirectory(prefix="surfcmp-") as folder:
        align = "none"
        if motion != NOT_MOVED:
            align = str(Path(folder) / "motion.npy")
            np.save(align, np.array(motion.matrix))
        settings = Settings(
            domain=options.domain,
            max_edge=options.max_edge,
            exact=options.exact,
            tolerances=options.tolerances,
            duplicates=options.duplicates,
            unit=document.unit or None,
            weight=None,
            align=align,
            project=document.project,
            threads=options.threads,
        )
        comparison, record = compare_surfaces(surfaces, settings, progress, seconds)
    if motion != NOT_MOVED:
        record["options"]["align"] = {
            "method": motion.method,
            "residual": motion.residual,
            "inliers": motion.pairs,
            "matrix": [list(row) for row in motion.matrix],
        }
        from surfcmp_core.alignment import record_of_motion

        moved = record_of_motion(motion.method, np.array(motion.matrix)) | motion.fit
        doubts = tuple(moved["doubts"])
        comparison = replace(comparison, warnings=(*doubts, *comparison.warnings))
        record |= {"alignment": moved, "warnings": [*doubts, *record["warnings"]]}
    return comparison, record


def _surface(path: Path, unit: str) -> Surface:
    status = path.stat() if path.exists() else None
    stamp = (status.st_mtime_ns, status.st_size) if status else (0, 0)
    return read_once(path, stamp, unit)


@lru_cache(maxsize=2)
def read_once(path: Path, _stamp: tuple[int, int], unit: str) -> Surface:
    """Read a file once for as long as it does not change."""
    from surfcmp_core.cli.pair import read

    return read(path, unit or None)
