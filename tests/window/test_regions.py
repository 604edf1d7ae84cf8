"""Regions: what they cover, and that their measures add up to the whole."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from app.jobs.region_measures import (
    beside,
    inside,
    measured_regions,
    region_mask,
    region_of,
    weighted,
    with_tolerances,
)
from app.model.region import Region, Stroke
from surfcmp_core.comparing.comparison import Comparison

SQUARE = ((-30.0, -30.0), (10.0, -30.0), (10.0, 10.0), (-30.0, 10.0))
REGIONS = (
    Region("square", (200, 0, 0), 2.0, strokes=(Stroke(SQUARE),)),
    Region("disc", (0, 200, 0), 0.5, strokes=(Stroke(((10.0, 10.0),), 15.0),)),
)


def test_a_point_lies_inside_a_polygon_or_not():
    x, y = (axis.ravel() for axis in np.meshgrid(np.linspace(-2, 3, 26), np.linspace(-2, 3, 26)))
    star = np.array([(0.0, 2.05), (0.6, -1.05), (-1.05, 1.05), (1.05, 1.05), (-0.6, -1.05)])
    square = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    expected = (x >= 0) & (x < 1) & (y >= 0) & (y < 1)
    assert (inside(square)(x, y) == expected).sum() >= len(x) - 30
    assert 0 < inside(star)(x, y).sum() < len(x)
    assert (inside(star)(x, y) == inside(star[::-1])(x, y)).all()


def test_a_brush_covers_what_is_near_its_path():
    rng = np.random.default_rng(3)
    x, y = rng.uniform(-5, 5, (2, 4000))
    path = np.array([(-3.0, -2.0), (0.0, 2.0), (0.0, 2.0), (3.0, -1.0)])
    steps = np.linspace(0, 1, 2001)[:, None]
    dense = np.concatenate([a + steps * (b - a) for a, b in pairwise(path)])
    near = np.min([np.hypot(x - px, y - py) for px, py in dense], axis=0)
    assert (beside(path, 0.8)(x, y) == (near <= 0.8)).mean() > 0.999
    dot = beside(path[:1], 0.8)(x, y)
    assert (dot == (np.hypot(x + 3, y + 2) <= 0.8)).all()


def test_strokes_add_and_take_away_in_their_order():
    x, y = np.array([0.0, 2.0, 4.0, 9.0]), np.zeros(4)
    square = Stroke(((-1.0, -1.0), (5.0, -1.0), (5.0, 1.0), (-1.0, 1.0)))
    eraser = Stroke(((1.0, 0.0), (4.5, 0.0)), 0.6, takes=True)
    dab = Stroke(((4.0, 0.0),), 0.1)
    for strokes, expected in (
        ((square,), [1, 1, 1, 0]),
        ((square, eraser), [1, 0, 0, 0]),
        ((square, eraser, dab), [1, 0, 1, 0]),
        ((eraser, square), [1, 1, 1, 0]),
        ((), [0, 0, 0, 0]),
    ):
        assert region_mask(x, y, Region("r", (0, 0, 0), strokes=strokes)).tolist() == expected


def test_later_regions_lie_over_earlier_ones(small: Comparison):
    number = region_of(small, REGIONS)
    x, y = small.united.nodes[small.united.triangles].mean(axis=1).T
    disc = (x - 10) ** 2 + (y - 10) ** 2 <= 15**2
    square = (abs(x + 10) < 20) & (abs(y + 10) < 20)
    assert (number[disc] == 1).all()
    assert (number[square & ~disc] == 0).all()
    assert (number[~square & ~disc] == -1).all()


@pytest.mark.parametrize(
    "key", ["area_compared", "volume_above", "volume_below", "rho_V", "rho_delta_V"]
)
def test_regions_add_up_to_the_whole(small: Comparison, key: str):
    found = measured_regions(small, REGIONS, region_of(small, REGIONS))
    assert [part.region for part in found] == [*REGIONS, None]
    parts = [getattr(part.measures, key) for part in found]
    assert sum(parts) == pytest.approx(getattr(small.measures, key), rel=1e-12)
    assert sum(part.triangles for part in found) == small.compared.sum()


def test_an_empty_region_has_no_measures(small: Comparison):
    far = Region("far", (0, 0, 0), strokes=(Stroke(((1e6, 0.0),), 1.0),))
    assert measured_regions(small, (far,), region_of(small, (far,)))[0].measures is None
    assert measured_regions(small, (), region_of(small, ())) == ()


def test_the_weight_counts_in_one_sum_only(small: Comparison):
    found = measured_regions(small, REGIONS, region_of(small, REGIONS))
    measures = weighted(small, REGIONS, region_of(small, REGIONS)).measures
    expected = sum(
        part.measures.rho_V * (part.region.weight if part.region else 1.0) for part in found
    )
    assert measures.rho_V_mu == pytest.approx(expected, rel=1e-12)
    assert replace(measures, rho_V_mu=small.measures.rho_V_mu) == small.measures
    plain = tuple(replace(region, weight=1.0) for region in REGIONS)
    assert weighted(small, plain, region_of(small, plain)) is small


def test_other_tolerances_change_nothing_else(small: Comparison):
    other = with_tolerances(small, (0.25, 3.0))
    assert set(other.measures.within_tolerance) == {"0.25", "3"}
    assert replace(other.measures, within_tolerance={}) == replace(
        small.measures, within_tolerance={}
    )
