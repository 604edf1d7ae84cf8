"""What files say of units and axes: every entrance gives the same numbers or the same refusal."""

import json
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.__main__ import main
from app.jobs.comparing import compared
from app.model.document import Document
from surfcmp_core import InputError, Surface, compare, read_surface
from surfcmp_core.alignment import best_fit
from surfcmp_core.cli.shared_options import UnitOption
from surfcmp_core.projection.placement import place
from surfcmp_core.report import make_document
from surfcmp_core.surface.together import bring_together, carried
from surfcmp_core.surface.units import SIZES, UNITS, converted
from surfcmp_core.system.progress import silent
from tests.core import surface_files as files

REPORTS = Path(__file__).parent / "fixtures" / "reports"

Told = dict[str, Any] | str
"""The .json result, or the refusal."""


def in_python(first: Path, second: Path, _folder: Path) -> Told:
    try:
        return make_document(compare(read_surface(first), read_surface(second)))
    except InputError as fault:
        return str(fault)


def by_command(first: Path, second: Path, folder: Path) -> Told:
    out = folder / "r.json"
    status = main(["compare", str(first), str(second), "--quiet", "--out", str(out)])
    if status:
        assert status == 3
        return "refused"
    found: dict[str, Any] = json.loads(out.read_text(encoding="utf-8"))
    return found


def in_batch(first: Path, second: Path, folder: Path) -> Told:
    out = folder / "pairs.json"
    main(["batch", str(first), str(second), "--quiet", "--out", str(out)])
    [found] = json.loads(out.read_text(encoding="utf-8"))["pairs"]
    return str(found["error"]) if "error" in found else dict(found)


def in_window(first: Path, second: Path, _folder: Path) -> Told:
    try:
        return compared(Document((first, second)), None, silent).record
    except InputError as fault:
        return str(fault)


ENTRANCES = (in_python, by_command, in_batch, in_window)


def written(folder: Path, name: str, unit: str, height: float) -> Path:
    """Write a plane of 9 m², `height` metres high, in the unit and the format of the name."""
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(4.0), np.arange(4.0)))
    size = float(SIZES[unit or "mm"] / SIZES["m"])
    points = np.column_stack((x, y, np.full(16, height))) / size
    corners = (0, 1, 2, 4, 5, 6, 8, 9, 10)
    faces = np.array([[a, a + 1, a + 5] for a in corners] + [[a, a + 5, a + 4] for a in corners])
    ending = name.rpartition(".")[2]
    comment = f"unit {unit}" if unit else "no word of it"
    units: dict[str, Any] = {"unit": unit} if unit else {}
    content = {
        "ply": lambda: files.ply_text(points, faces, comment=comment),
        "obj": lambda: files.obj(points, faces, comment=comment),
        "xyz": lambda: f"# {comment}\n".encode() + files.xyz(points),
        "npz": lambda: files.npz(points, faces, **units),
    }[ending]()
    path = folder / name
    path.write_bytes(content)
    return path


PAIRS = [
    # the first file, its unit; the second, its unit; the unit of the comparison
    ("a.ply", "m", "b.xyz", "m", "mm"),
    ("a.xyz", "m", "b.ply", "m", "mm"),
    ("a.xyz", "m", "b.npz", "m", "m"),
    ("a.xyz", "cm", "b.npz", "cm", "cm"),
    ("a.xyz", "um", "b.obj", "m", "mm"),
    ("a.xyz", "m", "b.npz", "mm", "mm"),
    ("a.npz", "mm", "b.xyz", "m", "mm"),
    ("a.xyz", "m", "b.npz", "ft", "m"),
    ("a.npz", "ft", "b.xyz", "us-ft", "m"),
    ("a.xyz", "in", "b.xyz", "ft", "mm"),
    ("a.obj", "in", "b.ply", "cm", "mm"),
    ("a.xyz", "km", "b.xyz", "yd", "m"),
    ("a.ply", "m", "b.ply", "", "mm"),
    ("a.xyz", "", "b.xyz", "m", "m"),
    ("a.xyz", "", "b.ply", "m", "mm"),
    ("a.ply", "", "b.xyz", "", "mm"),
]


