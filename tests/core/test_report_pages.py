"""The results made for people: complete, self-contained, honest."""

import contextlib
import json
import re
import zlib
from dataclasses import replace
from html.parser import HTMLParser
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from surfcmp_core.colours.maps import WITHIN
from surfcmp_core.colours.scale import Scale, band_colours, bands_of, scale_end, scale_of
from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.comparing.options import Motion, Options
from surfcmp_core.report import WRITERS, make_record
from surfcmp_core.report.figures import short_name
from surfcmp_core.report.hidden import without_names
from surfcmp_core.report.meanings import MEANINGS, REASONS
from surfcmp_core.report.numbers import figure, thousands, with_unit
from surfcmp_core.report.page import write_html
from surfcmp_core.report.pictures import write_pdf
from surfcmp_core.report.provenance import DISCLAIMER, region_table, transform_text
from surfcmp_core.report.record import region_record

from .two_squares import two_squares

PICTURES = (".html", ".pdf", ".png")


def written(ending: str, comparison: Comparison, document: dict[str, Any] | None = None) -> bytes:
    stream = BytesIO()
    WRITERS[ending](comparison, document or make_record(comparison), stream)
    return stream.getvalue()


class Page(HTMLParser):
    """Collects text and addresses, and checks that tags are closed in turn."""

    VOID = frozenset({"meta", "img", "br", "link"})

    def __init__(self) -> None:
        super().__init__()
        self.text = ""
        self.open: list[str] = []
        self.addresses: list[str] = []
        self.tags: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.addresses += [value or "" for name, value in attrs if name in {"src", "href"}]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text += data


def page_of(comparison: Comparison, document: dict[str, Any] | None = None) -> Page:
    page = Page()
    page.feed(written(".html", comparison, document).decode())
    assert page.open == []
    return page


def test_the_page_says_everything_a_record_needs() -> None:
    page = page_of(two_squares())
    for words in (
        "a.ply",
        "b.ply",
        "1" * 64,
        "2" * 64,
        "mean_abs",
        "88.00",
        "units are not stated: taken as mm",
        "not finite: 2",
        "the files' own coordinates",
        "derived from the node spacing",
        "no limit (surface 1), 1.5 (surface 2)",
        "surfcmp 0.",
        "Python 3.",
        "Z",
        DISCLAIMER,
    ):
        assert words in page.text, words
    for meaning in MEANINGS:
        if meaning.key != "within_tolerance":
            assert meaning.key in page.text


def test_the_page_needs_no_network() -> None:
    page = page_of(two_squares())
    assert page.tags.count("img") == 3
    assert all(address.startswith("data:image/png;base64,") for address in page.addresses)
    assert "script" not in page.tags
    assert b"http" not in written(".html", two_squares())


def test_a_hostile_file_name_stays_text() -> None:
    comparison = two_squares()
    name = "<script>alert('$x_{$ & \"')<script>面.ply"
    odd = replace(comparison.surfaces[0], path=Path(name), name=name)
    comparison = replace(comparison, surfaces=(odd, comparison.surfaces[1]))
    page = page_of(comparison)
    assert "script" not in page.tags
    assert name in page.text
    for ending in (".png", ".pdf"):
        assert written(ending, comparison)


def test_pictures_are_pictures() -> None:
    assert written(".png", two_squares()).startswith(b"\x89PNG")
    pdf = written(".pdf", two_squares())
    assert pdf.startswith(b"%PDF")
    assert pdf.count(b"/Type /Page ") == 3


def test_the_map_shows_values_and_what_was_not_compared() -> None:
    from matplotlib.image import imread

    picture = imread(BytesIO(written(".png", two_squares())))[..., :3]
    assert picture.shape[0] > 600
    pixels = (picture * 255).round().astype(int)
    for colour in ((0xA8, 0xAD, 0xB6), (255, 255, 255)):  # not compared, the page
        assert (pixels == colour).all(axis=-1).mean() > 0.05


def test_the_scale_ends_at_a_round_number_over_nearly_all_of_the_area() -> None:
    comparison = two_squares()
    assert scale_end(comparison) == 1.0
    for value, end in (
        (0.0, 1.0),
        (np.nan, 1.0),
        (0.93, 1.0),
        (1.2, 2.0),
        (2e-7, 2e-7),
        (71.0, 100),
    ):
        values = np.where(comparison.compared, value, np.nan)
        assert scale_end(replace(comparison, mean_abs=values)) == end


