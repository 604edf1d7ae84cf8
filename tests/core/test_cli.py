"""The command line, mostly within this process: options, outputs, exit statuses."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import surfcmp_core
from app import __main__ as program
from app.__main__ import main
from surfcmp_core.placement import look_at
from surfcmp_core.report import WRITERS
from surfcmp_core.samples import sample_pair
from surfcmp_core.surface import Surface
from tests.core.test_projection_direction import sheet
from tests.core.turning import mirrored_back

PROJECT = Path(__file__).parents[2]


@pytest.fixture
def pair(tmp_path: Path) -> tuple[str, str]:
    """Write a flat 5 x 5 lattice, and a cloud of 60 nodes a tenth above it."""
    x, y = np.meshgrid(np.arange(5.0), np.arange(5.0))
    first = tmp_path / "one.xyz"
    np.savetxt(first, np.column_stack([x.ravel(), y.ravel(), np.zeros(25)]))
    second = tmp_path / "two.csv"
    places = np.random.default_rng(5).random((60, 2)) * 4
    np.savetxt(second, np.column_stack([places, np.full(60, 0.1)]), delimiter=",")
    return str(first), str(second)


def lines(capsys: pytest.CaptureFixture[str]) -> list[str]:
    """Give what was said on standard error, line by line."""
    return capsys.readouterr().err.splitlines()


def test_compare_prints_a_table(pair: tuple[str, str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["compare", *pair]) == 0
    said = capsys.readouterr()
    assert said.err == ""
    assert "mean_abs" in said.out
    assert "0.1000  mm" in said.out
    assert "warning: no unit stated in one.xyz and two.csv: taken as mm" in said.out


def test_json_is_all_there_is_on_standard_output(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    out = tmp_path / "r.json"
    assert main(["compare", *pair, "--json", "--quiet", "--out", str(out)]) == 0
    said = capsys.readouterr()
    document = json.loads(said.out)
    assert said.err == ""
    assert document == json.loads(out.read_text(encoding="utf-8"))
    assert document["measures"]["mean_abs"] == pytest.approx(0.1, abs=1e-12)
    assert document["inputs"][1]["file"] == pair[1]
    assert document["options"]["unit"] == "mm"


def test_the_command_line_and_python_give_the_same(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    from dataclasses import asdict

    assert main(["compare", *pair, "--json", "--domain", "hull"]) == 0
    told = json.loads(capsys.readouterr().out)["measures"]
    first, second = (surfcmp_core.read_surface(path) for path in pair)
    result = surfcmp_core.compare(first, second, domain="hull")
    assert {**told, "exact": None} == asdict(result.measures)


def test_quiet_prints_nothing(pair: tuple[str, str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["compare", *pair, "--quiet"]) == 0
    assert capsys.readouterr() == ("", "")


def test_options_reach_the_result(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ["--domain", "plane", "--max-edge", "inf", "--threads", "1", "--unit", "cm"]
    arguments += ["--tolerance", "0.5", "--tolerance", "5", "--duplicates", "mean"]
    assert main(["compare", *pair, "--json", *arguments]) == 0
    document = json.loads(capsys.readouterr().out)
    options = document["options"]
    assert (options["domain"], options["threads"]) == ("plane", 1)
    assert (options["max_edge"], options["max_edge_derived"]) == (None, False)
    assert options["max_edge_used"] == [None, None]
    assert options["tolerances"] == [0.5, 5.0]
    assert options["duplicates"] == "mean"
    assert document["measures"]["within_tolerance"] == {"0.5": 0.0, "5": pytest.approx(1.0)}
    assert document["measures"]["mean_abs"] == pytest.approx(1.0)  # 0.1 cm
    assert not any("no unit stated" in warning for warning in document["warnings"])


def test_a_matrix_moves_the_second_surface(
    pair: tuple[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    matrix = np.eye(4)
    matrix[2, 3] = -0.6
    np.savetxt(tmp_path / "m.txt", matrix, delimiter=", ")
    np.save(tmp_path / "m.npy", matrix)
    for name in ("m.txt", "m.npy"):
        file = str(tmp_path / name)
        assert main(["compare", *pair, "--json", "--align", file]) == 0
        document = json.loads(capsys.readouterr().out)
        assert document["measures"]["mean_signed"] == pytest.approx(0.5)
        assert document["options"]["align"]["file"] == file
        assert np.array_equal(document["options"]["align"]["matrix"], matrix)


@pytest.mark.parametrize(
    ("content", "fault"),
    [
        ("1 0 0\n0 1 0\n0 0 1\n", "not a 4×4 matrix of numbers"),
        ("1 0 0 0\n0 1 0 0\n0 0 x 0\n0 0 0 1", "not a 4×4 matrix of numbers"),
        ("1 0 0 0\n0 1 0 0\n0 0 nan 0\n0 0 0 1", "not a 4×4 matrix of numbers"),
        ("1 0 0 0\n0 1 0 0\n0 0 1 0\n1 2 3 1", "the last row of the matrix is not 0 0 0 1"),
        ("2 0 0 0\n0 2 0 0\n0 0 2 0\n0 0 0 1", "not a rigid motion"),
        ("1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 1", "not a rigid motion"),
        (None, "No such file or directory"),
    ],
)
def test_a_bad_matrix_is_refused_in_one_line(
    pair: tuple[str, str],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    content: str | None,
    fault: str,
) -> None:
    file = tmp_path / "m.txt"
    if content is not None:
        file.write_text(content)
    assert main(["compare", *pair, "--align", str(file)]) == 3
    (line,) = lines(capsys)
    assert line.startswith(f"surfcmp: {file}: {fault}")


def test_a_weight_is_linear_between_its_nodes_and_constant_outside(
    pair: tuple[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    from surfcmp_core.cli.weight import read_weight

    file = tmp_path / "weight.txt"
    file.write_text("0 0 1\n2 0 3\n2 2 3\n0 2 1\n")
    weight = read_weight(file)
    x, y = np.array([0.5, 2.0, 1.5, 9.0, -4.0, 9.0]), np.array([0.5, 1.0, 0.1, 1.0, 1.5, 9.0])
    assert weight(x, y) == pytest.approx([1.5, 3.0, 2.5, 3.0, 1.0, 3.0])
    assert weight(x[::-1], y[::-1]) == pytest.approx(weight(x, y)[::-1])

    assert main(["compare", *pair, "--json", "--weight", str(file)]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["options"]["weight"] == str(file)
    assert 1.0 < document["measures"]["rho_V_mu"] / document["measures"]["rho_V"] < 3.0

    file.write_text("0 0 1\n2 0 -3\n2 2 3\n0 2 1\n")
    assert main(["compare", *pair, "--weight", str(file)]) == 3
    assert lines(capsys) == [f"surfcmp: {file}: 1 weights are below zero"]


def test_a_weight_is_not_converted_and_knows_what_to_do_with_duplicates(
    pair: tuple[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "weight.obj"
    nodes = "v 0 0 1\nv 5 0 2\nv 5 5 2\nv 0 5 1\n"
    file.write_text(f"# unit m\n{nodes}")
    assert main(["compare", *pair, "--json", "--weight", str(file)]) == 0
    measures = json.loads(capsys.readouterr().out)["measures"]
    assert 1.0 < measures["rho_V_mu"] / measures["rho_V"] < 2.0

    file.write_text(f"{nodes}v 0 0 3\n")
    assert main(["compare", *pair, "--quiet", "--weight", str(file)]) == 3
    (line,) = lines(capsys)
    assert "--duplicates" in line
    assert main(["compare", *pair, "--quiet", "--weight", str(file), "--duplicates", "max"]) == 0


@pytest.mark.parametrize("options", [["--json"], [], ["--quiet"]])
def test_odd_names_and_poor_streams(pair: tuple[str, str], options: list[str]) -> None:
    odd = os.fsencode(pair[0]).replace(b"one.xyz", b"\xff \n\xc3\xa9.xyz")
    os.rename(pair[0], odd)
    command = [sys.executable, "-m", "app", "compare", odd, pair[1], *options]
    environment = {**os.environ, "PYTHONUTF8": "0", "PYTHONIOENCODING": "ascii", "LC_ALL": "C"}
    done = subprocess.run(command, cwd=PROJECT, env=environment, capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, b"")
    if options == ["--json"]:
        document = json.loads(done.stdout.decode("utf-8"))
        assert document["inputs"][0]["file"].endswith("/\ufffd \ufffdé.xyz")

    for closed in ((1,), (2,), (1, 2)):
        done = subprocess.run(
            ["sh", "-c", " ".join(['exec "$@"', *(f"{n}>&-" for n in closed)]), "sh", *command],
            cwd=PROJECT,
            capture_output=True,
            check=False,
        )
        assert (done.returncode, done.stderr) == (0, b"")


@pytest.mark.parametrize("project", ["z", "auto", "view:0,0,2", "view:0.1,0,1"])
def test_directions_of_view(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str], project: str
) -> None:
    assert main(["compare", *pair, "--json", "--project", project, "--domain", "hull"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["options"]["project"] == project
    assert document["measures"]["mean_abs"] == pytest.approx(0.1, rel=0.02)


def balls(folder: Path, *, z: float) -> str:
    """Write a closed ball of radius 5 around (0, 0, z), as a mesh of latitudes and longitudes."""
    import trimesh

    from surfcmp_core.projection import frame

    ball = trimesh.creation.icosphere(subdivisions=3, radius=5.0)
    ball.apply_transform(frame([0.3, 0.1, 0.9]))  # so that no two nodes share x and y
    ball.apply_translation([0.0, 0.0, z])
    file = folder / f"ball_{z:g}.off"
    ball.export(file)
    return str(file)


def test_a_closed_mesh_is_cut_to_what_is_seen_and_the_rest_is_counted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    files = [balls(tmp_path, z=0.0), balls(tmp_path, z=0.25)]
    assert main(["compare", *files, "--json", "--project", "view:0,0,3"]) == 0
    document = json.loads(capsys.readouterr().out)
    for one, used in zip(document["inputs"], ("nodes_1", "nodes_2"), strict=True):
        assert one["nodes"] == 642
        assert one["nodes"] - sum(one["dropped"].values()) == document["counts"][used] < 400
    assert document["measures"]["mean_signed"] == pytest.approx(-0.25)
    assert document["options"]["view"] == [0.0, 0.0, 1.0]
    assert sum("is not seen in this view and is left out" in w for w in document["warnings"]) == 2

    assert main(["compare", *files, "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert sum("seen along z, folds over" in w for w in document["warnings"]) == 2


def test_view_and_motion_stand_together_in_the_transform(
    pair: tuple[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    matrix = np.array([[0.0, -1, 0, 4], [1, 0, 0, 0], [0, 0, 1, 0.4], [0, 0, 0, 1]])
    np.savetxt(tmp_path / "m.txt", matrix)
    align = ["--align", str(tmp_path / "m.txt")]
    for project, turn in (("z", np.eye(4)), ("view:0,0,-1", np.diag([1.0, -1, -1, 1]))):
        assert main(["compare", *pair, *align, "--json", "--project", project]) == 0
        document = json.loads(capsys.readouterr().out)
        assert np.array_equal(document["transform"], turn @ matrix)
        assert document["measures"]["mean_signed"] == pytest.approx(-0.5 * turn[2, 2])


def test_a_best_fit_can_be_asked_for(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["compare", *pair, "--json", "--align", "icp"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["options"]["align"]["method"].startswith("icp")
    assert document["measures"]["mean_abs"] < 0.01


@pytest.mark.parametrize(
    "arguments",
    [
        ["compare"],
        ["compare", "{a}"],
        ["compare", "{a}", "{b}", "{b}"],
        ["compare", "{a}", "{b}", "--domain", "moon"],
        ["compare", "{a}", "{b}", "--threads", "0"],
        ["compare", "{a}", "{b}", "--threads", "two"],
        ["compare", "{a}", "{b}", "--max-edge", "0"],
        ["compare", "{a}", "{b}", "--max-edge", "nan"],
        ["compare", "{a}", "{b}", "--tolerance", "-1"],
        ["compare", "{a}", "{b}", "--tolerance", "inf"],
        ["compare", "{a}", "{b}", "--project", "x"],
        ["compare", "{a}", "{b}", "--project", "view:0,0,0"],
        ["compare", "{a}", "{b}", "--project", "view:1,2"],
        ["compare", "{a}", "{b}", "--out", "result.docx"],
        ["compare", "{a}", "{b}", "--out", "{b}"],
        ["compare", "{a}", "{b}", "--out", "/nowhere/at/all/r.json"],
        ["compare", "{a}", "{b}", "--unit", "parsec"],
        ["compare", "{a}", "{b}", "--nonsense"],
        ["batch"],
        ["batch", "{a}"],
        ["batch", "{a}", "{b}", "--out", "r.png"],
        ["info"],
        ["info", "{a}", "{b}"],
        ["--nonsense"],
        ["{a}", "{b}", "{a}"],
    ],
)
def test_wrong_usage_is_2_and_found_before_the_work(
    pair: tuple[str, str],
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    arguments: list[str],
) -> None:
    monkeypatch.setattr("surfcmp_core.io.read_surface", None)
    monkeypatch.setattr(program, "_open_window", None)
    assert main([word.format(a=pair[0], b=pair[1]) for word in arguments]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert "Traceback" not in said.err
    assert said.err


@pytest.mark.parametrize("command", ["compare", "info"])
def test_input_that_cannot_be_read_is_3_and_one_line(
    pair: tuple[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str], command: str
) -> None:
    for name, content in (("none.ply", None), ("empty.xyz", ""), ("odd.doc", "1 2 3")):
        file = tmp_path / name
        if content is not None:
            file.write_text(content)
        others = [pair[0]] if command == "compare" else []
        out = ["--out", str(tmp_path / "r.json")] if command == "compare" else []
        assert main([command, *others, str(file), *out]) == 3
        said = capsys.readouterr()
        assert said.out == ""
        (line,) = said.err.splitlines()
        assert line.startswith(f"surfcmp: {file}: ")
    assert not (tmp_path / "r.json").exists()


def test_surfaces_apart_are_3_and_one_line(
    pair: tuple[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    far = tmp_path / "far.xyz"
    far.write_text("100 100 0\n101 100 0\n100 101 0\n")
    assert main(["compare", pair[0], str(far)]) == 3
    (line,) = lines(capsys)
    assert line.startswith("surfcmp: ")
    assert "far.xyz" in line


@pytest.mark.parametrize("scale", ["1e200", "1e-200"])
def test_both_files_are_named_where_both_are_at_fault(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], scale: str
) -> None:
    files = [tmp_path / "a.xyz", tmp_path / "b.xyz"]
    for file in files:
        file.write_text(
            "".join(f"{x}{scale[1:]} {y}{scale[1:]} 0\n" for x, y in ("00", "90", "09"))
        )
    assert main(["compare", *map(str, files)]) == 3
    (line,) = lines(capsys)
    assert line.startswith(f"surfcmp: {files[0]} and {files[1]}: coordinates up to 9e")


def test_units_that_differ_are_refused_unless_one_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    points = np.random.default_rng(1).random((50, 3))
    files = [str(tmp_path / "a.npz"), str(tmp_path / "b.npz")]
    for file, unit in zip(files, ("mm", "m"), strict=True):
        np.savez(file, points=points, meta=json.dumps({"units": unit}))
    assert main(["compare", *files]) == 3
    (line,) = lines(capsys)
    assert line.startswith(f"surfcmp: {files[1]}: is in m, but the other surface in mm")
    assert main(["compare", *files, "--unit", "m", "--quiet"]) == 0


def test_one_stated_unit_serves_both(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    points = np.random.default_rng(1).random((50, 3))
    np.savez(tmp_path / "a.npz", points=points, meta=json.dumps({"units": "m"}))
    np.savetxt(tmp_path / "b.xyz", points)
    assert main(["compare", str(tmp_path / "a.npz"), str(tmp_path / "b.xyz"), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["options"]["unit"] == "m"
    assert document["warnings"][0] == "no unit stated in b.xyz: taken as m"


def test_info_tells_what_a_file_holds(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "fold.off"
    file.write_text("OFF\n5 3 0\n0 0 0\n4 0 0\n4 4 1\n0 4 1\n4 4 2\n3 0 1 2\n3 0 2 3\n3 0 3 1\n")
    assert main(["info", str(file)]) == 0
    said = capsys.readouterr()
    assert said.err == ""
    table = dict(
        row.strip().split(maxsplit=1)
        for row in said.out.replace("one-valued", "one-valued").splitlines()[1:]
        if " " in row.strip()
    )
    assert table["kind"] == "mesh"
    assert table["nodes"].strip() == "5"
    assert table["triangles"].strip() == "3"
    assert table["x"] == "0 to 4.000, extent 4.000"
    assert table["one-valued"].startswith("no: 2 nodes share x, y with one of another z; 33.3 %")


def _facts(capsys: pytest.CaptureFixture[str]) -> dict[str, str]:
    rows = (row.strip().split("  ", 1) for row in capsys.readouterr().out.splitlines()[1:])
    return {row[0]: row[1].strip().replace("\u2009", " ") for row in rows if len(row) == 2}


def test_info_tells_what_is_seen_of_a_closed_mesh(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    closed = mirrored_back(sheet(lambda x, y: 0.3 * np.cos(x) * np.cos(y), wide=1.3), 0.2)
    speck = closed.points[closed.faces[:1]].reshape(-1, 3) + np.array([0.0, 0.0, 0.5])
    points = np.concatenate((closed.points, speck, [[0.0, 0.0, 9.0]]))
    faces = np.concatenate((closed.faces, np.arange(3)[None] + len(closed.points)))
    np.savez(tmp_path / "a.npz", points=points, faces=faces, meta=json.dumps({"units": "mm"}))
    assert main(["info", str(tmp_path / "a.npz")]) == 0
    table = _facts(capsys)
    direction, angle = table["direction"].split(": ")
    assert angle.endswith("° from z")
    assert float(angle.split("°")[0]) < 10.0
    assert float(direction.split(", ")[2]) > 0.98
    sight = look_at(Surface(points, faces.astype(np.int32)))
    kept = sight.part.points
    share = 100.0 * len(kept) / len(points)
    total = sight.removed.area_kept + sum(sight.removed.area.values())
    assert table["kept"].startswith(f"{len(kept)} nodes ({share:.4g} %), ")
    assert table["kept"].endswith(f" mm² ({100.0 * sight.removed.area_kept / total:.4g} %)")
    assert float(table["kept"].split(", ")[1].split(" mm²")[0]) == pytest.approx(
        sight.removed.area_kept, rel=1e-3
    )
    assert table["unused"] == f"1 nodes ({100.0 / len(points):.4g} %)"
    assert table["island"].startswith("3 nodes (")
    lost = sum(int(table[name].split(" nodes")[0]) for name in sight.removed.nodes)
    assert lost == len(points) - len(kept)
    assert "max-edge" not in table


def test_info_tells_where_a_cloud_has_data(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    x, y = np.meshgrid(np.arange(10.0), np.arange(10.0))
    one = np.column_stack((x.ravel(), y.ravel(), np.zeros(100)))
    two, up = one + np.array([14.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])
    np.savetxt(tmp_path / "a.xyz", np.concatenate((one, two, one + up, two + up)))
    assert main(["info", str(tmp_path / "a.xyz"), "--unit", "m"]) == 0
    table = _facts(capsys)
    assert table["with data"] == "1.620e8 mm² (78.26 %) of the convex hull"
    assert table["max-edge"] == "4000 mm"
    assert table["kept"] == "200 nodes (50 %)"
    assert table["hidden"] == "200 nodes (50 %)"


def test_info_of_a_cloud_that_stands_upright(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    wall = np.random.default_rng(0).random((50, 3)) * [0.0, 1.0, 1.0]
    np.savetxt(tmp_path / "a.xyz", wall)
    assert main(["info", str(tmp_path / "a.xyz")]) == 0
    table = _facts(capsys)
    assert table["direction"] == "1.0000, 0.0000, 0.0000: 90.0° from z"
    assert table["nothing"].endswith("all nodes lie on one line in the plane")


def test_interruption_is_130_and_leaves_nothing(
    pair: tuple[str, str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setitem(WRITERS, ".npz", interrupted)
    before = sorted(tmp_path.iterdir())
    outs = [str(tmp_path / "r.json"), "--out", str(tmp_path / "r.npz")]
    assert main(["compare", *pair, "--out", *outs]) == 130
    assert sorted(tmp_path.iterdir()) == before
    assert capsys.readouterr() == ("", "")


def test_termination_cleans_up_as_interruption_does(
    pair: tuple[str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def terminated(*_: object) -> None:
        os.kill(os.getpid(), signal.SIGTERM)
        time.sleep(5)

    monkeypatch.setitem(WRITERS, ".npz", terminated)
    before = sorted(tmp_path.iterdir()), signal.getsignal(signal.SIGTERM)
    assert main(["compare", *pair, "--out", str(tmp_path / "r.npz")]) == 130
    assert (sorted(tmp_path.iterdir()), signal.getsignal(signal.SIGTERM)) == before


def test_a_full_disk_is_3_and_one_line(
    pair: tuple[str, str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setitem(WRITERS, ".npz", full)
    out = tmp_path / "r.npz"
    assert main(["compare", *pair, "--out", str(out)]) == 3
    assert lines(capsys) == [f"surfcmp: {out}: cannot be written (No space left on device)"]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full here")
@pytest.mark.parametrize(
    ("command", "target", "status", "said"),
    [
        ("compare", "pipe", 130, ""),
        ("--help", "pipe", 130, ""),
        ("compare", "/dev/full", 3, "surfcmp: standard output: No space left on device\n"),
    ],
)
def test_a_closed_or_full_standard_output_ends_without_a_traceback(
    pair: tuple[str, str], command: str, target: str, status: int, said: str
) -> None:
    if target == "pipe":
        reader, out = os.pipe()
        os.close(reader)
    else:
        out = os.open(target, os.O_WRONLY)
    done = subprocess.run(
        [sys.executable, "-m", "app", command, *pair, *(["--json"] * (command == "compare"))],
        stdout=out,
        stderr=subprocess.PIPE,
        text=True,
        check=False,
        cwd=PROJECT,
        env={name: text for name, text in os.environ.items() if name != "PYTHONUNBUFFERED"},
    )
    os.close(out)
    assert (done.returncode, done.stderr) == (status, said)


def test_a_bar_is_drawn_on_a_terminal_only(
    pair: tuple[str, str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    from surfcmp_core.cli.bar import progress_bar

    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    monkeypatch.setenv("TERM", "xterm")
    with progress_bar(quiet=False) as progress:
        progress("spanning_trees", 0.5)
    assert "spanning trees" in capsys.readouterr().err
    with progress_bar(quiet=True) as progress:
        progress("spanning_trees", 0.5)
    assert capsys.readouterr().err == ""


def test_no_command_opens_the_window(
    pair: tuple[str, str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    opened: list[list[Path]] = []

    def window(paths: list[Path]) -> int:
        opened.append(paths)
        return 7

    monkeypatch.setattr(program, "_open_window", window)
    assert main([]) == 7
    assert main([pair[0]]) == 7
    assert main(list(pair)) == 7
    assert opened == [[], [Path(pair[0])], [Path(one) for one in pair]]
    assert main(["compere"]) == 3
    (line,) = lines(capsys)
    assert line.startswith("surfcmp: compere: no such file, nor a command")


def test_every_command_is_known_by_name() -> None:
    from surfcmp_core.cli.commands import commands
    from surfcmp_core.cli.main import NAMES

    assert tuple(one.name for one in commands.registered_commands) == NAMES


def test_help_and_version(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"surfcmp {surfcmp_core.__version__}\n"
    assert main(["--help"]) == 0
    assert "compare" in capsys.readouterr().out
    assert main(["compare", "--help"]) == 0
    said = capsys.readouterr().out
    for option in ("--domain", "--max-edge", "--exact", "--tolerance", "--weight", "--align"):
        assert option in said
    for option in ("--project", "--out", "--json", "--quiet", "--threads"):
        assert option in said


def test_batch_compares_all_pairs_and_goes_on_after_a_failure(
    pair: tuple[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    import csv

    folder = tmp_path / "more"
    folder.mkdir()
    (folder / "bad.xyz").write_text("1 2 3\n")
    (folder / "notes.md").write_text("not a surface")
    outs = [tmp_path / "r.csv", tmp_path / "r.json"]
    arguments = [*pair, str(folder), "--out", str(outs[0]), "--out", str(outs[1])]
    assert main(["batch", *arguments]) == 3
    said = capsys.readouterr()
    assert said.err.count("bad.xyz") == 1
    assert said.out.count("failed") == 2
    assert "0.1000 mm" in said.out
    with outs[0].open(newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert [bool(row["error"]) for row in rows] == [False, True, True]
    assert float(rows[0]["mean_abs"]) == pytest.approx(0.1)
    whole = json.loads(outs[1].read_text(encoding="utf-8"))
    assert list(whole["pairs"][0])[:2] == ["schema", "program"]
    assert list(whole["pairs"][1]) == ["inputs", "error"]

    assert main(["batch", *pair, "--quiet"]) == 0
    assert capsys.readouterr() == ("", "")


def test_batch_reads_each_file_once_and_can_be_repeated(
    pair: tuple[str, str],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from surfcmp_core.cli import batch

    def counted(path: Path, unit: str | None) -> Surface:
        taken.append(path.name)
        return read_surface(path, unit=unit)

    taken: list[str] = []
    read_surface = surfcmp_core.read_surface
    monkeypatch.setattr(batch, "read", counted)
    (tmp_path / "three.xyz").write_text("0 0 0\n4 0 0\n4 4 0\n0 4 0\n")
    (tmp_path / "bad.ply").write_text("nothing")
    (tmp_path / "._one.xyz").write_text("what another system leaves")
    command = ["batch", str(tmp_path), "--quiet", "--out", str(tmp_path / "table.csv")]
    for _ in range(2):
        assert main(command) == 3
        (line,) = lines(capsys)
        assert line.endswith("bad.ply: it does not begin with 'ply'")
        assert sorted(taken) == ["bad.ply", "one.xyz", "three.xyz", "two.csv"]
        taken.clear()
    table = (tmp_path / "table.csv").read_text().splitlines()
    assert len(table) == 1 + 6
    assert sum("bad.ply: it does" in row for row in table) == 3

    monkeypatch.setattr(batch, "_KEPT", 10)
    assert main(command) == 3
    assert [taken.count(name) for name in ("bad.ply", "one.xyz", "two.csv")] == [1, 1, 2]
    assert main(["batch", str(tmp_path), str(tmp_path / "table.csv"), *command[2:]]) == 2


def test_a_pair_without_memory_does_not_stop_the_others(
    pair: tuple[str, str],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from surfcmp_core.cli import batch

    def compared(surfaces: tuple[Surface, Surface], *rest: object) -> object:
        if surfaces[1].name == "two.csv":
            raise MemoryError
        return compare_surfaces(surfaces, *rest)

    compare_surfaces: Any = batch.compare_surfaces
    monkeypatch.setattr(batch, "compare_surfaces", compared)
    third = tmp_path / "three.xyz"
    third.write_text(Path(pair[0]).read_text())
    assert main(["batch", *pair, str(third)]) == 3
    said = capsys.readouterr()
    assert said.err == f"surfcmp: {pair[0]} and {pair[1]}: not enough memory\n"
    assert said.out.count("failed") == 1


def test_a_fault_of_the_program_is_one_line(
    pair: tuple[str, str],
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def faulty(*_: object) -> None:
        raise ValueError("first\nsecond")

    monkeypatch.setattr("surfcmp_core.cli.compare.compare_files", faulty)
    assert main(["compare", *pair]) == 3
    (line,) = lines(capsys)
    assert line.startswith("surfcmp: internal error, please report it: ValueError: first")
    assert "(test_cli.py, line " in line


def test_the_package_gives_what_is_asked_for() -> None:
    import surfcmp_core.compare  # the module of this name must not hide the function

    assert callable(surfcmp_core.compare)
    assert surfcmp_core.InputError is surfcmp_core.errors.InputError
    assert set(surfcmp_core.__all__) <= set(dir(surfcmp_core))
    with pytest.raises(AttributeError, match="has no attribute 'nothing'"):
        surfcmp_core.nothing  # noqa: B018


def test_importing_the_package_imports_little() -> None:
    code = (
        "import sys, surfcmp_core\n"
        "from app.__main__ import main\n"
        "main(['a', 'b', 'c'])  # how the window starts, too\n"
        "print(sorted({'numpy', 'numba', 'scipy', 'typer', 'rich'} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=PROJECT
    )
    assert done.stdout == "[]\n"


def test_exact_stands_beside_the_nodal_reading(capsysbinary: pytest.CaptureFixture[bytes]) -> None:
    first, second = sample_pair("face")
    assert main(["compare", str(first), str(second), "--exact", "--json"]) == 0
    measures = json.loads(capsysbinary.readouterr().out)["measures"]
    assert list(measures["exact"]) == [key for key in measures if key != "exact"]
    # the nodal reading is the larger one where differences are noise
    assert 0.9 < measures["exact"]["mean_abs"] / measures["mean_abs"] < 1.0
    assert measures["exact"]["area_compared"] > measures["area_compared"]
