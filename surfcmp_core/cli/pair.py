"""One pair of files, compared as the options say."""

import math
import time
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.cli.ends import WrongUsage
from surfcmp_core.comparing.comparison import Comparison, Domain
from surfcmp_core.comparing.memory_needed import check_comparison
from surfcmp_core.errors import InputError
from surfcmp_core.grid import Duplicates
from surfcmp_core.report import make_document
from surfcmp_core.report.record import Document
from surfcmp_core.surface import Surface
from surfcmp_core.surface.together import bring_together, carried
from surfcmp_core.surface.used import used_part
from surfcmp_core.system.progress import Progress

if TYPE_CHECKING:
    from surfcmp_core.alignment import Record
    from surfcmp_core.projection.placement import View


@dataclass(frozen=True, slots=True)
class Settings:
    """The options of the command line that change the numbers."""

    domain: Domain
    max_edge: float | None
    exact: bool
    tolerances: tuple[float, ...]
    duplicates: Duplicates
    unit: str | None
    weight: Path | None
    align: str
    project: str
    threads: int
    no_data: tuple[float, ...] = ()
    verify: bool = False

    def check(self) -> None:
        """Refuse what no input could make right.

        Raises
        ------
        WrongUsage
            One line that names the option.
        """
        if self.max_edge is not None and not self.max_edge > 0:
            raise WrongUsage("--max-edge: must be above zero (inf: no limit)")
        for tolerance in self.tolerances:
            if not 0 <= tolerance < float("inf"):
                raise WrongUsage("--tolerance: must be a number, zero or above")
        if self.project not in {"auto", "z"}:
            view_of(self.project)


def view_of(project: str) -> tuple[float, float, float]:
    """Return the direction of ``view:X,Y,Z``, or raise `WrongUsage`."""
    try:
        kind, numbers = project.split(":")
        x, y, z = (float(number) for number in numbers.split(","))
    except ValueError:
        kind, x, y, z = "", 0.0, 0.0, 0.0
    if kind != "view" or not 0 < math.sqrt(x * x + y * y + z * z) < float("inf"):
        raise WrongUsage(f"--project {project}: not auto, z or view:X,Y,Z")
    return x, y, z


def read(path: Path, unit: str | None, no_data: tuple[float, ...] = ()) -> Surface:
    """Read one surface; `unit` is that of its coordinates, whatever the file says."""
    from surfcmp_core.io import read_surface

    return read_surface(path, unit=unit, no_data=no_data)


def compare_files(
    paths: tuple[Path, Path], settings: Settings, progress: Progress
) -> tuple[Comparison, Document]:
    """Read two files, compare them and describe the result.

    Raises
    ------
    InputError
        One line that names the file and the fault.
    """
    start = time.perf_counter()
    progress("read", 0.0)
    first, second = (read(path, settings.unit, settings.no_data) for path in paths)
    seconds = time.perf_counter() - start
    return compare_surfaces((first, second), settings, progress, seconds)


def compare_surfaces(
    surfaces: tuple[Surface, Surface], settings: Settings, progress: Progress, read_seconds: float
) -> tuple[Comparison, Document]:
    """Compare two surfaces that were read, and describe the result.

    Raises
    ------
    InputError
        One line that names a file and the fault.
    """
    from surfcmp_core.comparing.pipeline import compare
    from surfcmp_core.comparing.weight import read_weight

    check_comparison(*surfaces, settings.exact)  # before they are moved and projected
    together = bring_together(used_part(surfaces[0]), used_part(surfaces[1]))
    surfaces, warnings = together.surfaces, together.warnings
    motion, alignment = _alignment(surfaces, settings.align, progress)
    warnings += tuple(f"--align icp: {doubt}" for doubt in alignment["doubts"])
    asked = {
        "weight": None if settings.weight is None else str(settings.weight),
        "align": _option(settings.align, alignment),
        "project": settings.project,
        "no_data": list(settings.no_data),
    }
    placement = None
    if settings.project != "z":
        from surfcmp_core.projection.placement import place

        view: View = "auto"
        if settings.project != "auto":
            x, y, z = view_of(settings.project)
            view = (-x, -y, z) if surfaces[0].turned else (x, y, z)
        placement = place(*surfaces, view, motion)
        warnings += placement.warnings
        asked["view"] = placement.motions[0][2, :3].tolist()
        asked["reversed"] = [removed.reversed for removed in placement.removed]

    weight = read_weight(settings.weight, settings.duplicates) if settings.weight else None
    try:
        comparison = compare(
            *(placement.surfaces if placement else surfaces),
            domain=settings.domain,
            max_edge=settings.max_edge,
            exact=settings.exact,
            tolerances=settings.tolerances,
            weight=weight,
            duplicates=settings.duplicates,
            threads=settings.threads,
            verify=settings.verify,
            align=None if placement else motion,
            progress=progress,
            read_seconds=read_seconds,
        )
    except InputError as fault:
        told = str(fault)
        if not any(one.name in told for one in surfaces):
            files = " and ".join(str(one.path or one.name) for one in surfaces)
            told = f"{files}: {told}"
        suspects = [
            f"{one.name} has {count} {note}"
            for one in surfaces
            for note, count in one.changed.items()
            if "--no-data" in note
        ]
        raise InputError("; ".join((told, *suspects))) from None
    if placement:
        first, second = (
            replace(surface, dropped=part.dropped)
            for surface, part in zip(surfaces, placement.surfaces, strict=True)
        )
        comparison = replace(
            comparison,
            surfaces=(first, second),
            frame=placement.motions[0],
            transform=placement.motions[1],
        )
    comparison = replace(comparison, warnings=(*warnings, *comparison.warnings))
    return comparison, make_document(comparison, asked, alignment)


def _alignment(
    surfaces: tuple[Surface, Surface], align: str, progress: Progress
) -> tuple[NDArray[np.float64] | None, "Record"]:
    """Return the matrix that moves surface 2 (None: none), and the record of how it was found.

    A matrix of a file is in the unit and the axes of surface 1's file, and so is what is told of
    it; what is returned is in those of the comparison.
    """
    from surfcmp_core.alignment import best_fit, record_of_motion

    if align == "none":
        return None, record_of_motion("none", np.eye(4))
    if align == "icp":
        found = best_fit(*surfaces, progress=progress)
        return found.matrix, found.record()
    from surfcmp_core.io.motion import read_motion

    matrix = read_motion(Path(align))
    told = record_of_motion("file", matrix)
    return carried(matrix, surfaces[0].scale, surfaces[0].turned), told


def _option(align: str, alignment: "Record") -> Any:
    """Return the option as it stands among the others."""
    if align == "none":
        return "none"
    if align == "icp":
        names = {"residual": "rms_kept", "inliers": "pairs_kept", "iterations": "rounds"}
        same = {key: alignment[key] for key in ("method", "matrix", "overlap", "converged")}
        return same | {name: alignment[key] for name, key in names.items()}
    return {"method": "file", "file": align, "matrix": alignment["matrix"]}
