"""Decimal marks and thousands: one notation in all of a table, or none is believed."""

from pathlib import Path

import numpy as np
import pytest

from surfcmp_core.errors import InputError
from surfcmp_core.io.columns import read_columns

REPORTS = Path(__file__).parent / "fixtures" / "reports"
NODES = [[999.5, 5600.25, 3.0], [1200.5, 5600.75, 12.5], [1201.0, 1234567.25, -1000.5]]


def _written(between: str, decimal: str, delimiter: str, quote: str = "") -> str:
    """Write NODES in a notation."""

    def field(value: float) -> str:
        text = f"{value:,.2f}".replace(",", "@").replace(".", decimal).replace("@", between)
        return f"{quote}{text}{quote}"

    return "".join(delimiter.join(map(field, row)) + "\n" for row in NODES)


@pytest.mark.parametrize("header", ["", "x{0}y{0}z\n"])
@pytest.mark.parametrize(
    ("between", "decimal", "delimiter", "quote"),
    [
        ("", ".", " ", ""),
        ("", ".", ",", ""),
        ("", ".", ";", ""),
        ("", ",", ";", ""),
        ("", ",", "\t", ""),
        ("", ",", " ", ""),
        ("", ",", ",", '"'),
        (".", ",", ";", ""),
        (".", ",", "\t", ""),
        (".", ",", " ", ""),
        (".", ",", ",", '"'),
        (".", ",", ";", '"'),
        (",", ".", ";", ""),
        (",", ".", "\t", ""),
        (",", ".", " ", ""),
        (",", ".", ",", '"'),
        ("'", ".", ",", ""),
        ("'", ",", ";", ""),
        ("\u2019", ".", ";", ""),
        ("\u2019", ".", " ", ""),
        (" ", ",", ";", ""),
        (" ", ",", "\t", ""),
        (" ", ".", ",", ""),
        ("\u00a0", ",", ";", ""),
        ("\u00a0", ",", " ", ""),
        ("\u202f", ",", "\t", ""),
        ("\u2009", ".", " ", ""),
    ],
)
def test_one_notation(header: str, between: str, decimal: str, delimiter: str, quote: str):
    text = header.format(delimiter) + _written(between, decimal, delimiter, quote)
    assert read_columns(text.encode()).points.tolist() == NODES


def test_german_thousands_are_thousands():
    points = read_columns((REPORTS / "thousands_german.csv").read_bytes()).points
    assert np.unique(points[:, 0]).tolist() == [1200, 1201, 1202, 1203]
    assert np.unique(points[:, 1]).tolist() == [5600, 5601, 5602, 5603]
    assert np.unique(points[:, 2]).tolist() == [3.0, 3.1, 3.2, 3.3]


@pytest.mark.parametrize(
    ("text", "x"),
    [
        ("998;5;3,5\n999;6;4\n1.000;7;5\n", [998, 999, 1000]),
        ("999.000 5 3\n1.000.000 6 4\n1.000.001 6 5\n", [999000, 1000000, 1000001]),
    ],
)
def test_one_number_may_tell_the_notation_of_all(text: str, x: list[float]):
    assert read_columns(text.encode()).points[:, 0].tolist() == x


MIXED: dict[str, tuple[str, str]] = {
    "two habits": ("x;y;z\n1.200,50;5;3\n1,200.50;5;3\n", "'1,200.50;5;3'"),
    "a decimal point among thousands": ("x;y;z\n1.200,5;5;3\n1.25;5;3\n", "'1.25;5;3'"),
    "thousands late": ("x;y;z\n" + "1,5;2,5;3,5\n" * 99 + "1.2;5;3\n", "'1.2;5;3'"),
    "groups of two": ("x;y;z\n12.34,5;5;3\n", "'12.34,5;5;3'"),
    "groups of four": ("x;y;z\n1.2345,5;5;3\n", "'1.2345,5;5;3'"),
    "either thousands or decimals": ("x;y;z\n1.200;5,600;3\n1.300;5,700;3\n", "'1.200;5,600;3'"),
    "past a thousand": ("998 5.5 3\n999 6.5 4\n1.000 7.5 5\n", "'1.000 7.5 5'"),
    "past a thousand, commas": ("x,y,z\n998,5.5,3\n999,6.5,4\n1.000,7.5,5\n", "'1.000,7.5,5'"),
    "past a thousand with commas": ("998;5;3\n999;6;4\n1,001;7;5\n", "'1,001;7;5'"),
    "past a thousand, quoted": ('"998","5","3"\n"1,001","7","5"\n', '\'"1,001","7","5"\''),
    "past a thousand below zero": ("-999 5 3\n-1.000 6 4\n-1.001 6 4\n", "'-1.000 6 4'"),
    "blanks between thousands and columns": ("451 234,5 5 412 345,6 312,4\n" * 3, "451, 234,5, 5"),
    "commas between thousands and columns": ("1,200.50,5,600.00,3.00\n" * 3, "1, 200.50, 5"),
    "commas in a table of commas": ("0,00,0,00,3,00\n1,00,0,00,3,10\n", "0, 00, 0, 00, 3, 00"),
    "header that shows it": ("x,y,z\n0,5,0,5,3,5\n", "'0,5,0,5,3,5'"),
    "blanks in some rows": ("x y z\n999,5 1,5 3,5\n1 000,5 1,5 3,5\n", "'1 000,5 1,5 3,5'"),
}


@pytest.mark.parametrize("case", MIXED)
def test_what_may_be_off_by_a_thousand_is_refused(case: str):
    text, row = MIXED[case]
    with pytest.raises(InputError) as caught:
        read_columns(text.encode())
    assert row in str(caught.value)


PLAIN: dict[str, tuple[str, list[float]]] = {
    # texts of z, and what they are: no thousands
    "three decimals everywhere": ("1.200 1.201 1.202 999.000", [1.2, 1.201, 1.202, 999.0]),
    "below one": ("0.125 1 2 1.125", [0.125, 1, 2, 1.125]),
    "fewer decimals too": ("1.125 1.25 3 7", [1.125, 1.25, 3, 7]),
    "more decimals too": ("1.125 1.0625 3 7", [1.125, 1.0625, 3, 7]),
    "whole numbers above a thousand": ("1.125 1250 3 7", [1.125, 1250, 3, 7]),
    "nothing but whole numbers": ("1 999 1000 1001", [1, 999, 1000, 1001]),
    "zeros only": ("0 1.125 1.250 0", [0, 1.125, 1.25, 0]),
    "powers": ("1.125e0 1 2 3", [1.125, 1, 2, 3]),
}


@pytest.mark.parametrize("case", PLAIN)
@pytest.mark.parametrize("delimiter", [" ", ",", ";"])
def test_decimals_that_are_no_thousands(case: str, delimiter: str):
    fields, z = PLAIN[case]
    rows = [f"{i % 2}.5 {i}.5 {field}" for i, field in enumerate(fields.split())]
    text = "\n".join(rows).replace(" ", delimiter)
    assert read_columns(text.encode()).points[:, 2].tolist() == z
    if delimiter == ";":
        assert read_columns(text.replace(".", ",").encode()).points[:, 2].tolist() == z


def test_commas_and_points_in_names_are_no_marks_of_numbers():
    text = 'name;x;y;z\nO\'Brien, 1.5;0,5;1;2\nPt. 17, new;1;2;3,25\n"a; b";4;5;6\n'
    assert read_columns(text.encode()).points.tolist() == [[0.5, 1, 2], [1, 2, 3.25], [4, 5, 6]]
