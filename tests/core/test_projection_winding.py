"""Triangles that wind against their neighbours."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.projection import wound_alike
from surfcmp_core.projection.placement import look_at, place
from surfcmp_core.surface import Surface
from tests.core.sheets import sheet
from tests.core.turning import mirrored_back

KEY = "triangles turned to wind like their neighbours"


def turned_at_random(surface: Surface, share: float, seed: int) -> tuple[Surface, int]:
    against = np.random.default_rng(seed).random(len(surface.faces)) < share
    faces = surface.faces.copy()
    faces[against] = faces[against][:, [0, 2, 1]]
    return replace(surface, faces=faces), int(against.sum())


def directed(faces: NDArray[np.int32]) -> set[tuple[int, int]]:
    return {(int(t[i]), int(t[(i + 1) % 3])) for t in faces for i in range(3)}


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("share", [0.001, 0.1, 0.3])
def test_sheet_is_wound_alike_again(closed, share):
    surface = sheet(lambda x, y: 0.3 * np.cos(x) * np.cos(y), n=30)
    if closed:
        surface = mirrored_back(surface, 0.2)
    mixed, count = turned_at_random(surface, share, 1)
    assert count > 0
    found = wound_alike(mixed)
    assert found.changed == {KEY: count}
    assert len(directed(found.faces)) == found.faces.size
    assert directed(found.faces) == directed(surface.faces)
    np.testing.assert_array_equal(np.sort(found.faces), np.sort(surface.faces))
    assert wound_alike(found) is found
    sight, true = look_at(mixed), look_at(surface)
    np.testing.assert_allclose(sight.motion, true.motion, atol=1e-3)
    assert sight.removed.nodes == true.removed.nodes
    assert len(sight.part.faces) == len(true.part.faces)


def test_what_is_wound_alike_stays_the_very_same():
    surface = sheet(lambda x, y: x * y, n=6)
    cloud = replace(surface, faces=None)
    empty = replace(surface, faces=surface.faces[:0])
    beside = replace(surface, faces=surface.faces[:, ::-1])
    for one in (surface, cloud, empty, beside, mirrored_back(surface)):
        assert wound_alike(one) is one


def test_larger_part_of_each_piece_decides():
    one = sheet(lambda x, y: 0.0 * x, n=4)
    middle = np.abs(one.points[one.faces, 0]).mean(axis=1) < 0.4
    faces = one.faces.copy()
    faces[~middle] = faces[~middle][:, ::-1]
    points = np.cbrt(one.points)  # the middle column is a third of the triangles and wide
    both = Surface(
        np.concatenate((points, points - np.array([5.0, 0.0, 0.0]))),
        np.concatenate((faces, faces[:, ::-1] + 16)).astype(np.int32),
        changed={"faces that name a node twice": 3},
    )
    found = wound_alike(both)
    assert found.changed == {"faces that name a node twice": 3, KEY: 24}
    corners = found.points[found.faces]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (across[:18, 2] > 0.0).all()
    assert (across[18:, 2] < 0.0).all()


def test_edges_of_three_triangles_tie_nothing_and_a_strip_with_one_side_ends():
    points = np.random.default_rng(0).random((10, 3))
    fan = Surface(points, np.array([[0, 1, 2], [0, 1, 3], [0, 1, 4]], np.int32))
    assert wound_alike(fan) is fan
    strip = [(i, (i + 1) % 5, (i + 2) % 5) for i in range(5)]  # a Moebius band of five triangles
    assert len(wound_alike(Surface(points[:5], np.array(strip, np.int32))).faces) == 5


@settings(max_examples=200)
@given(st.lists(st.permutations(range(6)).map(lambda p: p[:3]), min_size=1, max_size=10))
def test_neighbours_agree_wherever_they_can(triangles):
    """Against trying all ways of turning."""
    points = np.random.default_rng(3).random((6, 3))
    faces = np.array(triangles, np.int32)
    found = wound_alike(Surface(points, faces)).faces
    np.testing.assert_array_equal(np.sort(found), np.sort(faces))
    edges = {}
    for t, face in enumerate(faces.tolist()):
        for i in range(3):
            a, b = face[i], face[(i + 1) % 3]
            edges.setdefault(frozenset((a, b)), []).append((t, a < b))
    pairs = [pair for pair in edges.values() if len(pair) == 2]

    def clashes(turned):
        return sum((p ^ turned[s]) == (q ^ turned[t]) for (s, p), (t, q) in pairs)

    turned = [
        tuple(np.roll(f, -np.argmin(f))) != tuple(np.roll(g, -np.argmin(g)))
        for f, g in zip(faces, found, strict=True)
    ]
    ways = [[bool(k >> t & 1) for t in range(len(faces))] for k in range(2 ** len(faces))]
    if min(map(clashes, ways)) == 0 and clashes([False] * len(faces)):
        assert clashes(turned) == 0


@pytest.mark.parametrize("name", ["face_demo_10k", "made_face_fine"])
def test_turned_triangles_of_a_pair_are_counted_and_none_is_lost(scan, name):
    face = scan(name)
    mixed, count = turned_at_random(face, 0.1, 2)
    placed = place(mixed, face, (0.0, 0.0, 1.0))
    assert placed.surfaces[0].changed == {KEY: count}
    assert not placed.surfaces[1].changed
    np.testing.assert_array_equal(placed.surfaces[0].points, placed.surfaces[1].points)
    assert not placed.removed[0].nodes


def test_upright_wall_has_nothing_to_show():
    wall = sheet(lambda x, y: 0.0 * x, n=4)
    upright = replace(wall, points=wall.points[:, [0, 2, 1]])
    with pytest.raises(InputError):
        look_at(upright, (0.0, 0.0, 1.0))