@pytest.mark.parametrize(("first", "unit_1", "second", "unit_2", "unit"), PAIRS)
def test_all_entrances_bring_files_to_one_unit(
    first: str, unit_1: str, second: str, unit_2: str, unit: str, tmp_path: Path
) -> None:
    # a file that says nothing holds numbers in the unit that the other one states
    one = written(tmp_path, first, unit_1 or unit_2, 0.25)
    two = written(tmp_path, second, unit_2 or unit_1, 0.0)
    if not unit_1:
        one.write_bytes(one.read_bytes().replace(f"unit {unit_2}".encode(), b"nothing"))
    if not unit_2:
        two.write_bytes(two.read_bytes().replace(f"unit {unit_1}".encode(), b"nothing"))
    told = [entrance(one, two, tmp_path) for entrance in ENTRANCES]
    metre = float(SIZES["m"] / SIZES[unit])
    for found in told:
        assert isinstance(found, dict)
        assert found["options"]["unit"] == unit
        measures = found["measures"]
        assert measures["mean_abs"] == pytest.approx(0.25 * metre, rel=1e-12)
        if "us-ft" not in (unit_1, unit_2):  # else the borders are some last bits apart
            assert measures["area_compared"] == pytest.approx(9.0 * metre**2, rel=1e-12)
        assert measures == told[0]["measures"]  # type: ignore[index]
        assert found["warnings"] == told[0]["warnings"]  # type: ignore[index]
        quiet = [name for name, said in ((first, unit_1), (second, unit_2)) if not said]
        taken = f"no unit stated in {' and '.join(quiet)}: taken as {unit_1 or unit_2 or 'mm'}"
        assert (taken in found["warnings"]) == bool(quiet)
        for name, stated in ((first, unit_1 or unit_2), (second, unit_2 or unit_1)):
            line = f"{name}: 16 nodes converted from {stated} to {unit}"
            assert (line in found["warnings"]) == (bool(stated) and stated != unit)


REFUSED = [
    ("las_metre.las", "las_foot.las", "las_foot.las: is in ft, but the other surface in m"),
    ("las_metre.las", "las_wkt2_usft.las", "las_wkt2_usft.las: is in us-ft, but the other"),
    (
        "las_metre_plus_usft_heights.las",
        "las_metre.las",
        "las_metre_plus_usft_heights.las: its heights are in us-ft, but its x and y in m",
    ),
]


