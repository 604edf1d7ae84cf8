"""Writing results beside the window: complete or absent, as the command line writes them."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from dataclasses import replace
from html import escape
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO

if TYPE_CHECKING:
    from app.jobs.comparing import Compared
    from app.jobs.regions import RegionMeasures
    from surfcmp_core.comparison import Comparison

Picture = tuple[str, bytes]
"""A caption, and a PNG file's bytes."""


def export(result: Compared, path: Path, pictures: Sequence[Picture], hide_names: bool) -> Path:
    """Write one file; its ending says the format.

    A page (.html) also gets the pictures of the views and the regions.

    Raises
    ------
    OutputError
        The file cannot be written; it is untouched then.
    """
    from surfcmp_core.report.outputs import WRITERS, check_outputs, write_all

    check_outputs([path], [file for file in result.document.paths if file])
    comparison, record = result.content.comparison, result.record
    if hide_names:
        comparison, record = without_names(comparison, record)
    writer = WRITERS[path.suffix.lower()]

    def write(stream: BinaryIO) -> None:
        if path.suffix.lower() != ".html":
            writer(comparison, record, stream)
            return
        page = BytesIO()
        writer(comparison, record, page)
        more = views_section(pictures) + regions_section(result.regions, record)
        stream.write(with_section(page.getvalue().decode(), more).encode())

    write_all({path: write})
    return path


def without_names(
    comparison: Comparison, record: dict[str, Any]
) -> tuple[Comparison, dict[str, Any]]:
    """Return both with the files' names and paths replaced; the hashes stay."""
    names = [surface.name for surface in comparison.surfaces]
    one, two = (
        replace(surface, name=f"surface {k}", path=None)
        for k, surface in enumerate(comparison.surfaces, 1)
    )

    def hidden(text: str) -> str:
        for k, name in enumerate(names, 1):
            text = text.replace(name, f"surface {k}")
        return text

    inputs = [{**given, "file": f"surface {k}"} for k, given in enumerate(record["inputs"], 1)]
    warnings = tuple(hidden(text) for text in comparison.warnings)
    comparison = replace(comparison, surfaces=(one, two), warnings=warnings)
    return comparison, {**record, "inputs": inputs, "warnings": list(warnings)}


def views_section(pictures: Sequence[Picture]) -> str:
    """Return the part of the page with the views as they were on the screen."""
    if not pictures:
        return ""
    figures = "".join(
        f'<figure><img alt="{escape(name)}" src="data:image/png;base64,'
        f'{base64.b64encode(data).decode("ascii")}"><figcaption><b>{escape(name)}</b>'
        "</figcaption></figure>"
        for name, data in pictures
    )
    return f'<section><h2>The views</h2><div class="pair">{figures}</div></section>'


def regions_section(regions: Sequence[RegionMeasures], record: dict[str, Any]) -> str:
    """Return the part of the page with the regions' measures."""
    if not regions:
        return ""
    from surfcmp_core.report.numbers import with_unit

    unit = str(record["options"]["unit"])
    columns = (("area_compared", 2), ("mean_abs", 1), ("mean_signed", 1), ("rms", 1), ("p95", 1))
    head = "".join(f"<th>{key}</th>" for key in ("region", "µ", *(key for key, _ in columns)))
    rows = []
    for found in regions:
        name = escape(found.region.name) if found.region else "the rest"
        weight = f"{found.region.weight:g}" if found.region else "1"
        cells = [
            " ".join(with_unit(getattr(found.measures, key) if found.measures else None, p, unit))
            for key, p in columns
        ]
        numbers = "".join(f'<td class="number">{cell}</td>' for cell in (weight, *cells))
        rows.append(f'<tr><th scope="row">{name}</th>{numbers}</tr>')
    return f"<section><h2>Regions</h2><table><tr>{head}</tr>{''.join(rows)}</table></section>"


def with_section(page: str, section: str) -> str:
    """Return the page with a section before its measures."""
    head, mark, tail = page.partition("<section><h2>Measures</h2>")
    return head + section + mark + tail
