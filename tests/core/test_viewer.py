"""What a viewer sees: whatever lies in front hides, and both surfaces are seen on one side."""

import json
from dataclasses import replace
from itertools import product
from pathlib import Path

import numpy as np
import pytest

from app.__main__ import main
from surfcmp_core import compare
from surfcmp_core.projection import moved, seen_from_behind
from surfcmp_core.projection.placement import look_at, place
from surfcmp_core.surface import Surface
from tests.core.sheets import sheet
from tests.core.turning import any_motion

REPORTS = Path(__file__).parent / "fixtures" / "reports"


def mask(n: int, widest: float = 180.0) -> Surface:
    """Return the front of an ellipsoid's head and both its cheeks, open at the back."""
    yaw, pitch = np.meshgrid(
        np.linspace(-1.0, 1.0, n) * np.arccos(-20.0 / 95.0),
        np.linspace(-1.2, 1.2, n),
        indexing="ij",
    )
    surface = sheet(lambda x, y: 0.0 * x, n=n)
    points = np.stack(
        (
            65.0 * np.sin(yaw) * np.cos(pitch),
            90.0 * np.sin(pitch),
            95.0 * np.cos(yaw) * np.cos(pitch),
        ),
        axis=-1,
    ).reshape(-1, 3)
    faces = surface.faces[:, ::-1]
    middle = points[faces].mean(axis=1)
    narrow = np.degrees(np.arctan2(middle[:, 0], middle[:, 2])) < widest
    return Surface(points, np.ascontiguousarray(faces[narrow]), f"mask {n}")


PAIR = mask(61), mask(67, 93.0)


def view_at(yaw: float) -> tuple[float, float, float]:
    return float(np.sin(np.radians(yaw))), 0.0, float(np.cos(np.radians(yaw)))


@pytest.mark.parametrize("yaw", [0, 45, 80, 84, 86, 87, 88, 90, 92, 95, 110, -87])
def test_cheeks_are_compared_with_cheeks_in_every_view(yaw):
    placed = place(*PAIR, view_at(float(yaw)))
    assert not any(removed.reversed for removed in placed.removed)
    measures = compare(*placed.surfaces).measures
    assert measures.mean_abs < 0.05


def ray_hits(surface: Surface, places: np.ndarray) -> np.ndarray:
    """Give how far the highest triangle of a mesh lies above each place (x, y, z)."""
    a, b, c = (surface.points[corner] for corner in surface.faces.T)
    above = np.full(len(places), -np.inf)
    for k, (x, y, z) in enumerate(places):
        shares = [
            (p[:, 0] - x) * (q[:, 1] - y) - (p[:, 1] - y) * (q[:, 0] - x)
            for p, q in ((b, c), (c, a), (a, b))
        ]
        total = sum(shares)
        inside = np.all([share * np.sign(total) > 0.0 for share in shares], axis=0)
        height = sum(s[inside] * p[inside, 2] for s, p in zip(shares, (a, b, c), strict=True))
        if inside.any():
            above[k] = (height / total[inside]).max() - z
    return above


@pytest.mark.parametrize("yaw", [86.0, 100.0, 130.0, 160.0])
def test_nothing_that_is_kept_is_hidden_by_the_mesh_itself(yaw):
    whole = PAIR[0]
    sight = look_at(whole, view_at(yaw))
    middles = sight.part.points[sight.part.faces].mean(axis=1)
    assert len(middles) > 100
    assert ray_hits(moved(whole, sight.motion), middles).max() < 1e-9


def test_inside_of_a_bowl_is_looked_at_from_its_back_where_that_is_all_that_shows():
    bowl = sheet(lambda x, y: x**2 + y**2, n=15)
    outer = replace(bowl, faces=bowl.faces[:, ::-1], name="bowl")
    placed = place(outer, outer, (0.0, 0.0, 1.0))
    assert [removed.reversed for removed in placed.removed] == [True, True]
    assert len([w for w in placed.warnings if "from its back" in w]) == 2


def test_sides_in_doubt_go_by_the_other_surface():
    # from the side and behind, the inner side of the far cheek shows beside the near one
    sides = [seen_from_behind(moved(one, look_at(one, view_at(120.0)).motion)) for one in PAIR]
    both = seen_from_behind(*[moved(one, look_at(one, view_at(120.0)).motion) for one in PAIR])
    assert both[0] == both[1]
    assert both[0] in {side[0] for side in sides}


def test_debris_in_front_hides_nothing_whichever_way_it_winds():
    surface = sheet(lambda x, y: 0.0 * x, n=20)
    speck = sheet(lambda x, y: 5.0 + 0.0 * x, n=3)
    points = np.concatenate((surface.points, speck.points * [0.03, 0.03, 1.0]))
    faces = np.concatenate((surface.faces, speck.faces[:, ::-1] + 400)).astype(np.int32)
    sight = look_at(Surface(points, faces), (0.0, 0.0, 1.0))
    assert len(sight.part.faces) == len(surface.faces)
    lid = np.concatenate((surface.points, speck.points * [0.3, 0.3, 1.0]))
    sight = look_at(Surface(lid, faces), (0.0, 0.0, 1.0))
    assert len(sight.part.faces) < len(surface.faces)


UP_OR_DOWN = ("", "_wound_down")


@pytest.mark.parametrize(("one", "other"), list(product(UP_OR_DOWN, UP_OR_DOWN)))
@pytest.mark.parametrize("turned", [False, True])
def test_no_sign_flips_unsaid(one, other, turned, tmp_path, capsys):
    from surfcmp_core.io import read_surface

    files = [REPORTS / f"flat1{one}.ply", REPORTS / f"flat0{other}.ply"]
    along_z = compare(*map(read_surface, files)).measures.mean_signed
    if turned:
        motion = any_motion(np.random.default_rng(0), 25.0, 3.0, np.zeros(3))
        for k, file in enumerate(files):
            surface = moved(read_surface(file), motion)
            files[k] = tmp_path / file.with_suffix(".npz").name
            meta = json.dumps({"units": "mm"})
            np.savez(files[k], points=surface.points, faces=surface.faces, meta=meta)
    assert main(["compare", *map(str, files), "--project", "auto", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    warnings = [w for w in document["warnings"] if "wind" in w]
    against = [file.name for file in files if "down" in file.name]
    if one == other == "":
        assert not warnings
    if one == other:
        assert document["options"]["reversed"] == [False, False]
    else:
        assert len(warnings) == 1
        assert warnings[0].startswith(f"{against[0]}: its triangles wind against those of ")
        assert document["options"]["reversed"] == [bool(one), bool(other)]
    signed = document["measures"]["mean_signed"]
    if one == other != "":
        assert signed == pytest.approx(-along_z)
        assert "signs count towards that viewer" in warnings[0]
        assert all(name in warnings[0] for name in against)
        assert document["options"]["view"][2] < -0.5
    else:
        assert signed == pytest.approx(along_z)
        assert document["options"]["view"][2] > 0.5


def test_table_says_from_where_both_are_seen(capsys):
    files = [str(REPORTS / "flat1_wound_down.ply"), str(REPORTS / "flat0.ply")]
    assert main(["compare", *files, "--project", "auto"]) == 0
    said = capsys.readouterr().out
    assert "seen from      0.0000, 0.0000, 1.0000: 0.0° from z, found from the surfaces" in said
    assert "from its back  surface 1" in said
    assert main(["compare", *files]) == 0
    assert "+z of the files" in capsys.readouterr().out
