"""The results made to be looked at and printed: .png and .pdf."""

from collections.abc import Sequence
from io import BytesIO
from typing import BinaryIO

from surfcmp_core.colours.scale import scale_of
from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.report.figures import (
    LYING,
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
from surfcmp_core.report.page import MAPS, Picture
from surfcmp_core.report.paper import BOTTOM, HEIGHT, LEFT, WIDTH, Paper, write
from surfcmp_core.report.provenance import (
    DISCLAIMER,
    alignment_rows,
    count_rows,
    input_rows,
    key_figures,
    option_rows,
    region_table,
    transform_text,
    versions,
)
from surfcmp_core.report.record import Record

INSET = 0.35
"""Inches left of a map; its labels may reach into the margin."""
GAP = 0.7
"""Inches between two maps, for the labels of the right one."""
HISTOGRAM = 1.5
LEAST_MAP = 2.2


def write_png(comparison: Comparison, document: Record, stream: BinaryIO) -> None:
    """Write the .png result: the heatmap with its scale, files and main numbers."""
    signed = scale_of(comparison, document).signed
    save(heatmap(comparison, document, signed=signed), stream, "png")


def write_pdf(
    comparison: Comparison, document: Record, stream: BinaryIO, views: Sequence[Picture] = ()
) -> None:
    """Write the .pdf result: the maps, the measures, and where they come from.

    `views` are pictures to stand beside those drawn here: a caption, and a .png file's bytes.
    """
    from matplotlib.backends.backend_pdf import PdfPages

    paper = Paper()
    _summary(paper, document)
    _maps(paper, comparison, document)
    _histogram(paper, comparison, document)
    paper.turn()
    if views:
        _views(paper, views)
    _regions(paper, document)
    _measures(paper, document)
    paper.down += 0.2
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


def _summary(paper: Paper, document: Record) -> None:
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


def _maps(paper: Paper, comparison: Comparison, document: Record) -> None:
    """Draw both maps, as large as leaves room for the histogram: side by side, or stacked."""
    kinds = sorted(MAPS, reverse=scale_of(comparison, document).signed)
    paper.need(2 * (LEAST_MAP + 0.8))
    paper.down += 0.25
    room = HEIGHT - BOTTOM - paper.down - HISTOGRAM - 0.75
    beside = (WIDTH - 2 * LEFT - INSET - GAP) / 2
    below = LYING + 0.35
    side = map_size(comparison, beside, max(room - 0.21 - below, LEAST_MAP))
    whole = WIDTH - 2 * LEFT - INSET - MAP_MARGINS[2]
    stacked = map_size(comparison, whole, max(room / 2 - 0.95, 0.5 * LEAST_MAP))
    if stacked[0] <= 1.3 * side[0]:
        for place, signed in enumerate(kinds):
            left = INSET + place * (beside + GAP)
            paper.write(left, MAPS[signed][0], fontsize=9, fontweight="bold")
            axes = LEFT + left, HEIGHT - paper.down - 0.21 - side[1], *side
            draw_map(paper.pages[-1], comparison, document, axes, signed=signed, lying=True)
        paper.down += 0.21 + side[1] + below
        return
    for signed in kinds:
        paper.write(INSET, MAPS[signed][0], fontsize=9, fontweight="bold")
        paper.down += 0.21 + stacked[1]
        axes = LEFT + INSET, HEIGHT - paper.down, *stacked
        draw_map(paper.pages[-1], comparison, document, axes, signed=signed)
        paper.down += 0.74


def _views(paper: Paper, views: Sequence[Picture]) -> None:
    """Set pictures in two columns."""
    from matplotlib.image import imread

    room = (WIDTH - 2 * LEFT - 0.2) / 2
    paper.heading("The views")
    for k in range(0, len(views), 2):
        row = [(name, imread(BytesIO(png))) for name, png in views[k : k + 2]]
        heights = [room * picture.shape[0] / picture.shape[1] for _, picture in row]
        paper.need(max(heights) + 0.4)
        for place, ((name, picture), height) in enumerate(zip(row, heights, strict=True)):
            left = place * (room + 0.2)
            paper.write(left, name, fontweight="bold")
            box = LEFT + left, HEIGHT - paper.down - 0.08 - height, room, height
            axes = paper.pages[-1].add_axes(
                (box[0] / WIDTH, box[1] / HEIGHT, box[2] / WIDTH, box[3] / HEIGHT)
            )
            axes.imshow(picture, aspect="auto", interpolation="none")
            axes.set(xticks=[], yticks=[])
            for spine in axes.spines.values():
                spine.set(edgecolor="#b6bbc4", linewidth=0.6)
        paper.down += max(heights) + 0.4
    paper.down += 0.1


def _regions(paper: Paper, document: Record) -> None:
    table = region_table(document)
    if not table:
        return
    paper.need(0.26 + 0.2 * min(len(table), 6) + 0.4)
    paper.heading("Regions")
    paper.paragraph(
        "µ weighs a region in ρ_V with the weight µ; areas of all parts add up to the whole.",
        color=QUIET,
    )
    paper.down += 0.06
    width = (WIDTH - 2 * LEFT - 1.75) / (len(table[0]) - 2)
    for k, row in enumerate(table):
        paper.need(0.0)
        style = {"color": QUIET, "fontsize": 7} if k == 0 else {}
        style |= {"fontweight": "bold"} if k == len(table) - 1 else {}
        if 0 < k <= len(document["regions"]) and (colour := document["regions"][k - 1]["colour"]):
            paper.write(-0.15, "■", color=[part / 255 for part in colour], fontsize=7)
        paper.write(0.0, row[0] if len(row[0]) < 24 else f"{row[0][:22]}…", **style)
        paper.write(1.7, row[1], ha="right", **style)
        for place, text in enumerate(row[2:], 1):
            paper.write(1.75 + place * width, text, ha="right", **style)
        paper.down += 0.2
    paper.down += 0.18


def _measures(paper: Paper, document: Record) -> None:
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


def _histogram(paper: Paper, comparison: Comparison, document: Record) -> None:
    paper.need(HISTOGRAM + 0.75)
    paper.down += 0.25 + HISTOGRAM
    place = LEFT + 0.4, HEIGHT - paper.down, WIDTH - 2 * LEFT - 0.4, HISTOGRAM
    draw_histogram(paper.pages[-1], comparison, document, place)
    paper.down += 0.65


def _origin(paper: Paper, document: Record) -> None:
    for number, rows in enumerate(input_rows(document), 1):
        paper.heading(f"Surface {number}")
        paper.table(rows)
    paper.heading("Alignment")
    paper.table(alignment_rows(document))
    paper.down -= 0.18
    paper.write(0.0, "surface 2 moved by", color=QUIET)
    for line in transform_text(document).splitlines():
        paper.write(1.75, line, family="monospace", fontsize=7)
        paper.down += 0.15
    paper.down += 0.18
    paper.heading("Counts")
    paper.table(count_rows(document))
    paper.heading("Options as used")
    paper.table(option_rows(document))
