"""`surfcmp info`: what a file holds, and what would be seen of it."""

import json
from pathlib import Path

import numpy as np
import pytest

from app.__main__ import main
from surfcmp_core.projection.placement import look_at
from surfcmp_core.surface import Surface
from tests.core.sheets import sheet
from tests.core.turning import mirrored_back

PROJECT = Path(__file__).parents[2]


def test_info_tells_what_a_file_holds(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "fold.off"
    file.write_text("OFF\n5 3 0\n0 0 0\n4 0 0\n4 4 1\n0 4 1\n4 4 2\n3 0 1 2\n3 0 2 3\n3 0 3 4\n")
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
