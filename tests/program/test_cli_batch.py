"""`surfcmp batch`: many pairs, of which some cannot be compared."""

import json
from pathlib import Path
from typing import Any

import pytest

import surfcmp_core
from app.__main__ import main
from surfcmp_core.comparing import request
from surfcmp_core.surface import Surface
from tests.program.said import lines

PROJECT = Path(__file__).parents[2]


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

    def counted(path: Path, unit: str | None, no_data: tuple[float, ...]) -> Surface:
        taken.append(path.name)
        return read_surface(path, unit=unit, no_data=no_data)

    taken: list[str] = []
    read_surface = surfcmp_core.read_surface
    monkeypatch.setattr("surfcmp_core.cli.batch.read_surface", counted)
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
    def compared(first: Surface, second: Surface, *rest: Any) -> object:
        if second.name == "two.csv":
            raise MemoryError
        return compare_surfaces(first, second, *rest)

    compare_surfaces = request.compare_surfaces
    monkeypatch.setattr("surfcmp_core.cli.batch.compare_surfaces", compared)
    third = tmp_path / "three.xyz"
    third.write_text(Path(pair[0]).read_text())
    assert main(["batch", *pair, str(third)]) == 3
    said = capsys.readouterr()
    assert said.err == f"surfcmp: {pair[0]} and {pair[1]}: not enough memory\n"
    assert said.out.count("failed") == 1
