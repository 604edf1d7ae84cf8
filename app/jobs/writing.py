"""Writing results beside the window: complete or absent, as the command line writes them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO

from app.model.view_state import ViewState
from surfcmp_core.report.hidden import without_names
from surfcmp_core.report.outputs import WRITERS, check_outputs
from surfcmp_core.report.page import write_html
from surfcmp_core.report.pictures import write_pdf
from surfcmp_core.report.record import region_record
from surfcmp_core.system.whole_files import write_all

if TYPE_CHECKING:
    from app.jobs.comparing import Compared
    from surfcmp_core.report.page import Picture


def export(
    result: Compared,
    state: ViewState,
    paths: Sequence[Path],
    pictures: Sequence[Picture],
    hide_names: bool,
) -> str:
    """Write files, all or none; their endings say the formats. Return the names.

    Reports (.html, .pdf) also get the pictures of the views.

    Raises
    ------
    OutputError
        A file cannot be written; none is touched then.
    """
    check_outputs(paths, [file for file in result.document.paths if file])
    comparison, record = result.content.comparison, record_of(result, state)
    if hide_names:
        comparison, record = without_names(comparison, record)
    reports = {".html": write_html, ".pdf": write_pdf}

    def write(ending: str, stream: BinaryIO) -> None:
        if ending in reports:
            reports[ending](comparison, record, stream, pictures)
        else:
            WRITERS[ending](comparison, record, stream)

    write_all({path: partial(write, path.suffix.lower()) for path in paths})
    return ", ".join(str(path) for path in paths)


def record_of(result: Compared, state: ViewState) -> dict[str, Any]:
    """Return the .json result as the window shows it.

    Beside what the command line writes it has the keys "scale" and, where there are any,
    "regions"; ρ_V with the weight µ counts the regions' weights.
    """
    record = dict(result.record)
    record["measures"] = {
        **record["measures"],
        "rho_V_mu": result.content.comparison.measures.rho_V_mu,
    }
    record["scale"] = asdict(state.colours)
    if result.regions:
        record["regions"] = [
            region_record(
                None if part.region is None else part.region.name,
                None if part.region is None else part.region.colour,
                1.0 if part.region is None else part.region.weight,
                part.triangles,
                part.measures,
            )
            for part in result.regions
        ]
        shapes = [asdict(region)["strokes"] for region in result.document.regions]
        for part, strokes in zip(record["regions"], shapes, strict=False):
            part["strokes"] = strokes
    return record
