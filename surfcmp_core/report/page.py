"""The .html result: one file with pictures, numbers and where they come from."""

import base64
from collections.abc import Sequence
from html import escape
from io import BytesIO
from itertools import zip_longest
from typing import TYPE_CHECKING, BinaryIO

from surfcmp_core.colours.scale import scale_of
from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.report.figures import heatmap, histogram, save
from surfcmp_core.report.meanings import NOTES, lines
from surfcmp_core.report.numbers import with_unit
from surfcmp_core.report.page_style import STYLE
from surfcmp_core.report.provenance import (
    DISCLAIMER,
    Rows,
    alignment_rows,
    base_name,
    count_rows,
    input_rows,
    key_figures,
    option_rows,
    region_table,
    transform_text,
    versions,
)
from surfcmp_core.report.record import Record

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Picture = tuple[str, bytes]
"""A caption, and the bytes of a .png file."""


def write_html(
    comparison: Comparison, document: Record, stream: BinaryIO, views: Sequence[Picture] = ()
) -> None:
    """Write the .html result; it needs no other file and no network.

    `views` are pictures to stand beside those drawn here: a caption, and a .png file's bytes.
    """
    unit = document["options"]["unit"]
    first, second = (escape(base_name(one["file"])) for one in document["inputs"])
    program = document["program"]
    absolute, signed = (
        _picture(heatmap(comparison, document, signed=kind, titled=False), *text)
        for kind, text in MAPS.items()
    )
    maps = [signed, absolute] if scale_of(comparison, document).signed else [absolute, signed]
    parts = [
        f"<header><p>Comparison of two surfaces · {escape(document['created'])}</p>",
        f"<h1>{first} <span>−</span> {second}</h1>",
        f'<p class="quiet">d = z₁ − z₂, lengths in {escape(unit)};'
        " 1 is the first file, 2 the second</p></header>",
        _key(document),
        _warnings(document["warnings"]),
        '<section><h2>Where they differ</h2><div class="pair">',
        *maps,
        "</div>",
        _picture(
            histogram(comparison, document),
            "Histogram",
            "Share of the compared area by difference; dashed lines are the tolerances.",
        ),
        "</section>",
        _views(views),
        _regions(document),
        _measures(document, unit),
        "<section><h2>Alignment</h2>",
        _table(alignment_rows(document)),
        f"<p>Surface 2 moved by</p><pre>{escape(transform_text(document))}</pre></section>",
        "<section><h2>What was compared</h2>",
        *(_table(rows) for rows in _numbered(input_rows(document))),
        "</section><section><h2>Counts</h2>",
        _table(count_rows(document)),
        "</section><section><h2>Options as used</h2>",
        _table(option_rows(document)),
        f"</section><footer><p><strong>{DISCLAIMER}</strong></p><p>{escape(program['name'])}"
        f" {escape(program['version'])} · {escape(versions())} · {escape(document['created'])}"
        f" · computed in {document['seconds']['total']:.2f} s</p></footer>",
    ]
    body = "\n".join(part for part in parts if part)
    stream.write(
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{first} − {second}</title>\n<style>{STYLE}</style>\n</head>\n"
        f"<body>\n<main>\n{body}\n</main>\n</body>\n</html>\n".encode()
    )


MAPS = {
    False: (
        "Absolute difference",
        "How far apart: mean |z₁ − z₂| of each triangle. Grey was not compared.",
    ),
    True: ("Signed difference", "Which lies above: red where 1 is above 2, blue below."),
}
"""Name and caption of the map without and with the sign."""


def _key(document: Record) -> str:
    boxes = (
        f"<div><dt>{escape(title)}</dt><dd>{value} <small>{escape(unit)}</small></dd></div>"
        for title, value, unit in key_figures(document)
    )
    return f'<dl class="key">{"".join(boxes)}</dl>'


def _warnings(warnings: list[str]) -> str:
    if not warnings:
        return ""
    items = "".join(f"<li>{escape(text)}</li>" for text in warnings)
    return f'<div class="warn" role="note"><b>Please note</b><ul>{items}</ul></div>'


def _picture(figure: "Figure", name: str, caption: str) -> str:
    png = BytesIO()
    save(figure, png, "png")
    return _figure(png.getvalue(), name, f"<b>{escape(name)}.</b> {escape(caption)}")


def _figure(png: bytes, name: str, caption: str) -> str:
    data = base64.b64encode(png).decode("ascii")
    return (
        f'<figure><img alt="{escape(name)}" src="data:image/png;base64,{data}">'
        f"<figcaption>{caption}</figcaption></figure>"
    )


def _views(views: Sequence[Picture]) -> str:
    if not views:
        return ""
    figures = "".join(_figure(png, name, f"<b>{escape(name)}</b>") for name, png in views)
    return f'<section><h2>The views</h2><div class="pair">{figures}</div></section>'


def _regions(document: Record) -> str:
    table = region_table(document)
    if not table:
        return ""
    head = "".join(f'<th scope="col">{escape(text)}</th>' for text in table[0])
    colours = [part["colour"] for part in document["regions"]]
    rows = []
    for row, colour in zip_longest(table[1:], colours):
        dot = f'<i style="background:rgb({",".join(map(str, colour))})"></i>' if colour else ""
        cells = "".join(f'<td class="number">{escape(text)}</td>' for text in row[1:])
        rows.append(f'<tr><th scope="row">{dot}{escape(row[0])}</th>{cells}</tr>')
    return (
        "<section><h2>Regions</h2><p>µ weighs a region in ρ_V with the weight µ; areas of all"
        " parts add up to the whole.</p>"
        f'<table class="regions"><tr>{head}</tr>{"".join(rows)}</table></section>'
    )


def _measures(document: Record, unit: str) -> str:
    rows, group = [], ""
    for line in lines(document["measures"], unit):
        if line.group != group:
            group = line.group
            note = f" <small>{escape(NOTES[group])}</small>" if group in NOTES else ""
            rows.append(f'<tr><th scope="rowgroup" colspan="4">{escape(group)}{note}</th></tr>')
        value, symbol = with_unit(line.value, line.power, unit)
        rows.append(
            f'<tr><th scope="row">{escape(line.name)}</th><td class="number">{value}</td>'
            f'<td class="unit">{escape(symbol)}</td><td class="text">{escape(line.text)}</td></tr>'
        )
    return (
        '<section><h2>Measures</h2><table class="measures">' + "".join(rows) + "</table></section>"
    )


def _numbered(inputs: list[Rows]) -> list[Rows]:
    return [[("surface", str(number)), *rows] for number, rows in enumerate(inputs, 1)]


def _table(rows: Rows) -> str:
    cells = "".join(
        f'<tr><th scope="row">{escape(name)}</th><td>{escape(value)}</td></tr>'
        for name, value in rows
    )
    return f"<table>{cells}</table>"
