"""Facts of one surface, against counting by hand."""

from collections import Counter, defaultdict
from dataclasses import replace

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core.io import facts_of
from surfcmp_core.surface import Surface
from tests.core import surface_files as files

SQUARE = files.SQUARE


def test_a_plain_mesh():
    surface = Surface(
        SQUARE, files.TWO, name="a.ply", sha256="ab", unit="mm", dropped={"x": 1}, changed={"y": 2}
    )
    facts = facts_of(surface)
    assert (facts.name, facts.kind, facts.nodes, facts.triangles) == ("a.ply", "mesh", 4, 2)
    assert (facts.low, facts.high) == ((0, 0, -1), (1, 1, 0.5))
    assert (facts.unit, facts.sha256, facts.dropped, facts.changed) == (
        "mm",
        "ab",
        {"x": 1},
        {"y": 2},
    )
    assert (facts.repeated, facts.contradicting, facts.folded) == (0, 0, 0)
    assert facts.one_valued


def test_a_cloud():
    facts = facts_of(Surface(SQUARE))
    assert (facts.kind, facts.triangles, facts.folded, facts.one_valued) == ("cloud", 0, 0, True)


small = st.integers(-1, 1).map(float) | st.just(-0.0)


@given(st.lists(st.tuples(small, small, small), min_size=3, max_size=30).map(np.array))
def test_duplicates(points: NDArray[np.float64]):
    heights = defaultdict(set)
    for x, y, z in points.tolist():
        heights[x, y].add(z)
    facts = facts_of(Surface(points))
    assert facts.repeated == len(points) - len(Counter(map(tuple, points.tolist())))
    torn = [len(heights[x, y]) > 1 for x, y, _ in points.tolist()]
    assert facts.contradicting == sum(torn)
    assert facts.one_valued == (not any(torn))


def test_folding_is_the_smaller_side_by_projected_area():
    points = np.array([[0, 0, 0], [4, 0, 0], [4, 1, 0], [0, 1, 0], [2, 5, 9], [2, 0, 7]], float)
    up = np.array([[0, 1, 2], [0, 2, 3]], np.int32)  # area 4
    over = np.array([[1, 0, 5], [0, 3, 1]], np.int32)  # upright: no area; turned over: 2
    surface = Surface(points, np.vstack((up, over)))
    assert facts_of(surface).folded == 1 / 3
    assert facts_of(replace(surface, faces=surface.faces[:, ::-1])).folded == 1 / 3
    assert facts_of(replace(surface, points=points * 1e200)).folded == 1 / 3
    assert not facts_of(surface).one_valued
    assert facts_of(Surface(points, over[:1])).folded == 0


def test_a_closed_surface_is_half_folded():
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.2, 1]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], np.int32)
    assert abs(facts_of(Surface(corners, faces)).folded - 0.5) < 1e-15
