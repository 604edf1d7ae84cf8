"""Values that stand for "nothing was measured": named in a warning, left out on request."""

import json
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from app.__main__ import main
from surfcmp_core import Surface, compare
from surfcmp_core.errors import InputError
from surfcmp_core.io import read_surface
from surfcmp_core.io.no_data import suspected
from tests.core import surface_files as files

REPORTS = Path(__file__).parent / "fixtures" / "reports"
LARGEST = float(np.finfo(np.float64).max)
LARGEST_32 = float(np.finfo(np.float32).max)


def _hills(low: float = 300.0, high: float = 420.0) -> NDArray[np.float64]:
    x, y = np.meshgrid(np.arange(20.0), np.arange(20.0))
    z = low + (high - low) * 0.5 * (1 + np.sin(x / 3) * np.cos(y / 4))
    return np.column_stack((x.ravel(), y.ravel(), z.ravel()))


@pytest.mark.parametrize(
    ("value", "told"),
    [
        (-9999, "-9999"),
        (-99999, "-99999"),
        (9999, "9999"),
        (-32768, "-32768"),
        (32767, "32767"),
        (-2147483648, "-2.14748365e+09"),
        (LARGEST_32, "3.40282347e+38"),
        (-LARGEST_32, "-3.40282347e+38"),
        (1.70141e38, "1.70141e+38"),
        (1e38, "1e+38"),
        (-1e30, "-1e+30"),
        (-LARGEST, "-1.79769313e+308"),
    ],
)
@pytest.mark.parametrize("count", [1, 150])
@pytest.mark.parametrize("axes", ["z", "x, y, z"])
def test_what_usually_means_no_data_is_named_and_left_out(
    tmp_path: Path, value: float, told: str, count: int, axes: str
):
    points = _hills()
    for axis in axes.split(", "):
        points[100 : 100 + count, "xyz".index(axis)] = value
    path = tmp_path / "scan.npy"
    np.save(path, points)
    [(note, found)] = read_surface(path).changed.items()
    assert found == count
    assert note.startswith(f"nodes with {axes} = {told}, which often means")
    assert f"(--no-data {told} leaves them out)" in note
    without = read_surface(path, no_data=[float(told)])
    assert without.dropped == {f"no data ({told})": count}
    assert without.changed == {}
    assert np.array_equal(without.points, np.delete(_hills(), np.s_[100 : 100 + count], 0))


def test_two_values_and_two_counts():
    points = _hills()
    points[:3, 2], points[3:10, 2] = -9999, -LARGEST_32
    assert sorted(suspected(points).values()) == [3, 7]


@pytest.mark.parametrize(
    ("points", "value"),
    [
        (_hills(-10050.0, -9950.0), -9999.0),  # a mine
        (_hills(-9990.0, -9000.0), -9999.0),
        (_hills(-9990.0, -9990.0), -9999.0),
        (_hills(-40000.0, 40000.0), -32768.0),
        (_hills(9000.0, 9998.0), 9999.0),
        (_hills(-1200.0, -800.0), -999.0),
        (_hills(0.0, 900.0), 999.0),
        (_hills(1e31, 1e32), 1e32),
        (np.full((9, 3), -9999.0), -9999.0),
        (_hills(-800.0, 600.0), -999.0),
    ],
)
def test_a_height_like_its_neighbours_is_no_missing_one(points: NDArray[np.float64], value: float):
    points = points.copy()
    points[7, 2] = value
    assert suspected(points) == {}


def test_the_unit_of_the_file_is_that_of_the_value(tmp_path: Path):
    path = tmp_path / "scan.xyz"
    path.write_text((REPORTS / "nodata_9999.xyz").read_text())
    surface = read_surface(path, unit="m", no_data=[-9999])
    assert surface.dropped == {"no data (-9999)": 1}
    assert surface.points[:, 2].min() == 3000.0
    assert surface.points[:, 2].max() == 3300.0


def test_faces_at_nodes_without_data_go_too(tmp_path: Path):
    points = files.SQUARE.copy()
    points[3, 2] = -9999
    for ending, content in (("ply", files.ply_text(points)), ("off", files.off(points))):
        path = tmp_path / f"scan.{ending}"
        path.write_bytes(content)
        surface = read_surface(path, no_data=[-9999.0])
        assert surface.faces is not None
        assert surface.faces.tolist() == [[0, 1, 2]]
        assert surface.changed["faces at nodes without data, left out"] == 1
        assert surface.dropped == {"no data (-9999)": 1}
    lying = files.off(points, files.TWO + 1)
    path.write_bytes(lying)
    with pytest.raises(InputError, match="names node 4"):
        read_surface(path, no_data=[-9999.0])


def test_nodes_that_are_not_finite_are_refused_or_left_out(tmp_path: Path):
    path = REPORTS / "nan_one.xyz"
    with pytest.raises(InputError, match=r"not finite \(--no-data nan leaves them out\)"):
        read_surface(path)
    assert read_surface(path, no_data=[np.nan]).dropped == {"no data (nan)": 1}
    everything = tmp_path / "scan.npy"
    np.save(everything, np.full((5, 3), np.nan))
    with pytest.raises(InputError, match="holds 0 nodes"):
        read_surface(everything, no_data=[np.nan])


def test_arrays_are_looked_at_too():
    points = _hills()
    points[7, 2] = -9999
    result = compare(Surface(points, unit="mm"), Surface(_hills(), unit="mm"))
    assert any("1 nodes with z = -9999" in note for note in result.warnings)


def test_every_command_names_it_and_leaves_it_out(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
):
    pair = [str(REPORTS / "nodata_9999.xyz"), str(REPORTS / "zero4.xyz")]
    named = "1 nodes with z = -9999"
    assert main(["compare", *pair]) == 0
    assert named in capsys.readouterr().out
    assert main(["compare", *pair, "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert any(named in note for note in document["warnings"])
    assert document["options"]["no_data"] == []
    assert main(["compare", *pair, "--json", "--no-data", "-9999"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert not any("--no-data" in note for note in document["warnings"])
    assert document["inputs"][0]["dropped"] == {"no data (-9999)": 1}
    assert document["inputs"][0]["nodes"] == 16
    assert document["options"]["no_data"] == [-9999.0]
    assert abs(document["measures"]["mean_signed"]) < 4
    assert main(["info", pair[0]]) == 0
    assert f"warning: {named}" in capsys.readouterr().out
    assert main(["info", pair[0], "--no-data=-9999", "--no-data", "nan"]) == 0
    assert "--no-data" not in capsys.readouterr().out
    assert main(["batch", *pair]) == 0
    assert named in capsys.readouterr().out
    out = tmp_path / "pairs.json"
    assert main(["batch", *pair, "--no-data", "-9999", "--out", str(out)]) == 0
    assert named not in capsys.readouterr().out
    [one] = json.loads(out.read_text())["pairs"]
    assert one["inputs"][0]["dropped"] == {"no data (-9999)": 1}
    thin = tmp_path / "thin.xyz"
    assert main(["thin", pair[0], "--keep", "1", "--no-data", "-9999", "--out", str(thin)]) == 0
    assert len(read_surface(thin).points) == 15