@pytest.mark.parametrize(("first", "second", "fault"), REFUSED)
def test_all_entrances_refuse_the_same(
    first: str, second: str, fault: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for entrance in ENTRANCES:
        found = entrance(REPORTS / first, REPORTS / second, tmp_path)
        told = capsys.readouterr().err if found == "refused" else found
        assert isinstance(told, str)
        assert fault in told
        assert "\n" not in told.strip()


@pytest.mark.parametrize(
    "names", [("states_m.ply", "states_m.xyz"), ("states_m.xyz", "states_m.ply")]
)
def test_one_metre_is_one_metre_in_both_formats(names: tuple[str, str]) -> None:
    result = compare(*(read_surface(REPORTS / name) for name in names))
    assert result.surfaces[0].unit == "mm"
    assert result.measures.mean_abs == pytest.approx(1000.0, rel=1e-14)
    assert result.measures.area_compared == 9e6
    assert result.counts["nodes_shared"] == 16  # the same bits by both ways


def test_the_same_with_the_roles_exchanged() -> None:
    first, second = (read_surface(REPORTS / f"states_{unit}.xyz") for unit in ("mm", "m"))
    there, back = compare(first, second), compare(second, first)
    assert there.measures.mean_signed == -back.measures.mean_signed
    assert there.surfaces[0].unit == back.surfaces[0].unit == "mm"


def test_where_units_are_equal_every_bit_stays() -> None:
    one = read_surface(REPORTS / "states_m.xyz")
    together = bring_together(one, replace(one, name="other"))
    assert together.surfaces[0].points is one.points
    assert together.warnings == ()


def test_conversions_by_whole_numbers_are_rounded_once() -> None:
    rng = np.random.default_rng(5)
    decimals = np.round(rng.uniform(-4000, 4000, (500, 3)), 3)
    surface = Surface(decimals)
    metres = converted(surface, Fraction(1), "m")
    expected = [[float(Fraction(c) / 1000) for c in row] for row in decimals.tolist()]
    assert metres.points.tolist() == expected
    back = converted(surface, SIZES["m"], "mm")
    assert back.points.tolist() == [[float(Fraction(c) * 1000) for c in row] for row in decimals]


def test_sizes_of_units() -> None:
    assert float(SIZES["us-ft"]) == 1200.0 / 3937.0 * 1000.0
    assert SIZES["yd"] == 3 * SIZES["ft"] == 36 * SIZES["in"] == Fraction(9144, 10)
    assert SIZES["mil"] * 1000 == SIZES["in"]


def test_one_list_of_units_for_the_command_line_the_window_and_python() -> None:
    from typing import get_args

    panel = (Path(__file__).parents[2] / "app/panels/options_panel.py").read_text(encoding="utf-8")
    block = panel[panel.index("UNITS: dict") : panel.index("VIEWS: dict")]
    asked = get_args(get_args(get_args(UnitOption)[0])[0])
    assert set(asked) == set(UNITS)
    assert {line.split('"')[1] for line in block.splitlines() if line.startswith('    "')} == {
        "",
        *UNITS,
    }


def test_what_conversion_makes_infinite_is_refused() -> None:
    far = Surface(np.array([[0, 0, 0], [1e308, 0, 0], [0, 1e308, 0]]), unit="m")
    near = Surface(np.eye(3), unit="mm")
    with pytest.raises(InputError):
        compare(far, near)


@pytest.mark.parametrize("unlike", [{"unit": "m"}, {"space": "RAS"}])
@pytest.mark.parametrize("act", [best_fit, lambda a, b: place(a, b, "auto")])
def test_unlike_surfaces_are_not_fitted_nor_placed(
    unlike: dict[str, str], act: Callable[[Surface, Surface], object]
) -> None:
    surface = replace(read_surface(REPORTS / "flat1.ply"), unit="mm", space="LPS")
    with pytest.raises(InputError, match="but the other surface in"):
        act(surface, replace(surface, **unlike))  # type: ignore[arg-type]


def test_withheld_points_are_left_out_and_counted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pair = REPORTS / "las_two_withheld.las", REPORTS / "las_metre_b.las"
    for entrance in ENTRANCES:
        found = entrance(*pair, tmp_path)
        assert isinstance(found, dict)
        assert found["measures"]["mean_abs"] == pytest.approx(1.0, rel=1e-12)
        assert found["inputs"][0]["dropped"] == {"withheld": 2}
        assert found["inputs"][0]["nodes"] == 123
    assert main(["compare", *map(str, pair)]) == 0
    assert "left out of 1" in capsys.readouterr().out


@pytest.mark.parametrize(("form", "high"), [(1, 0), (6, 3)])
def test_noise_is_left_out(form: int, high: int, tmp_path: Path) -> None:
    import laspy

    header = laspy.LasHeader(point_format=form, version="1.4" if form == 6 else "1.2")
    data = laspy.LasData(header)
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(6.0), np.arange(6.0)))
    data.x, data.y, data.z = x, y, x + y
    classes = np.full(36, 2)
    classes[[3, 4]], classes[[10, 11, 12]], classes[20] = 7, 18, 12  # 12: overlap, which stays
    data.classification = classes
    data.withheld = np.arange(36) == 3
    data.synthetic = np.arange(36) == 5
    data.write(tmp_path / "a.las")
    surface = read_surface(tmp_path / "a.las")
    assert surface.dropped == {"withheld": 1, "noise": 1 + high}
    assert len(surface.points) == 36 - 2 - high
    data.classification = np.full(36, 7)
    data.write(tmp_path / "b.las")
    with pytest.raises(InputError, match="all of its 36 points are withheld or noise"):
        read_surface(tmp_path / "b.las")


