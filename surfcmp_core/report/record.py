"""The .json result as a dictionary; every other report is made from it."""

import math
from collections.abc import Mapping
from dataclasses import asdict, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import surfcmp_core
from surfcmp_core.comparing.clock import STAGES
from surfcmp_core.comparing.comparison import Comparison, MeshFaces
from surfcmp_core.comparing.options import NOT_MOVED, Motion
from surfcmp_core.grid import Grid
from surfcmp_core.measures import Measures
from surfcmp_core.names import one_line
from surfcmp_core.surface import Surface
from surfcmp_core.surface.together import ASSUMED

Record = dict[str, Any]
"""The .json result."""


def program() -> Record:
    """Name and version of the program, as in every .json document."""
    return {"name": "surfcmp", "version": surfcmp_core.__version__}


def now() -> str:
    """Return the present moment, UTC, ISO 8601."""
    return datetime.now(UTC).isoformat(timespec="seconds").replace("+00:00", "Z")


def unit_of(comparison: Comparison) -> str:
    """Length unit of the numbers."""
    return comparison.surfaces[0].unit or ASSUMED


def make_record(comparison: Comparison) -> Record:
    """Describe a comparison as schema 1 of the .json result.

    Returns
    -------
    dict
        Strict JSON: numbers that are not finite have become None.
    """
    record: Record = _strict(
        {
            "schema": 1,
            "program": program(),
            "created": now(),
            "inputs": [
                _input(surface, grid, faces)
                for surface, grid, faces in zip(
                    comparison.surfaces, comparison.grids, comparison.faces, strict=True
                )
            ],
            "options": _options(comparison),
            "transform": _from_file(comparison).tolist(),
            "alignment": comparison.alignment,
            "counts": comparison.counts,
            "measures": _measures(comparison.measures),
            "seconds": {stage: comparison.seconds.get(stage, 0.0) for stage in (*STAGES, "total")},
            "warnings": list(comparison.warnings),
        }
    )
    return record


def _options(comparison: Comparison) -> Record:
    options = comparison.options
    limit, weight = options.max_edge, options.weight
    told = {
        "domain": options.domain,
        "max_edge": limit,
        "exact": options.exact,
        "tolerances": options.tolerances,
        "duplicates": options.duplicates,
        "threads": options.threads,
        "max_edge_derived": limit is None and min(comparison.max_edges) < math.inf,
        "max_edge_used": list(comparison.max_edges),
        "unit": unit_of(comparison),
        "weight": str(weight) if isinstance(weight, Path) else weight and "a function",
        "align": _align(options.align, comparison.alignment),
        "project": options.project,
        "no_data": options.no_data,
    }
    if comparison.reversed is not None:
        told["view"] = comparison.frame[2, :3].tolist()
        told["reversed"] = list(comparison.reversed)
    return told


def _align(align: Motion | Path | str, found: Mapping[str, Any]) -> Any:
    """Return how surface 2 was moved as it stands among the options."""
    if align == NOT_MOVED:
        return "none"
    if isinstance(align, Path):
        return {"method": "file", "file": str(align), "matrix": found["matrix"]}
    if isinstance(align, Motion):
        return {
            "method": align.method,
            "residual": align.residual,
            "inliers": align.pairs,
            "matrix": align.matrix,
        }
    names = {"residual": "rms_kept", "inliers": "pairs_kept", "iterations": "rounds"}
    same = {key: found[key] for key in ("method", "matrix", "overlap", "converged")}
    return same | {name: found[key] for name, key in names.items()}


def region_record(
    name: str | None,
    colour: tuple[int, int, int] | None,
    weight: float,
    triangles: int,
    measures: Measures | None,
) -> Record:
    """Describe one region, for the key "regions"; without a name: all that lies in none."""
    record: Record = _strict(
        {
            "name": name,
            "colour": colour,
            "weight": weight,
            "triangles": triangles,
            "measures": None if measures is None else _measures(measures),
        }
    )
    return record


def _from_file(comparison: Comparison) -> NDArray[np.float64]:
    """(4, 4) from the coordinates in the file of surface 2 to the comparison's."""
    told = comparison.surfaces[1].from_file  # only its diagonal
    return comparison.transform * np.diagonal(told)


def _measures(measures: Measures) -> Record:
    """Every measure by its key; the exact reading's under "exact", where there is one."""
    record = asdict(replace(measures, exact=None))
    del record["exact"]
    if measures.exact is not None:
        record["exact"] = _measures(measures.exact)
    return record


def _input(surface: Surface, grid: Grid, faces: MeshFaces | None) -> Record:
    dropped = {**surface.dropped, **({"merged": grid.merged} if grid.merged else {})}
    return {
        "file": str(surface.path or surface.name),
        "sha256": surface.sha256,
        "kind": surface.kind,
        "nodes": len(grid.nodes) + sum(dropped.values()),
        "triangles": 0 if surface.faces is None else len(surface.faces),
        "dropped": dropped,
        **({} if faces is None else {"faces": asdict(faces)}),
    }


def _strict(value: Any) -> Any:
    """Replace what JSON has no word for: NaN, infinity, tuples, bytes that are no text."""
    if isinstance(value, Mapping):
        return {one_line(str(key)): _strict(inner) for key, inner in value.items()}
    if isinstance(value, list | tuple):
        return [_strict(inner) for inner in value]
    if isinstance(value, np.generic):
        return _strict(value.item())
    if isinstance(value, float):
        return float(value) if math.isfinite(value) else None
    return one_line(value) if isinstance(value, str) else value