def test_the_scale_is_the_one_asked_for() -> None:
    comparison = two_squares()
    document = make_record(comparison)
    assert scale_of(comparison, document) == Scale(1.0)
    document["scale"] = {"end": 0.3, "bands": [0.1, 0.2], "signed": True}
    assert scale_of(comparison, document) == Scale(0.3, (0.1, 0.2), True)
    plain = {ending: written(ending, comparison) for ending in PICTURES}
    for ending, before in plain.items():
        assert written(ending, comparison, document) != before
    page = page_of(comparison, document)
    assert page.text.index("Signed difference") < page.text.index("Absolute difference")


def test_a_limit_belongs_to_the_band_nearer_zero() -> None:
    plain = Scale(9.0, (0.5, 1.0))
    signed = replace(plain, signed=True)
    values = np.array([-2, -1, -0.7, -0.5, -0.1, 0, 0.1, 0.5, 0.7, 1, 2, np.nan])
    assert np.array_equal(
        bands_of(values, signed), [0, 1, 1, 2, 2, 2, 2, 2, 3, 3, 4, np.nan], equal_nan=True
    )
    assert np.array_equal(
        bands_of(np.abs(values), plain), [2, 1, 1, 0, 0, 0, 0, 0, 1, 1, 2, np.nan], True
    )
    for scale, count in ((signed, 5), (plain, 3)):
        colours = band_colours(scale)
        assert len({tuple(colour) for colour in colours.tolist()}) == count
        assert tuple(colours[bands_of(np.zeros(1), scale).astype(int)][0]) == WITHIN


def with_regions() -> tuple[Comparison, dict[str, Any]]:
    comparison = two_squares()
    document = make_record(comparison)
    measures = comparison.measures
    document["regions"] = [
        region_record("nose & <chin>", (1, 2, 3), 2.5, 3, measures),
        region_record(None, None, 1.0, 0, None),
    ]
    return comparison, document


def test_the_regions_stand_in_the_reports() -> None:
    comparison, document = with_regions()
    heads, nose, rest, whole = region_table(document)
    assert heads[:3] == ["region", "µ", "area (mm²)"]
    assert nose[:2] == ["nose & <chin>", "2.5"]
    assert set(rest[2:]) == {"–"}
    assert nose[2:] == whole[2:]
    page = page_of(comparison, document)
    for words in ("Regions", "nose & <chin>", "the rest", "the whole"):
        assert words in page.text
    assert "Regions" not in page_of(comparison).text
    text = text_of(written(".pdf", comparison, document))
    assert b"Regions" in text
    assert json.loads(written(".json", comparison, document))["regions"][0]["weight"] == 2.5


def test_pictures_of_views_stand_in_the_reports() -> None:
    comparison = two_squares()
    views = [("One & <two>", written(".png", comparison))] * 3
    stream = BytesIO()
    write_html(comparison, make_record(comparison), stream, views)
    page = Page()
    page.feed(stream.getvalue().decode())
    assert page.tags.count("img") == 3 + 3
    assert "One & <two>" in page.text
    stream = BytesIO()
    write_pdf(comparison, make_record(comparison), stream, views)
    assert b"The views" in text_of(stream.getvalue())


def text_of(pdf: bytes) -> bytes:
    """Return what a .pdf file holds, uncompressed."""
    parts = re.findall(rb"stream\r?\n(.*?)endstream", pdf, re.DOTALL)
    plain = [pdf]
    for part in parts:
        with contextlib.suppress(zlib.error):
            plain.append(zlib.decompress(part))
    return re.sub(rb"\)\s*-?[\d.]*\s*\(", b"", b"".join(plain))


@pytest.mark.parametrize("ending", list(WRITERS))
def test_names_and_paths_can_be_hidden(ending: str) -> None:
    comparison = two_squares()
    surfaces = [
        replace(surface, name=f"{name}.ply", path=Path(f"/patients/{name}.ply"))
        for surface, name in zip(comparison.surfaces, ("Anna", "Berta"), strict=True)
    ]
    warnings = ("units of Anna.ply are not stated", "/patients/Berta.ply: odd")
    comparison = replace(comparison, surfaces=(surfaces[0], surfaces[1]), warnings=warnings)
    files = Options(weight=Path("/patients/Dora.npz"), align=Path("/patients/Clara.npy"))
    comparison = replace(comparison, options=files)
    document = make_record(comparison)
    names = (b"Anna", b"Berta", b"Clara", b"Dora", b"patients")
    if ending in {".html", ".pdf", ".json"}:
        plain = text_of(written(ending, comparison, document))
        assert all(name in plain for name in names)
    hidden = text_of(written(ending, *without_names(comparison, document)))
    assert not any(name in hidden for name in names)
    if ending in {".html", ".pdf", ".json"}:
        assert b"1" * 64 in hidden


