"""The results made for people: complete, self-contained, honest."""

from dataclasses import replace
from html.parser import HTMLParser
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest

from surfcmp_core.comparison import Comparison
from surfcmp_core.report import WRITERS, make_document
from surfcmp_core.report.figures import scale_end, short_name
from surfcmp_core.report.meanings import MEANINGS, REASONS
from surfcmp_core.report.numbers import figure, thousands, with_unit
from surfcmp_core.report.provenance import DISCLAIMER, transform_text

from .two_squares import two_squares


def written(ending: str, comparison: Comparison) -> bytes:
    stream = BytesIO()
    WRITERS[ending](comparison, make_document(comparison), stream)
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


def page_of(comparison: Comparison) -> Page:
    page = Page()
    page.feed(written(".html", comparison).decode())
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
    for colour in ((0xB4, 0xB8, 0xBF), (255, 255, 255)):  # not compared, the page
        assert (pixels == colour).all(axis=-1).mean() > 0.05


def test_the_scale_ends_at_a_round_number_over_nearly_all_of_the_area() -> None:
    comparison = two_squares()
    assert scale_end(comparison) == 1.0
    for value, end in (
        (0.0, 1.0),
        (np.nan, 1.0),
        (0.93, 1.0),
        (1.2, 1.5),
        (2e-7, 2e-7),
        (71.0, 80),
    ):
        values = np.where(comparison.compared, value, np.nan)
        assert scale_end(replace(comparison, mean_abs=values)) == end


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
    assert "12.5" in transform_text(make_document(replace(comparison, transform=moved)))


def test_paper_takes_as_many_sheets_as_it_needs() -> None:
    comparison = two_squares()
    exact = replace(comparison.measures, exact=comparison.measures)
    warnings = tuple(f"this is warning number {n}" for n in range(60))
    comparison = replace(comparison, measures=exact, warnings=warnings)
    assert written(".pdf", comparison).count(b"/Type /Page ") == 5


def test_nothing_on_paper_lies_outside_its_margins_or_on_something_else() -> None:
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    from surfcmp_core.report.paper import Paper
    from surfcmp_core.report.pictures import _histogram, _measures, _origin

    comparison = two_squares()
    exact = replace(comparison.measures, exact=comparison.measures)
    comparison = replace(comparison, measures=exact)
    document = make_document(comparison, {"align": {"method": "icp", "matrix": [[1.0]]}})
    paper = Paper()
    _measures(paper, document)
    _histogram(paper, comparison, document)
    paper.turn()
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
                assert min(x, y) < 1.0, "two things overlap"
