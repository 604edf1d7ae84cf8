"""Numbers where space is short."""

import math

import pytest

from app.look.numerals import four, short, three
from app.panels.scale_panel import parse_tolerances


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.16, "0.160"),
        (97.0, "97.0"),
        (100.0, "100"),
        (-0.0123, "−0.0123"),
        (0.0, "0"),
        (1234.0, "1230"),
        (2.5e-7, "2.5e−07"),
        (math.nan, "–"),
        (math.inf, "–"),
    ],
)
def test_three_figures(value: float, text: str):
    assert three(value) == text


def test_short_and_four():
    assert short(-0.5) == "−0.5"
    assert short(2.0) == "2"
    assert four(20930.4) == "20930"
    assert four(math.nan) == "–"


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("0.5 1 2", (0.5, 1.0, 2.0)),
        ("2; 1 ; 1", (1.0, 2.0)),
        ("", ()),
        ("1 x", ()),
        ("-1 2", ()),
        ("0 1", ()),
    ],
)
def test_tolerances_as_people_type_them(text: str, found: tuple[float, ...]):
    assert parse_tolerances(text) == found
