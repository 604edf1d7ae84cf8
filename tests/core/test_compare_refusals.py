"""What cannot be compared."""

import dataclasses
from typing import Any

import numpy as np
import pytest

from surfcmp_core import InputError, Surface, compare
from tests.core.small_surfaces import cloud, lattice

LINE = np.column_stack((np.arange(5.0), 2.0 * np.arange(5.0)))
GOOD = cloud(lattice(5, 5), 0.0, "good.ply")
BAD: list[tuple[str, Surface, dict[str, Any], str]] = [
    ("one_line", cloud(LINE, 0.0, "bad.ply"), {}, "bad.ply: all nodes lie on one line"),
    ("two_nodes", cloud(LINE[:2], 0.0, "bad.ply"), {}, "bad.ply: 2 nodes; at least 3"),
    ("no_node", cloud(LINE[:0], 0.0, "bad.ply"), {}, "bad.ply: 0 nodes; at least 3"),
    ("one_place", cloud(LINE[[0] * 9], 0.0, "bad.ply"), {}, "bad.ply: 1 distinct nodes; at"),
    (
        "two_places",
        cloud(LINE[[0, 1] * 9], 0.0, "bad.ply"),
        {"duplicates": "max"},
        "bad.ply: 2 distinct nodes; at least 3",
    ),
    (
        "two_values",
        cloud(np.concatenate((lattice(3, 3), lattice(3, 3))), np.arange(18.0), "bad.ply"),
        {},
        "bad.ply: not one-valued: 9 places",
    ),
    ("elsewhere", cloud(lattice(4, 4) + 50.0, 0.0, "bad.ply"), {}, "bad.ply.*no common area"),
    ("far_away", cloud(lattice(4, 4) + 1e12, 0.0, "bad.ply"), {}, "bad.ply.*no common area"),
    (
        "no_area",
        Surface(GOOD.points, np.array([[0, 1, 2]], np.int32), "bad.ply"),
        {},  # the nodes that no triangle uses are no part of it
        "bad.ply.*all nodes lie on one line",
    ),
    ("nothing_short", GOOD, {"max_edge": 1e-9}, "good.ply and good.ply: no common area"),
]


@pytest.mark.parametrize(
    ("bad", "options", "message"), [b[1:] for b in BAD], ids=[b[0] for b in BAD]
)
def test_what_cannot_be_compared(bad: Surface, options: dict[str, Any], message: str) -> None:
    for pair in ((bad, GOOD), (GOOD, bad)):
        with pytest.raises(InputError, match=message) as caught:
            compare(*pair, **options)
        assert "\n" not in str(caught.value)


def test_coordinates_that_span_too_much() -> None:
    nodes = lattice(3, 3) * 1e140
    nodes[0] = [1e-140, 0.0]
    with pytest.raises(InputError, match="span too many magnitudes"):
        compare(cloud(nodes, 0.0), GOOD)


def test_hulls_that_touch_have_no_common_area() -> None:
    beside = cloud(lattice(5, 5) + np.array([1.0, 0.0]), 0.0, "beside.ply")
    with pytest.raises(InputError, match=r"^good\.ply and beside\.ply: no common area to compare$"):
        compare(GOOD, beside, domain="hull")
    assert compare(GOOD, beside, domain="plane").measures.area_compared == pytest.approx(2.0)


def test_duplicates_as_told() -> None:
    nodes = np.concatenate((lattice(3, 3), lattice(3, 3)))
    torn = cloud(nodes, np.repeat([1.0, 4.0], 9), "torn.ply")
    for how, value in (("mean", 2.5), ("max", 4.0), ("min", 1.0)):
        result = compare(torn, GOOD, duplicates=how, max_edge=np.inf)  # type: ignore[arg-type]
        assert result.measures.mean_abs == pytest.approx(value)
        assert result.grids[0].merged == 9
        assert result.options.duplicates == how


def test_a_pair_of_unlike_sizes_is_questioned() -> None:
    def square(side: float, name: str) -> Surface:
        return dataclasses.replace(cloud(lattice(5, 5, side), 0.0, name), unit="mm")

    assert compare(square(5.0, "a"), square(1.0, "b")).warnings == ()
    (question,) = compare(square(6.5, "a"), square(1.0, "b")).warnings
    assert question.startswith("a and b: one is 6.5 times as large as the other")
