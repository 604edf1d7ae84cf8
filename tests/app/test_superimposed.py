"""Both scans in one scene, without a screen."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.model.superimposition import Coat, Cut, Style, Superimposition
from app.scene.content import Content, content_of
from app.scene.superimposed import cut_of, difference_at, place_of, profile_on, superimposed
from surfcmp_core import Surface, compare
from surfcmp_core.colours.scale import Scale

SCALE = Scale(1.0, (), signed=True)


@pytest.fixture(scope="module")
def content() -> Content:
    """A plane, and one half a unit above it; T1 is finer than T2; moved by 2 along x."""
    motion = np.eye(4)
    motion[0, 3] = 2.0
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(9.0), np.arange(7.0)))
    one = Surface(np.column_stack((x, y, 0.1 * x)), name="one", unit="mm")
    some = (x % 2 == 0) & (y % 2 == 0)
    z = 0.1 * x + 0.5
    two = Surface(np.column_stack((x - 2.0, y, z))[some], name="two", unit="mm")
    return content_of(compare(one, two, align=motion, domain="hull"))


def test_each_scan_has_its_own_triangles_and_coat(content: Content) -> None:
    wish = Superimposition().dressed(1, Coat(0.25, Style.WIRE, heatmap=True))
    scene = superimposed(content, SCALE, wish, dark=False)
    for surface, skin in enumerate(scene.skins):
        assert len(skin.triangles) == content.comparison.triangulations[surface].real
        assert np.array_equal(skin.points, content.geometry.patches[surface].points)
    assert isinstance(scene.skins[0].colours, tuple)
    assert len(scene.skins[1].colours) == len(scene.skins[1].triangles)
    assert (scene.skins[1].opacity, scene.skins[1].style) == (0.25, Style.WIRE)
    again = superimposed(content, SCALE, wish, dark=False)
    assert again.skins[1].colours is scene.skins[1].colours  # so that nothing is sent twice


def test_fading_leaves_one_scan_and_a_flicker_the_other() -> None:
    both = Superimposition()
    assert (both.opacity(0), both.opacity(1)) == (1.0, 0.6)
    one = both.flickered()
    assert (one.opacity(0), one.opacity(1)) == (1.0, 0.0)
    two = one.flickered()
    assert (two.opacity(0), two.opacity(1)) == (0.0, 0.6)
    assert two.flickered() == one
    assert replace(both, fade=0.75).opacity(0) == 0.5


def test_before_it_was_moved_surface_2_lies_where_it_did(content: Content) -> None:
    now = superimposed(content, SCALE, Superimposition(), dark=False)
    before = superimposed(content, SCALE, Superimposition(before=True), dark=False)
    assert np.allclose(before.skins[1].points - now.skins[1].points, (-2.0, 0.0, 0.0), atol=1e-6)
    assert before.skins[0].points is now.skins[0].points


def test_the_plane_cuts_both_and_the_difference_on_it_is_told(content: Content) -> None:
    wish = Superimposition(cut=Cut(0, 0.3))
    scene = superimposed(content, SCALE, wish, dark=False)
    assert wish.cut is not None
    place = place_of(content.geometry, wish.cut)
    assert scene.plane == (0, place)
    again = superimposed(content, SCALE, wish, dark=False)
    assert again.curves[0] is scene.curves[0]  # so that nothing is cut or sent twice
    for curve in scene.curves:
        assert len(curve)
        assert np.allclose(curve[..., 0], place, atol=1e-5)
    d = profile_on(content.comparison, content.geometry, wish.cut).difference
    assert np.allclose(d[np.isfinite(d)], -0.5)


def test_the_difference_at_a_place_is_that_of_the_surfaces(content: Content) -> None:
    for surface in (0, 1):
        triangulation = content.comparison.triangulations[surface]
        for triangle in triangulation.triangles[:20]:
            place = triangulation.nodes[triangle].mean(axis=0)
            d = difference_at(content.comparison, surface, triangle, place)
            assert d == pytest.approx(-0.5) or np.isnan(d)


places = st.lists(st.tuples(*[st.integers(-3, 3)] * 3), min_size=3, max_size=12)


@given(places, st.integers(0, 2), st.sampled_from([-2.5, -0.5, 0.5, 1.5]))
def test_a_cut_is_where_triangles_cross_the_plane(
    points: list[tuple[int, int, int]], axis: int, place: float
) -> None:
    nodes = np.array(points, np.float32)
    triangles = np.array([(k, k + 1, k + 2) for k in range(len(nodes) - 2)], np.int32)
    found = cut_of(nodes, triangles, axis, place)
    expected = []
    for triangle in triangles:
        ends = []
        for a, b in ((0, 1), (1, 2), (2, 0)):
            p, q = nodes[triangle[a]].astype(float), nodes[triangle[b]].astype(float)
            if (p[axis] > place) != (q[axis] > place):
                ends.append(p + (place - p[axis]) / (q[axis] - p[axis]) * (q - p))
        if ends:
            expected.append(ends)
    assert len(found) == len(expected)
    for segment, ends in zip(found, expected, strict=True):
        assert np.allclose(segment, ends, atol=1e-5) or np.allclose(segment, ends[::-1], atol=1e-5)
