"""The viewing direction."""

from dataclasses import replace

import numpy as np
import pytest

from surfcmp_core.errors import InputError
from surfcmp_core.projection import frame, moved, schlicht_part, viewing_direction
from surfcmp_core.surface import Surface
from tests.core.sheets import sheet
from tests.core.turning import any_motion, mirrored_back

FACES = [
    ("face_nricp_source", "face_nricp_target"),
    ("face_demo_10k", "face_demo_1k"),
    ("face_avg_f18", "face_avg_f66"),
    ("face_ict_neutral", "face_ict_smile"),
    ("face_avg_f18",),
    ("face_avg_f66",),
    ("face_leeperrysmith",),
    ("face_fran",),
    ("face_james",),
    ("made_face", "made_face_later"),
    ("made_face_fine", "made_face_coarse"),
    ("made_face_later",),
]
OTHERS = [
    ("jaw_crowns_ref_L0", "jaw_crowns_pred_L0"),
    ("ct_skin", "ct_skull"),
    ("jaw_cast_3shape",),
    ("made_jaw", "made_jaw_later"),
    ("made_skin", "made_bone"),
]


def angle(u, v) -> float:
    return float(np.degrees(np.arccos(np.clip(u @ v, -1.0, 1.0))))


def test_gentle_slope_is_seen_along_its_normal():
    surface = sheet(lambda x, y: 0.2 * x + 0.1 * y)
    normal = np.array([-0.2, -0.1, 1.0]) / np.linalg.norm([0.2, 0.1, 1.0])
    assert angle(viewing_direction(surface), normal) < 0.5


def test_outer_side_faces_the_viewer():
    surface = sheet(lambda x, y: -(x**2) - y**2)
    turned_over = replace(surface, faces=surface.faces[:, ::-1])
    assert angle(viewing_direction(surface), np.array([0.0, 0.0, 1.0])) < 5.0
    assert angle(viewing_direction(turned_over), np.array([0.0, 0.0, -1.0])) < 5.0


def test_steep_cliff_is_seen_from_where_it_hides_nothing():
    # from straight above the cliff shows; from ten degrees to the left it would be hidden
    surface = sheet(lambda x, y: 2.0 * np.tanh(12.0 * x), n=60)
    direction = viewing_direction(surface)
    assert direction[0] < 0.1
    _, removed = schlicht_part(moved(surface, frame(direction)))
    assert not removed.nodes


def test_closed_mesh_that_shows_half_in_every_view_casts_its_largest_shadow():
    dome = sheet(lambda x, y: 0.3 * np.cos(x) * np.cos(y), wide=1.3)
    closed = mirrored_back(dome, flatter=0.2)
    assert abs(viewing_direction(closed)[2]) > np.cos(np.radians(6.0))


def turned_directions(surfaces, seeds):
    for seed in seeds:
        rng = np.random.default_rng(seed)
        motion = any_motion(rng, rng.uniform(5.0, 180.0), 300.0, np.zeros(3))
        yield motion, viewing_direction(*[moved(s, motion) for s in surfaces])


@pytest.mark.parametrize("closed", [False, True])
def test_turned_mesh_has_the_turned_direction(closed):
    surface = sheet(lambda x, y: np.exp(-3 * (x - 0.2) ** 2 - 2 * y**2) + 0.3 * x * y - x**2 / 3)
    if closed:
        surface = mirrored_back(surface, flatter=1.0)  # front and back tie
    direction = viewing_direction(surface)
    for motion, found in turned_directions([surface], range(5)):
        np.testing.assert_allclose(found, motion[:3, :3] @ direction, atol=1e-9)


@pytest.mark.parametrize("names", FACES + OTHERS, ids=" ".join)
def test_real_scans(scan, names):
    surfaces = [scan(name) for name in names]
    direction = viewing_direction(*surfaces)
    if names in FACES:
        assert angle(direction, np.array([0.0, 0.0, 1.0])) < 10.0
    for motion, found in turned_directions(surfaces, [1]):
        np.testing.assert_allclose(found, motion[:3, :3] @ direction, atol=1e-6)