def test_equal_surfaces_make_pictures_too() -> None:
    comparison = two_squares()
    nothing = np.where(comparison.compared, 0.0, np.nan)
    comparison = replace(comparison, mean_abs=nothing, mean_signed=nothing)
    for ending in (".png", ".pdf", ".html"):
        assert written(ending, comparison)


@pytest.mark.parametrize("factor", [(1e-6, 1.0), (1.0, 1e-6), (1e9, 1e9)])
def test_thin_and_huge_extents_make_pictures_too(factor: tuple[float, float]) -> None:
    comparison = two_squares()
    nodes = comparison.united.nodes * factor
    comparison = replace(comparison, united=replace(comparison.united, nodes=nodes))
    assert written(".png", comparison)


def test_numbers_are_set_as_people_read_them() -> None:
    assert figure(0.0) == "0"
    assert figure(-0.0753512) == "−0.07535"
    assert figure(1234567.8) == "1234568"
    assert figure(1e-9) == "1.000e−9"
    assert figure(-2.5e12) == "−2.500e12"
    assert figure(float("nan")) == figure(None) == "–"
    assert with_unit(0.95622, None, "mm") == ("95.62", "%")
    assert with_unit(12.0, 3, "mm") == ("12.00", "mm³")
    assert with_unit(None, 2, "mm") == ("–", "")
    assert thousands(1234567) == "1\u2009234\u2009567"


def test_long_names_are_shortened_in_the_middle() -> None:
    assert short_name("/folder/a.ply") == "a.ply"
    assert short_name("C:\\folder\\a.ply") == "a.ply"
    long = short_name("x" * 60 + ".ply")
    assert len(long) == 40
    assert long.endswith(".ply")


def test_every_reason_has_a_name() -> None:
    from surfcmp_core.domain import Reason

    assert len(REASONS) == len(Reason)
    assert [reason.name.lower().replace("_", " ") for reason in Reason] == list(REASONS)


def test_a_motion_is_shown_in_full() -> None:
    comparison = two_squares()
    moved = np.eye(4)
    moved[0, 3] = 12.5
    assert "12.5" in transform_text(make_record(replace(comparison, transform=moved)))


def test_paper_takes_as_many_sheets_as_it_needs() -> None:
    comparison = two_squares()
    exact = replace(comparison.measures, exact=comparison.measures)
    warnings = tuple(f"this is warning number {n}" for n in range(60))
    comparison = replace(comparison, measures=exact, warnings=warnings)
    assert written(".pdf", comparison).count(b"/Type /Page ") == 5


@pytest.mark.parametrize(("banded", "wide"), [(True, 1.0), (False, 1.0), (True, 6.0)])
def test_nothing_on_paper_lies_outside_its_margins_or_on_something_else(
    banded: bool, wide: float
) -> None:
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    from surfcmp_core.report.paper import Paper
    from surfcmp_core.report.pictures import (
        _histogram,
        _maps,
        _measures,
        _origin,
        _regions,
        _summary,
    )

    comparison = two_squares()
    exact = replace(comparison.measures, exact=comparison.measures)
    moved = np.eye(4)
    moved[0, 3] = 1 / 3
    united = replace(comparison.united, nodes=comparison.united.nodes * (wide, 1.0))
    motion = Options(align=Motion(method="icp", residual=0.25, pairs=7))
    comparison = replace(comparison, measures=exact, transform=moved, united=united, options=motion)
    document = make_record(comparison)
    document["regions"] = with_regions()[1]["regions"]
    document["scale"] = {"end": 0.3, "bands": [0.1, 0.2] if banded else [], "signed": True}
    paper = Paper()
    _summary(paper, document)
    _maps(paper, comparison, document)
    _histogram(paper, comparison, document)
    _regions(paper, document)
    _measures(paper, document)
    _origin(paper, document)
    for page in paper.pages:
        FigureCanvasAgg(page)
        boxes = [text.get_window_extent() for text in page.texts]
        boxes += [box for axes in page.axes if (box := axes.get_tightbbox())]
        for number, box in enumerate(boxes):
            assert box.x0 > 0.5 * page.dpi
            assert box.x1 < page.bbox.x1 - 0.5 * page.dpi
            assert box.y0 > 0.7 * page.dpi
            for other in boxes[:number]:
                x = min(box.x1, other.x1) - max(box.x0, other.x0)
                y = min(box.y1, other.y1) - max(box.y0, other.y0)
                assert min(x, y) < 1.0, f"two things overlap on a sheet: {box}, {other}"
