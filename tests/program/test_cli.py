"""The command line, mostly within this process: options and outputs."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import surfcmp_core
from app.__main__ import main
from surfcmp_core.cli.main import run
from surfcmp_core.io.samples import sample_pair
from surfcmp_core.report import WRITERS
from tests.program.said import lines

PROJECT = Path(__file__).parents[2]


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
    np.savetxt(tmp_path / "m.txt", matrix, delimiter=", ", header="moves the second surface")
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
    from surfcmp_core.comparing.weight import read_weight

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


def test_units_that_differ_are_made_one(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    points = np.random.default_rng(1).random((50, 3))
    files = [str(tmp_path / "a.npz"), str(tmp_path / "b.npz")]
    for file, unit, scale in zip(files, ("mm", "m"), (1000.0, 1.0), strict=True):
        np.savez(file, points=points * scale, meta=json.dumps({"units": unit}))
    assert main(["compare", *files, "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["options"]["unit"] == "mm"
    assert document["measures"]["max_abs"] == 0
    assert document["warnings"] == ["b.npz: 50 nodes converted from m to mm"]
    assert document["transform"] == np.diag([1000.0, 1000.0, 1000.0, 1.0]).tolist()
    assert main(["compare", files[1], files[1], "--unit", "m", "--quiet"]) == 0


def test_one_stated_unit_serves_both(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    points = np.random.default_rng(1).random((50, 3))
    np.savez(tmp_path / "a.npz", points=points, meta=json.dumps({"units": "m"}))
    np.savetxt(tmp_path / "b.xyz", points)
    assert main(["compare", str(tmp_path / "a.npz"), str(tmp_path / "b.xyz"), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["options"]["unit"] == "m"
    assert document["warnings"][0] == "no unit stated in b.xyz: taken as m"


def test_no_command_opens_the_window(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    opened: list[list[Path]] = []

    def window(paths: list[Path]) -> int:
        opened.append(paths)
        return 7

    assert run([], window) == 7
    assert run([pair[0]], window) == 7
    assert run(list(pair), window) == 7
    assert opened == [[], [Path(pair[0])], [Path(one) for one in pair]]
    assert run(["compere"], window) == 3
    (line,) = lines(capsys)
    assert line.startswith("surfcmp: compere: no such file, nor a command")


def test_every_command_is_known_by_name() -> None:
    import surfcmp_core.cli
    from surfcmp_core.cli import NAMES

    rooms = Path(surfcmp_core.cli.__file__).parent.glob("*.py")
    assert {one.stem for one in rooms if "\ndef command(" in one.read_text("utf-8")} == set(NAMES)
    for name in NAMES:
        assert main([name, "--help"]) == 0


def test_telling_of_a_file_loads_no_kernels() -> None:
    code = "import sys, surfcmp_core.cli.commands; print('numba' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "False\n"


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
    assert " ".join(WRITERS) in " ".join(said.replace("│", " ").split())


def test_the_package_gives_what_is_asked_for() -> None:
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