def test_wkt_behind_the_points(tmp_path: Path) -> None:
    import laspy

    header = laspy.LasHeader(point_format=6, version="1.4")
    header.global_encoding.wkt = True
    data = laspy.LasData(header)
    data.x, data.y, data.z = files.SQUARE.T
    text = b'PROJCS["a",UNIT["US survey foot",0.3048006096]]\0'
    record = laspy.VLR("LASF_Projection", 2112, record_data=text)
    data.evlrs = laspy.vlrs.vlrlist.VLRList([record])
    data.write(tmp_path / "a.las")
    assert read_surface(tmp_path / "a.las").unit == "us-ft"


def test_axes_of_a_pair_are_made_one() -> None:
    ras, lps = (read_surface(REPORTS / f"slicer_{name}.ply") for name in ("ras", "lps"))
    assert (ras.space, lps.space) == ("RAS", "LPS")
    for pair, turned in (((ras, lps), 0), ((lps, ras), 1)):
        result = compare(*pair)
        assert result.measures.max_abs == 0
        assert result.surfaces[turned].changed == {"nodes turned from RAS to LPS": 16}
        assert result.surfaces[turned].turned
    document = make_document(compare(lps, ras))
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
    from app.model.document import Motion

    one, two = (written(tmp_path, name, "cm", h) for name, h in (("a.obj", 0.5), ("b.obj", 0.0)))
    rows = matrix_of(0.0, (0.0, 0.0, 50.0)).tolist()  # 50 cm
    motion = Motion(tuple(tuple(row) for row in rows), "by hand")
    for unit in ("", "cm", "m"):  # what the user says does not move surface 2 anew
        document = Document((one, two), motion=motion, unit=unit)
        assert compared(document, None, silent).comparison.measures.max_abs == pytest.approx(0)


@pytest.mark.parametrize("ending", [".ply", ".npz", ".xyz"])
def test_a_thinned_file_says_what_the_whole_one_says(ending: str, tmp_path: Path) -> None:
    out = tmp_path / f"thin{ending}"
    whole = (REPORTS / "slicer_ras.ply").read_bytes().replace(b"SPACE=RAS", b"SPACE=RAS unit=cm")
    (tmp_path / "a.ply").write_bytes(whole)
    assert main(["thin", str(tmp_path / "a.ply"), "--keep", "0.8", "--out", str(out)]) == 0
    thinned = read_surface(out)
    assert (thinned.unit, thinned.space) == ("mm", "RAS")


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


def test_a_table_of_pairs_says_each_unit(tmp_path: Path) -> None:
    import csv

    pair = [str(written(tmp_path, "a.xyz", "m", 1.0)), str(written(tmp_path, "b.xyz", "ft", 0.0))]
    assert main(["batch", *pair, "--quiet", "--out", str(tmp_path / "r.csv")]) == 0
    with (tmp_path / "r.csv").open(newline="", encoding="utf-8") as stream:
        [row] = csv.DictReader(stream)
    assert row["unit"] == "m"


def test_a_million_comments_take_no_time(tmp_path: Path) -> None:
    import time

    comments = b"# unit vector of a node [x]\n" * 1_000_000
    (tmp_path / "a.obj").write_bytes(b"# unit cm\n" + comments + files.obj(files.SQUARE))
    (tmp_path / "b.las").write_bytes(files.las(files.SQUARE, wkt="A[" + "1," * 30_000))
    start = time.process_time()
    assert read_surface(tmp_path / "a.obj").unit == "mm"
    assert read_surface(tmp_path / "b.las").unit is None
    assert time.process_time() - start < 5.0