@pytest.mark.parametrize("flatter", [0.05, 0.3, 1.0])
def test_closed_face_is_seen_from_the_front(scan, flatter):
    closed = mirrored_back(scan("face_demo_10k"), flatter)
    assert angle(viewing_direction(closed), np.array([0.0, 0.0, 1.0])) < 10.0


@pytest.mark.parametrize(
    "name", ["face_demo_10k", "face_avg_f18", "face_avg_f66", "face_fran", "made_face"]
)
@pytest.mark.parametrize("turned", [False, True])
def test_face_with_a_loose_mirrored_back_is_seen_from_the_front_or_its_image(scan, name, turned):
    face = scan(name)
    n = len(face.points)
    back = face.points * [1.0, 1.0, -1.0] + [0.0, 0.0, 2.0 * face.points[:, 2].min()]
    both = replace(
        face,
        points=np.concatenate((face.points, back)),
        faces=np.concatenate((face.faces, face.faces[:, ::-1] + n)).astype(np.int32),
    )
    motion = any_motion(np.random.default_rng(2), 100.0 * turned, 0.0, np.zeros(3))
    direction = viewing_direction(moved(both, motion)) @ motion[:3, :3]
    assert abs(direction[2]) > np.cos(np.radians(10.0))


def test_cloud_is_seen_along_the_normal_of_its_plane_from_above():
    rng = np.random.default_rng(0)
    points = rng.normal(size=(500, 3)) * [5.0, 3.0, 0.01]
    direction = viewing_direction(Surface(points))
    assert angle(direction, np.array([0.0, 0.0, 1.0])) < 1.0
    for seed in range(8):
        motion = any_motion(np.random.default_rng(seed), 20.0 * seed, 5.0, np.zeros(3))
        found = viewing_direction(moved(Surface(points), motion))
        assert found[2] > 0.0
        assert abs(found @ motion[:3, :3] @ direction) > 1.0 - 1e-9
    for axis in (1, 0):  # upright: +y then +x is above
        upright = Surface(np.roll(points * [1.0, 1.0, 0.0], axis - 2, axis=1))
        assert viewing_direction(upright)[axis] > 0.9


def test_mesh_speaks_for_the_cloud_beside_it():
    surface = sheet(lambda x, y: 0.2 * x)
    cloud = Surface(np.random.default_rng(0).normal(size=(100, 3)) * [0.01, 5.0, 3.0])
    np.testing.assert_array_equal(viewing_direction(surface, cloud), viewing_direction(surface))


def test_nodes_on_a_line_have_no_direction():
    with pytest.raises(InputError, match="lie on one line"):
        viewing_direction(Surface(np.outer(np.arange(5.0), [1.0, 2.0, 3.0]), name="thread"))


def test_debris_has_no_say():
    dome = mirrored_back(sheet(lambda x, y: 0.3 * np.cos(x) * np.cos(y), wide=1.3), 0.2)
    specks = [dome.points[dome.faces[k]] + np.array([0.0, 9.0 * k, 30.0]) for k in (1, 2)]
    both = replace(
        dome,
        points=np.concatenate((dome.points, *specks)),
        faces=np.concatenate((dome.faces, np.arange(6).reshape(2, 3) + len(dome.points))).astype(
            np.int32
        ),
    )
    np.testing.assert_allclose(viewing_direction(both), viewing_direction(dome), atol=0.02)


@pytest.mark.parametrize("name", ["face_ict_neutral", "face_demo_10k", "face_avg_f66"])
def test_closed_face_shows_its_largest_area(scan, name):
    # from the side the shadow is larger, but less of the face is seen
    closed = mirrored_back(scan(name), 0.3)
    direction = viewing_direction(closed)
    assert angle(direction, np.array([0.0, 0.0, 1.0])) < 10.0
    _, removed = schlicht_part(moved(closed, frame(direction)))
    for axis in ([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.7, 0.7]):
        _, other = schlicht_part(moved(closed, frame(axis)))
        assert other.area_kept < removed.area_kept
