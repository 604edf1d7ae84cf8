"""Nodes at one place: exactly, and up to what a motion has rounded off."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from surfcmp_core.projection import frame, moved
from surfcmp_core.projection.placement import look_at
from surfcmp_core.projection.places import same_place
from surfcmp_core.surface import Surface
from tests.core.sheets import sheet
from tests.core.turning import any_motion


def naive(nodes, room):
    """Join nodes that chains of others lead to, each within `room` in x and in y of the next."""
    group = np.arange(len(nodes))
    near = (np.abs(nodes[:, None] - nodes) <= room).all(axis=2)
    while True:
        onward = np.array([group[row].min() for row in near])
        if (onward == group).all():
            return {frozenset(np.flatnonzero(group == g).tolist()) for g in group.tolist()}
        group = onward


steps = st.integers(-3, 3)


@settings(max_examples=300)
@given(st.lists(st.tuples(*[st.integers(0, 2)] * 2, steps, steps), min_size=1, max_size=14))
def test_nodes_a_little_apart_are_at_one_place(drawn):
    """Wherever the borders of the cells lie among which they are sought."""
    room = 2.0**-44
    places = np.array(drawn, np.float64)
    nodes = 61.0 * room * places[:, :2] + 0.75 * room * places[:, 2:]
    z = np.arange(len(nodes)) % 3.0
    members, starts = same_place(nodes, z, room)
    found = [set(part.tolist()) for part in np.split(members, starts[1:])] if len(starts) else []
    # boxes: a chain of steps in x and one of steps in y may join what no chain of both does
    assert all(any(one <= each for each in found) for one in naive(nodes, room) if len(one) > 1)
    for part in np.split(members, starts[1:]) if len(starts) else []:
        assert (np.lexsort((part, z[part])) == np.arange(len(part))).all()
        for values in nodes[part].T:
            assert (np.diff(np.sort(values)) <= room).all()


def test_without_room_one_bit_parts_nodes():
    nodes = np.array([[1.0, 2.0], [1.0, np.nextafter(2.0, 3.0)], [1.0, 2.0], [0.0, 0.0]])
    members, starts = same_place(nodes, np.array([5.0, 4.0, 3.0, 2.0]))
    np.testing.assert_array_equal(members, [2, 0])
    np.testing.assert_array_equal(starts, [0])
    members, _ = same_place(nodes, np.array([5.0, 4.0, 3.0, 2.0]), 1e-15)
    np.testing.assert_array_equal(members, [2, 1, 0])


def box(n: int = 4) -> Surface:
    """Return a closed cube of 2 with walls of many triangles."""
    lid = sheet(lambda x, y: 1.0 + 0.0 * x, n=n)
    points, faces = [], []
    for axis in range(3):
        for sign in (1.0, -1.0):
            side = np.roll(lid.points, axis, axis=1) * sign
            faces.append(lid.faces[:, :: int(sign)] + len(lid.points) * len(points))
            points.append(side)
    return Surface(np.concatenate(points), np.concatenate(faces).astype(np.int32), "box")


@pytest.mark.parametrize("seed", range(6))
def test_turned_box_shows_its_lid_and_no_wall(seed):
    still = look_at(box(), (0.0, 0.0, 1.0))
    assert set(still.part.points[:, 2]) == {1.0}
    motion = any_motion(np.random.default_rng(seed), 20.0 + 25.0 * seed, 50.0, np.zeros(3))
    turned = moved(box(), motion)
    sight = look_at(turned, tuple(motion[:3, 2]))
    np.testing.assert_array_equal(sight.removed.kept, still.removed.kept)
    np.testing.assert_array_equal(sight.removed.fate, still.removed.fate)
    assert sight.removed.area == pytest.approx(still.removed.area)


@pytest.mark.parametrize("seed", range(6))
def test_turned_layers_show_the_upper_one(seed):
    x, y = np.meshgrid(np.arange(13.0), np.arange(11.0))
    layer = np.column_stack((x.ravel(), y.ravel(), np.zeros(x.size)))
    layers = Surface(np.concatenate((layer, layer + np.array([0.0, 0.0, 1.0]))))
    motion = any_motion(np.random.default_rng(seed), 10.0 + 12.0 * seed, 100.0, np.zeros(3))
    for view in ("auto", tuple(motion[:3, 2])):
        sight = look_at(moved(layers, motion), view)
        assert sight.removed.nodes == {"hidden": layer.shape[0]}
        upper = sight.motion[2, :3] @ motion[:3, 2] > 0.0
        assert ((sight.removed.kept >= len(layer)) == upper).all()


def test_terrace_keeps_one_height_at_its_edge_however_it_lies():
    lower = sheet(lambda x, y: 0.0 * x, n=7)
    upper = lower.points + np.array([2.0, 0.0, 1.0])
    faces = np.concatenate((lower.faces, lower.faces + 49)).astype(np.int32)
    terrace = Surface(np.concatenate((lower.points, upper)), faces)
    tilt = frame([0.3, 0.7, -0.2])
    sight = look_at(moved(terrace, tilt), tuple(tilt[:3, 2]))
    assert sight.removed.nodes == {"hidden": 7}
