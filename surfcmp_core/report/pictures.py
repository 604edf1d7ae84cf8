"""The results made to be looked at on paper: .png and .pdf."""

from typing import TYPE_CHECKING, Any, BinaryIO

from surfcmp_core.comparison import Comparison
from surfcmp_core.report.document import Document
from surfcmp_core.report.figures import (
    MAP_MARGINS,
    QUIET,
    any_script,
    draw_histogram,
    draw_map,
    heatmap,
    map_size,
    save,
    sheet,
    title,
)
from surfcmp_core.report.meanings import NOTES, lines
from surfcmp_core.report.numbers import with_unit
from surfcmp_core.report.provenance import (
    DISCLAIMER,
    Rows,
    count_rows,
    input_rows,
    key_figures,
    option_rows,
    transform_text,
    versions,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_WIDTH, _HEIGHT = 8.27, 11.69  # A4, inches
_LEFT, _TOP, _BOTTOM = 0.8, 0.8, 0.9
_MONO = {"family": "monospace", "fontsize": 7.0}


def write_png(comparison: Comparison, document: Document, stream: BinaryIO) -> None:
    """Write the .png result: the heatmap with its scale, files and main numbers."""
    save(heatmap(comparison, document), stream, "png")


def write_pdf(comparison: Comparison, document: Document, stream: BinaryIO) -> None:
    """Write the .pdf result: the heatmap, the measures, and where they come from."""
    from matplotlib.backends.backend_pdf import PdfPages

    pages = [_map(comparison, document), _measures(comparison, document), _origin(document)]
    with PdfPages(stream, metadata={"Title": title(document), "Creator": "surfcmp"}) as pdf:
        for number, page in enumerate(pages, 1):
            _foot(page, document, f"{number} / {len(pages)}")
            with any_script():
                pdf.savefig(page, dpi=300)


def _map(comparison: Comparison, document: Document) -> "Figure":
    page = sheet(_WIDTH, _HEIGHT)
    _write(page, _LEFT, _TOP, title(document), fontsize=15, fontweight="bold")
    unit = document["options"]["unit"]
    text = f"Comparison of two surfaces  ·  d = z₁ − z₂, lengths in {unit}"
    _write(page, _LEFT, _TOP + 0.28, text, color=QUIET, fontsize=9)
    for place, (name, value, symbol) in enumerate(key_figures(document)):
        x = _LEFT + 1.36 * place
        _write(page, x, _TOP + 0.72, name, color=QUIET, fontsize=7.5)
        _write(page, x, _TOP + 0.95, f"{value} {symbol}", fontsize=12, fontweight="bold")
    down = _TOP + 1.3
    for warning in document["warnings"]:
        down = _paragraph(page, down, f"▲ {warning}") + 0.04
    left, bottom, right = MAP_MARGINS
    room = (_WIDTH - 2 * _LEFT + 0.3 - left - right, _HEIGHT - down - 0.3 - bottom - _BOTTOM)
    width, height = map_size(comparison, *room)
    place_ = (_LEFT + left - 0.3, _HEIGHT - down - 0.3 - height, width, height)
    draw_map(page, comparison, document, place_, signed=False)
    return page


def _measures(comparison: Comparison, document: Document) -> "Figure":
    page = sheet(_WIDTH, _HEIGHT)
    unit = document["options"]["unit"]
    down = _heading(page, _TOP, "Measures")
    group = ""
    for line in lines(document["measures"], unit):
        if line.group != group:
            group = line.group
            _write(page, _LEFT, down + 0.08, group, fontsize=8.5, fontweight="bold")
            down += 0.28
            if group in NOTES:
                down = _paragraph(page, down - 0.02, NOTES[group], color=QUIET)
        value, symbol = with_unit(line.value, line.power, unit)
        _write(page, _LEFT, down, line.name)
        _write(page, _LEFT + 2.35, down, value, ha="right")
        _write(page, _LEFT + 2.43, down, symbol, color=QUIET)
        _write(page, _LEFT + 2.95, down, line.text, color=QUIET)
        down += 0.2
    width = _WIDTH - 2 * _LEFT - 0.4
    draw_histogram(page, comparison, document, (_LEFT + 0.4, _BOTTOM + 0.6, width, 1.5))
    return page


def _origin(document: Document) -> "Figure":
    page = sheet(_WIDTH, _HEIGHT)
    down = _TOP
    for number, rows in enumerate(input_rows(document), 1):
        down = _table(page, _heading(page, down, f"Surface {number}"), rows) + 0.18
    down = _table(page, _heading(page, down, "Counts"), count_rows(document)) + 0.18
    down = _table(page, _heading(page, down, "Options as used"), option_rows(document)) + 0.18
    down = _heading(page, down, "Transform")
    for line in transform_text(document).splitlines():
        _write(page, _LEFT, down, line, **_MONO)
        down += 0.15
    return page


def _table(page: "Figure", down: float, rows: Rows) -> float:
    for name, value in rows:
        _write(page, _LEFT, down, name, color=QUIET)
        down = _paragraph(page, down, value, indent=1.75)
    return down


def _heading(page: "Figure", down: float, text: str) -> float:
    _write(page, _LEFT, down, text, fontsize=11, fontweight="bold")
    return down + 0.26


def _paragraph(
    page: "Figure", down: float, text: str, indent: float = 0.0, color: str | None = None
) -> float:
    """Set text in lines that fit; return where the next one starts."""
    from textwrap import wrap

    room = int((_WIDTH - 2 * _LEFT - indent) / 0.071)
    for line in wrap(text, room) or [""]:
        _write(page, _LEFT + indent, down, line, **({"color": color} if color else {}))
        down += 0.18
    return down


def _foot(page: "Figure", document: Document, number: str) -> None:
    program = document["program"]
    text = f"{program['name']} {program['version']}  ·  {document['created']}  ·  {versions()}"
    _write(page, _LEFT, _HEIGHT - 0.58, DISCLAIMER, fontweight="bold", fontsize=7.5)
    _write(page, _LEFT, _HEIGHT - 0.42, text, color=QUIET, fontsize=7)
    _write(page, _WIDTH - _LEFT, _HEIGHT - 0.42, number, color=QUIET, fontsize=7, ha="right")


def _write(page: "Figure", right: float, down: float, text: str, **style: Any) -> None:
    """Set one line, its base line `down` inches below the top of the page."""
    style = {"fontsize": 8.0, **style}
    page.text(right / _WIDTH, 1 - down / _HEIGHT, text, parse_math=False, **style)
