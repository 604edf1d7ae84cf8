"""A matrix given is in the unit of the files."""

import json
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from app.__main__ import main
from app.jobs.comparing import compared
from app.model.document import Document
from surfcmp_core import compare, read_surface
from surfcmp_core.surface.together import carried
from surfcmp_core.surface.units import SIZES
from surfcmp_core.system.progress import silent
from tests.core import surface_files as files
from tests.core.reported_files import written


def matrix_of(angle: float, shift: tuple[float, float, float]) -> np.ndarray:
    turn = np.eye(4)
    c, s = np.cos(angle), np.sin(angle)
    turn[:2, :2] = [[c, -s], [s, c]]
    turn[:3, 3] = shift
    return turn


@pytest.mark.parametrize("unit", ["mm", "cm", "m", "in", "us-ft"])
@pytest.mark.parametrize("how", ["option", "comment"])
@pytest.mark.parametrize("project", ["z", "auto"])
def test_a_matrix_is_in_the_unit_of_the_files(
    unit: str, how: str, project: str, tmp_path: Path
) -> None:
    rng = np.random.default_rng(11)
    points = np.column_stack((rng.uniform(-8, 8, (300, 2)), rng.uniform(-0.1, 0.1, 300)))
    motion = matrix_of(0.5, (3.0, -5.0, 0.25))  # B onto A, in their unit
    inverse = np.linalg.inv(motion)
    moved = points @ inverse[:3, :3].T + inverse[:3, 3]
    comment = f"unit {unit}" if how == "comment" else "no word of it"
    head = files.ply_header("ascii", 300, 0, comment=comment)
    for name, nodes in (("a", points), ("b", moved)):
        rows = "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in nodes.tolist())
        (tmp_path / f"{name}.ply").write_bytes(head + rows.encode())
    np.savetxt(tmp_path / "m.txt", motion, fmt="%.17g")
    out = tmp_path / "r.json"
    options = ["--unit", unit] if how == "option" else []
    options += ["--align", str(tmp_path / "m.txt"), "--out", str(out), "--project", project]
    pair = [str(tmp_path / name) for name in ("a.ply", "b.ply")]
    assert main(["compare", *pair, "--quiet", *options]) == 0
    document = json.loads(out.read_text(encoding="utf-8"))
    size = float(SIZES[unit])
    assert document["measures"]["max_abs"] <= 1e-12 * size
    assert document["options"]["align"]["matrix"] == motion.tolist()
    if project == "z":  # from the file's own coordinates to the comparison's, in mm
        told = np.array(document["transform"])
        np.testing.assert_allclose(told[:3, :3], motion[:3, :3] * size, rtol=0, atol=1e-12 * size)
        np.testing.assert_allclose(told[:3, 3], motion[:3, 3] * size, rtol=1e-15)
    else:
        placed = points @ np.array(document["options"]["view"]) * size
        there = moved @ np.array(document["transform"])[2, :3] + document["transform"][2][3]
        np.testing.assert_allclose(there, placed, atol=1e-11 * size)


def test_a_matrix_by_powers_of_two_keeps_every_bit() -> None:
    motion = matrix_of(0.7, (0.1, -0.3, 12345.678))
    told = carried(motion, Fraction(1, 1024), turned=True)
    assert np.array_equal(told[:3, 3] * 1024, motion[:3, 3] * [-1, -1, 1])
    back = carried(told, Fraction(1024), turned=True)
    assert np.array_equal(back, motion)
    assert np.array_equal(carried(motion, Fraction(1), turned=False), motion)


def test_a_matrix_between_unlike_files_counts_as_the_first(tmp_path: Path) -> None:
    # A in metres, B in millimetres: B is told in metres first, then shifted by 0.5 m
    one = written(tmp_path, "a.xyz", "m", 0.25)
    two = written(tmp_path, "b.xyz", "mm", 0.0)
    np.savetxt(tmp_path / "m.txt", matrix_of(0.0, (0.0, 0.0, 0.5)))
    out = tmp_path / "r.json"
    arguments = ["compare", str(one), str(two), "--align", str(tmp_path / "m.txt")]
    assert main([*arguments, "--quiet", "--out", str(out)]) == 0
    document = json.loads(out.read_text(encoding="utf-8"))
    assert document["options"]["unit"] == "mm"
    assert document["measures"]["max_abs"] == 250.0
    assert document["transform"][2] == [0.0, 0.0, 1.0, 500.0]
    surfaces = [read_surface(path) for path in (one, two)]
    again = compare(*surfaces, align=matrix_of(0.0, (0.0, 0.0, 0.5)))
    assert again.measures.max_abs == 250.0


def test_the_windows_motion_is_in_the_unit_of_the_files(tmp_path: Path) -> None:
    from surfcmp_core.comparing.options import Motion, Options

    one, two = (written(tmp_path, name, "cm", h) for name, h in (("a.obj", 0.5), ("b.obj", 0.0)))
    rows = matrix_of(0.0, (0.0, 0.0, 50.0)).tolist()  # 50 cm
    motion = Motion(tuple(tuple(row) for row in rows), "by hand")
    for unit in ("", "cm", "m"):  # what the user says does not move surface 2 anew
        document = Document((one, two), Options(align=motion, unit=unit or None))
        assert compared(document, None, silent).comparison.measures.max_abs == pytest.approx(0)
