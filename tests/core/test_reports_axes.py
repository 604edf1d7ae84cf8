"""Axes that files state are told, and made one for a pair."""

import json
from pathlib import Path

import numpy as np
import pytest

from app.__main__ import main
from surfcmp_core import compare, read_surface
from surfcmp_core.report import make_record
from tests.core import surface_files as files
from tests.core.reported_files import REPORTS


def test_axes_of_a_pair_are_made_one() -> None:
    ras, lps = (read_surface(REPORTS / f"slicer_{name}.ply") for name in ("ras", "lps"))
    assert (ras.space, lps.space) == ("RAS", "LPS")
    for pair, turned in (((ras, lps), 0), ((lps, ras), 1)):
        result = compare(*pair)
        assert result.measures.max_abs == 0
        assert result.surfaces[turned].changed == {"nodes turned from RAS to LPS": 16}
        assert result.surfaces[turned].turned
    document = make_record(compare(lps, ras))
    assert document["transform"] == np.diag([-1.0, -1.0, 1.0, 1.0]).tolist()


def test_a_view_is_told_in_the_axes_of_the_first_file(tmp_path: Path) -> None:
    names = ("slicer_ras.ply", "slicer_lps.ply")
    views = []
    for pair, view in ((names, "view:0.5,0.25,1"), (names[::-1], "view:-0.5,-0.25,1")):
        out = tmp_path / "r.json"
        arguments = ["compare", *(str(REPORTS / name) for name in pair), "--project", view]
        assert main([*arguments, "--quiet", "--out", str(out)]) == 0
        views.append(json.loads(out.read_text(encoding="utf-8"))["options"]["view"])
    assert views[0] == views[1]  # in the axes of the comparison


def test_info_says_the_axes(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["info", str(REPORTS / "slicer_lps.ply")]) == 0
    assert ["axes", "LPS"] in [row.split() for row in capsys.readouterr().out.splitlines()]


def test_equal_axes_stay() -> None:
    ras = read_surface(REPORTS / "slicer_ras.ply")
    assert compare(ras, ras).surfaces[0].points is ras.points


def test_axes_that_one_file_states_only_are_warned_of() -> None:
    stated, silent_one = (read_surface(REPORTS / n) for n in ("slicer_ras.ply", "flat0.ply"))
    note = "slicer_ras.ply says that its axes are RAS, flat0.ply does not say: taken as RAS too"
    assert note in compare(stated, silent_one).warnings
    assert note in compare(silent_one, stated).warnings


@pytest.mark.parametrize(
    ("comment", "space"),
    [
        ("3D Slicer output. SPACE=LPS", "LPS"),
        ("SPACE=right-anterior-superior", "RAS"),
        ("CoordinateSystem = LPS", "LPS"),
        ("SPACE=LPS SPACE=RAS", None),
        ("SPACE=LIA", None),
        ("a space between", ""),
    ],
)
@pytest.mark.parametrize("ending", ["ply", "obj", "vtk", "stl", "off", "xyz"])
def test_axes_that_files_state(
    ending: str, comment: str, space: str | None, tmp_path: Path
) -> None:
    content = {
        "ply": lambda: files.ply_text(files.SQUARE, comment=comment),
        "obj": lambda: files.obj(files.SQUARE, comment=comment),
        "vtk": lambda: files.vtk_text(files.SQUARE, title=comment),
        "stl": lambda: files.stl_binary(files.SQUARE).replace(
            b"made by a test".ljust(80), comment.encode().ljust(80, b"\0"), 1
        ),
        "off": lambda: f"OFF # {comment}\n".encode() + files.off(files.SQUARE)[4:],
        "xyz": lambda: f"# {comment}\n".encode() + files.xyz(files.SQUARE),
    }[ending]()
    path = tmp_path / f"a.{ending}"
    path.write_bytes(content)
    surface = read_surface(path)
    assert surface.space == (space or None)
    assert any("axes" in what for what in surface.changed) == (space is None)


@pytest.mark.parametrize("mode", ["ascii", "binary", "appended"])
def test_axes_and_unit_in_the_strings_of_a_vtp(mode: str, tmp_path: Path) -> None:
    vtk = pytest.importorskip("vtkmodules.all")
    points = vtk.vtkPoints()
    for node in files.SQUARE.tolist():
        points.InsertNextPoint(node)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    for name, word in (("SPACE", "LPS"), ("Units", "cm"), ("Operator", "unit m")):
        array = vtk.vtkStringArray()
        array.SetName(name)
        array.InsertNextValue(word)
        data.GetFieldData().AddArray(array)
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetFileName(str(tmp_path / "a.vtp"))
    writer.SetInputData(data)
    getattr(writer, f"SetDataModeTo{mode.capitalize()}")()
    assert writer.Write() == 1
    surface = read_surface(tmp_path / "a.vtp")
    assert (surface.unit, surface.space) == ("mm", "LPS")
    assert np.allclose(surface.points, 10 * files.SQUARE)
