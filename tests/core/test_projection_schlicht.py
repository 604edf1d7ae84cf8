"""The one-valued part: against an exact oracle, and on shapes whose answer is known."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from surfcmp_core.errors import InputError
from surfcmp_core.projection import Fate, frame, moved, schlicht_part, viewing_direction
from surfcmp_core.surface import Surface
from tests.core.sheets import sheet
from tests.core.turning import mirrored_back


def exact(points):
    return [[Fraction(float(v)) for v in p] for p in points]


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def overlap(one, other):
    """Clip one counter-clockwise triangle by another, in rationals; heights come along."""
    polygon = list(one)
    for i in range(3):
        a, b = other[i], other[(i + 1) % 3]
        clipped = []
        for k, p in enumerate(polygon):
            q = polygon[(k + 1) % len(polygon)]
            sp, sq = turn(a, b, p), turn(a, b, q)
            if sp >= 0:
                clipped.append(p)
            if sp * sq < 0:
                t = sp / (sp - sq)
                clipped.append([p[j] + t * (q[j] - p[j]) for j in range(3)])
        polygon = clipped
        if len(polygon) < 3:
            return []
    area = sum(turn(polygon[0], polygon[k], polygon[k + 1]) for k in range(1, len(polygon) - 1))
    return polygon if area > 0 else []


def height(triangle, place):
    a, b, c = triangle
    total = turn(a, b, c)
    return (turn(b, c, place) * a[2] + turn(c, a, place) * b[2] + turn(a, b, place) * c[2]) / total


def naive_fates(points, faces):
    """Fates without islands; None where a tie of two leads leaves it open who is in front."""
    p = exact(points)
    fate = []
    for t in faces:
        side = turn(*(p[v] for v in t))
        fate.append(Fate.KEPT if side > 0 else Fate.BACK_FACING if side < 0 else Fate.DEGENERATE)
    front = [t for t in range(len(faces)) if fate[t] == Fate.KEPT]
    hidden = set()
    for i, s in enumerate(front):
        for t in front[i + 1 :]:
            one, other = [p[v] for v in faces[s]], [p[v] for v in faces[t]]
            leads = [q[2] - height(other, q) for q in overlap(one, other)]
            if not leads:
                continue
            if max(leads) == -min(leads) and set(faces[s]) != set(faces[t]):
                return None
            hidden.add(t if max(leads) >= -min(leads) else s)
        for t in range(len(faces)):
            if fate[t] == Fate.BACK_FACING:  # it hides, whichever side it shows
                one, other = [p[v] for v in faces[s]], [p[v] for v in faces[t][::-1]]
                leads = [height(other, q) - q[2] for q in overlap(one, other)]
                if leads and max(leads) == -min(leads) > 0:
                    return None
                if leads and max(leads) > -min(leads):
                    hidden.add(s)
    for t in hidden:
        fate[t] = Fate.HIDDEN
    top = {}
    for t in front:
        if fate[t] == Fate.KEPT:
            for v in faces[t]:
                place = (p[v][0], p[v][1])
                top[place] = max(top.get(place, p[v][2]), p[v][2])
    for t in front:
        if any(p[v][2] < top.get((p[v][0], p[v][1]), p[v][2]) for v in faces[t]):
            fate[t] = Fate.HIDDEN
    return fate


def assert_one_valued(part):
    p = exact(part.points)
    triangles = [[p[v] for v in t] for t in part.faces]
    assert all(turn(*t) > 0 for t in triangles)
    for i, one in enumerate(triangles):
        for other in triangles[i + 1 :]:
            assert not overlap(one, other)
    heights = {}
    for v in part.points:
        assert heights.setdefault((v[0], v[1]), v[2]) == v[2]


def assert_accounted(surface, part, removed):
    assert len(surface.points) == len(part.points) + sum(removed.nodes.values())
    assert len(surface.faces) == len(part.faces) + len(removed.faces)
    np.testing.assert_array_equal(part.points, surface.points[removed.kept])
    corners = surface.points[surface.faces]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(across, axis=1).sum() / 2.0
    assert removed.area_kept + sum(removed.area.values()) == pytest.approx(area)
    assert set(removed.area) == {Fate(f).label for f in removed.fate}
    for reason, count in removed.nodes.items():
        assert part.dropped[reason] == surface.dropped.get(reason, 0) + count


places = st.tuples(*[st.integers(0, 4)] * 2, st.integers(0, 3))


@settings(max_examples=150)
@given(st.lists(places, min_size=3, max_size=12), st.data())
def test_soup_of_triangles_against_the_oracle(nodes, data):
    numbers = st.integers(0, len(nodes) - 1)
    faces = np.array(
        data.draw(st.lists(st.tuples(numbers, numbers, numbers), min_size=1, max_size=14)),
        np.int32,
    )
    points = np.array(nodes, np.float64)
    points[:, 2] += data.draw(st.sampled_from([0.0, 0.1])) * np.sin(np.arange(len(points)) ** 2)
    surface = Surface(points, faces, "soup")
    try:
        part, removed = schlicht_part(surface, island=0.0)
    except InputError:
        return
    if removed.reversed:
        faces = faces[:, ::-1]
    fates = naive_fates(points, faces.tolist())
    if fates is not None:
        expected = faces[[f == Fate.KEPT for f in fates]]
        np.testing.assert_array_equal(removed.kept[part.faces], expected)
        np.testing.assert_array_equal(removed.fate, [f for f in fates if f != Fate.KEPT])
    assert_one_valued(part)
    assert_accounted(surface, part, removed)


@pytest.mark.parametrize("seed", range(4))
def test_crumpled_sheet_against_the_oracle(seed):
    # nodes pushed about by more than their spacing: folds of every kind in one connected mesh
    rng = np.random.default_rng(seed)
    surface = sheet(lambda x, y: 0.0 * x, n=9)
    surface = replace(surface, points=surface.points + rng.normal(size=(81, 3)) * 0.15)
    part, removed = schlicht_part(surface, island=0.0)
    fates = naive_fates(surface.points, surface.faces.tolist())
    np.testing.assert_array_equal(removed.fate, [f for f in fates if f != Fate.KEPT])
    assert Fate.HIDDEN in removed.fate
    assert_one_valued(part)
    assert_accounted(surface, part, removed)


def test_one_valued_mesh_stays_as_it_is():
    surface = sheet(lambda x, y: x * y, n=20)
    part, removed = schlicht_part(surface)
    np.testing.assert_array_equal(part.points, surface.points)
    np.testing.assert_array_equal(part.faces, surface.faces)
    assert not removed.nodes
    assert not part.dropped


def test_box_keeps_its_lid():
    corners = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], np.float64)
    quads = [(4, 5, 7, 6), (0, 2, 3, 1), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
    faces = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))], np.int32)
    part, removed = schlicht_part(Surface(corners, faces))
    assert set(part.points[:, 2]) == {1.0}
    assert removed.nodes == {"back-facing": 4}
    assert removed.area == {"degenerate": pytest.approx(4.0), "back-facing": pytest.approx(1.0)}
    inside_out, removed = schlicht_part(Surface(corners, faces[:, ::-1]))
    assert removed.reversed
    np.testing.assert_array_equal(inside_out.points, part.points)


def test_open_sheet_may_be_seen_from_behind():
    surface = sheet(lambda x, y: x * y, n=5)
    part, removed = schlicht_part(moved(surface, np.diag([1.0, -1.0, -1.0, 1.0])))
    assert removed.reversed
    assert len(part.faces) == len(surface.faces)
    assert_one_valued(part)


def test_fold_keeps_the_upper_layer():
    # an S seen from the side: two layers face up, the middle one faces down
    surface = sheet(lambda x, y: x, n=16)
    t = surface.points[:, 0].copy()
    surface.points[:, 0] = t**3 - 0.5 * t
    surface.points[:, 2] = t
    part, removed = schlicht_part(surface)
    assert set(removed.nodes) == {"back-facing", "hidden"}
    middle = part.points[np.abs(part.points[:, 0]) < 0.12]
    assert len(middle)
    assert middle[:, 2].min() > 0.5
    assert_accounted(surface, part, removed)
    assert_one_valued(part)


def test_step_keeps_one_height_at_its_edge():
    # a terrace with a vertical riser: the upper floor's edge stands over the lower floor's
    surface = sheet(lambda x, y: 0.0 * x, n=7)
    upper = surface.points + np.array([2.0, 0.0, 1.0])
    faces = np.concatenate((surface.faces, surface.faces + 49)).astype(np.int32)
    part, removed = schlicht_part(Surface(np.concatenate((surface.points, upper)), faces))
    assert removed.nodes == {"hidden": 7}
    assert_one_valued(part)


def test_nodes_written_once_for_each_triangle_still_hang_together():
    surface = sheet(lambda x, y: x * y, n=12)
    loose = Surface(
        surface.points[surface.faces].reshape(-1, 3),
        np.arange(surface.faces.size, dtype=np.int32).reshape(-1, 3),
    )
    part, removed = schlicht_part(loose, island=1.0)
    assert len(part.faces) == len(surface.faces)
    assert not removed.nodes


def test_islands_go_by_their_share_and_debris_hides_nothing():
    surface = sheet(lambda x, y: 0.0 * x, n=20)
    speck = sheet(lambda x, y: 5.0 + 0.0 * x, n=3)
    speck.points[:, :2] *= 0.03
    stray = np.array([[0.0, 0.0, 9.0]])
    both = Surface(
        np.concatenate((surface.points, speck.points, stray)),
        np.concatenate((surface.faces, speck.faces + 400)).astype(np.int32),
        dropped={"not finite": 2, "island": 1},
    )
    part, removed = schlicht_part(both)
    assert removed.nodes == {"island": 9, "unused": 1}
    assert part.dropped == {"not finite": 2, "island": 10, "unused": 1}
    assert len(part.faces) == len(surface.faces)
    _, removed = schlicht_part(both, island=0.0)
    assert "hidden" in removed.area
    assert "island" not in removed.area


def test_wide_overlap_far_from_any_border_is_found():
    lower = sheet(lambda x, y: 0.1 * x, n=60)
    upper = sheet(lambda x, y: 1.0 + 0.1 * y, n=47)
    upper.points[:, :2] *= 0.7
    both = Surface(
        np.concatenate((upper.points, lower.points)),
        np.concatenate((upper.faces, lower.faces + len(upper.points))).astype(np.int32),
    )
    part, removed = schlicht_part(both, island=0.0)
    assert len(part.faces) + len(removed.faces) == len(both.faces)
    kept_below = part.points[:, 2] < 0.5
    assert np.abs(part.points[kept_below, :2]).max(axis=1).min() > 0.7
    assert np.count_nonzero(~kept_below) == len(upper.points)
    assert set(removed.area) == {"hidden"}
    covered = 1.4**2 * np.hypot(1.0, 0.1)
    assert covered < removed.area["hidden"] < covered + 4 * 1.5 * 2 * (2 / 59)


def test_small_rest_of_a_hidden_sheet_is_an_island():
    lower = sheet(lambda x, y: 0.0 * x, n=20)
    lower.points[:, :2] = 0.3 * lower.points[:, :2] + [0.77, 0.0]  # sticks out by two columns
    upper = sheet(lambda x, y: 1.0 + 0.0 * x, n=30)
    both = Surface(
        np.concatenate((upper.points, lower.points)),
        np.concatenate((upper.faces, lower.faces + 900)).astype(np.int32),
    )
    part, removed = schlicht_part(both)
    assert (part.points[:, 2] == 1.0).all()
    assert 0.0 < removed.area["island"] < 0.01 * removed.area_kept
    _, removed = schlicht_part(both, island=0.0)
    assert set(removed.area) == {"hidden"}


def test_cloud_keeps_the_upper_node_of_each_place():
    points = np.array(
        [[0.0, 0, 1], [-0.0, 0, 2], [1, 0, 0], [1, 0, 0], [0, 1, 5], [0, 1, 4], [0, 1, 5]]
    )
    part, removed = schlicht_part(Surface(points))
    np.testing.assert_array_equal(removed.kept, [1, 2, 3, 4, 6])
    assert part.dropped == removed.nodes == {"hidden": 2}
    assert part.faces is None


def test_extreme_scales_change_nothing():
    rng = np.random.default_rng(5)
    surface = sheet(lambda x, y: 0.0 * x, n=9)
    surface = replace(surface, points=surface.points + rng.normal(size=(81, 3)) * 0.1)
    _, removed = schlicht_part(surface)
    for power in (-400, 240):
        scaled = replace(surface, points=np.ldexp(surface.points, [power, power, 0]))
        _, again = schlicht_part(scaled, island=0.0)
        _, once = schlicht_part(surface, island=0.0)
        np.testing.assert_array_equal(again.fate, once.fate)
    assert Fate.HIDDEN in removed.fate


def test_nothing_to_see_is_refused():
    surface = sheet(lambda x, y: 0.0 * x, n=3)
    upright = replace(surface, points=surface.points[:, [0, 2, 1]], name="wall")
    with pytest.raises(InputError, match="wall: no triangle faces the viewer"):
        schlicht_part(upright)


@pytest.mark.parametrize(
    "name", ["face_demo_1k", "face_nricp_source", "ct_skull", "made_face", "made_bone"]
)
def test_real_scans_are_one_valued_already(scan, name):
    surface = scan(name)
    part, removed = schlicht_part(surface)
    assert not removed.nodes
    np.testing.assert_array_equal(part.faces, surface.faces)


@pytest.mark.parametrize("name", ["face_demo_10k", "face_ict_smile", "made_face"])
def test_closed_face_gives_back_its_front(scan, name):
    face = scan(name)
    closed = mirrored_back(face)
    part, removed = schlicht_part(closed)
    np.testing.assert_array_equal(part.points, face.points)
    np.testing.assert_array_equal(part.faces, face.faces)
    assert set(removed.nodes) == {"back-facing"}
    assert_accounted(closed, part, removed)


@pytest.mark.parametrize("name", ["face_ict_smile", "made_face"])
def test_turned_scan_gives_the_same_part(scan, name):
    face = scan(name)
    direction = np.array([0.5, -0.1, 0.8])  # from the side: the nose hides a cheek
    part, removed = schlicht_part(moved(face, frame(direction)))
    assert removed.nodes["hidden"] > 20
    tilt = frame([0.3, 0.7, -0.2])
    again, _ = schlicht_part(moved(moved(face, tilt), frame(tilt[:3, :3] @ direction)))
    assert len(again.faces) == pytest.approx(len(part.faces), rel=1e-3)


@pytest.mark.parametrize("name", ["face_james", "made_face"])
def test_found_direction_shows_nearly_all(scan, name):
    face = scan(name)
    part, _ = schlicht_part(moved(face, frame(viewing_direction(face))))
    assert len(part.faces) > 0.995 * len(face.faces)
