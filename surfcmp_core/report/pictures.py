"""The results made to be looked at and printed: .png and .pdf."""

from typing import BinaryIO

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
    title,
)
from surfcmp_core.report.meanings import NOTES, lines
from surfcmp_core.report.numbers import with_unit
from surfcmp_core.report.paper import BOTTOM, HEIGHT, LEFT, WIDTH, Paper, write
from surfcmp_core.report.provenance import (
    DISCLAIMER,
    count_rows,
    input_rows,
    key_figures,
    option_rows,
    transform_text,
    versions,
)


def write_png(comparison: Comparison, document: Document, stream: BinaryIO) -> None:
    """Write the .png result: the heatmap with its scale, files and main numbers."""
    save(heatmap(comparison, document), stream, "png")


def write_pdf(comparison: Comparison, document: Document, stream: BinaryIO) -> None:
    """Write the .pdf result: the heatmap, the measures, and where they come from."""
    from matplotlib.backends.backend_pdf import PdfPages

    paper = Paper()
    _summary(paper, document)
    _map(paper, comparison, document)
    paper.turn()
    _measures(paper, document)
    _histogram(paper, comparison, document)
    paper.turn()
    _origin(paper, document)
    with PdfPages(stream, metadata={"Title": title(document), "Creator": "surfcmp"}) as pdf:
        for number, page in enumerate(paper.pages, 1):
            program = document["program"]
            made = f"{program['name']} {program['version']}  ·  {document['created']}"
            foot = {"color": QUIET, "fontsize": 7}
            write(page, LEFT, HEIGHT - 0.58, DISCLAIMER, fontweight="bold", fontsize=7.5)
            write(page, LEFT, HEIGHT - 0.42, f"{made}  ·  {versions()}", **foot)
            count = f"{number} / {len(paper.pages)}"
            write(page, WIDTH - LEFT, HEIGHT - 0.42, count, ha="right", **foot)
            with any_script():
                pdf.savefig(page, dpi=300)


def _summary(paper: Paper, document: Document) -> None:
    unit = document["options"]["unit"]
    paper.write(0.0, title(document), fontsize=15, fontweight="bold")
    paper.down += 0.28
    text = f"Comparison of two surfaces  ·  d = z₁ − z₂, lengths in {unit}"
    paper.write(0.0, text, color=QUIET, fontsize=9)
    paper.down += 0.44
    figures = key_figures(document)
    for place, (name, _value, _symbol) in enumerate(figures):
        paper.write(1.36 * place, name, color=QUIET, fontsize=7.5)
    paper.down += 0.23
    for place, (_name, value, symbol) in enumerate(figures):
        paper.write(1.36 * place, f"{value} {symbol}", fontsize=12, fontweight="bold")
    paper.down += 0.35
    for warning in document["warnings"]:
        paper.paragraph(f"▲ {warning}")
        paper.down += 0.04


def _map(paper: Paper, comparison: Comparison, document: Document) -> None:
    left, below, right = MAP_MARGINS
    left -= 0.3  # its labels may reach into the margin
    paper.need(4.0)
    paper.down += 0.3
    room = WIDTH - 2 * LEFT - left - right, HEIGHT - paper.down - below - BOTTOM
    width, height = map_size(comparison, *room)
    place = LEFT + left, HEIGHT - paper.down - height, width, height
    draw_map(paper.pages[-1], comparison, document, place, signed=False)


def _measures(paper: Paper, document: Document) -> None:
    unit = document["options"]["unit"]
    paper.heading("Measures")
    group = ""
    for line in lines(document["measures"], unit):
        if line.group != group:
            group = line.group
            paper.need(0.8)
            paper.down += 0.08
            paper.write(0.0, group, fontsize=8.5, fontweight="bold")
            paper.down += 0.2
            if group in NOTES:
                paper.paragraph(NOTES[group], color=QUIET)
        value, symbol = with_unit(line.value, line.power, unit)
        paper.need(0.0)
        paper.write(0.0, line.name)
        paper.write(2.35, value, ha="right")
        paper.write(2.43, symbol, color=QUIET)
        paper.write(2.95, line.text, color=QUIET)
        paper.down += 0.2


def _histogram(paper: Paper, comparison: Comparison, document: Document) -> None:
    height = 1.5
    paper.need(0.3 + height + 0.6)
    paper.down += 0.3 + height
    place = LEFT + 0.4, HEIGHT - paper.down, WIDTH - 2 * LEFT - 0.4, height
    draw_histogram(paper.pages[-1], comparison, document, place)


def _origin(paper: Paper, document: Document) -> None:
    for number, rows in enumerate(input_rows(document), 1):
        paper.heading(f"Surface {number}")
        paper.table(rows)
    paper.heading("Counts")
    paper.table(count_rows(document))
    paper.heading("Options as used")
    paper.table(option_rows(document))
    paper.heading("Transform")
    for line in transform_text(document).splitlines():
        paper.write(0.0, line, family="monospace", fontsize=7)
        paper.down += 0.15
