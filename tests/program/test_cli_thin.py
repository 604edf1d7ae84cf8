"""`surfcmp thin`: fewer nodes of the same surface."""

from pathlib import Path

import numpy as np
import pytest

from app.__main__ import main
from surfcmp_core import read_surface
from surfcmp_core.io.samples import sample_pair


@pytest.mark.parametrize("ending", [".ply", ".npz", ".xyz"])
def test_a_share_of_the_nodes_is_kept_bit_for_bit(
    ending: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = read_surface(sample_pair("face")[1])
    out = tmp_path / f"thin{ending}"
    assert main(["thin", str(before.path), "--keep", "0.25", "--out", str(out)]) == 0
    assert capsys.readouterr().out == "1000 of 4000 nodes kept (25 %)\n"
    after = read_surface(out)
    assert (after.kind, after.unit, len(after.points)) == ("cloud", "mm", 1000)
    assert {row.tobytes() for row in after.points} <= {row.tobytes() for row in before.points}


def test_spacing_and_seed(tmp_path: Path) -> None:
    file = str(sample_pair("face")[1])
    outs = [tmp_path / f"{k}.npz" for k in range(3)]
    for out, seed in zip(outs, ("1", "1", "2"), strict=True):
        options = ["--spacing", "5", "--seed", seed, "--quiet", "--out", str(out)]
        assert main(["thin", file, *options]) == 0
    first, again, other = (read_surface(out).points for out in outs)
    assert np.array_equal(first, again)
    assert not np.array_equal(first, other)
    distance = np.linalg.norm(first[:, None] - first[None], axis=2)
    assert distance[np.triu_indices(len(first), 1)].min() >= 5.0


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ([], "one of --keep and --spacing is needed"),
        (["--keep", "0.5", "--spacing", "1"], "one of --keep and --spacing is needed"),
        (["--keep", "1.5"], "--keep: must be above 0 and at most 1"),
        (["--spacing", "-1"], "--spacing: must be above 0"),
        (["--keep", "0.5", "--seed", "-1"], "--seed: must not be negative"),
    ],
)
def test_wrong_usage(
    options: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "thin.xyz"
    assert main(["thin", str(sample_pair("face")[0]), "--out", str(out), *options]) == 2
    error = capsys.readouterr().err
    assert said in error
    assert error.count("\n") == 1
    assert not out.exists()


def test_unknown_ending_and_input_are_not_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "a.xyz"
    file.write_text("0 0 0\n1 0 0\n0 1 0\n1 1 1\n")
    assert main(["thin", str(file), "--keep", "0.75", "--out", str(tmp_path / "b.stl")]) == 2
    assert "unknown ending" in capsys.readouterr().err
    assert main(["thin", str(file), "--keep", "0.75", "--out", str(file)]) == 2
    assert "will not be overwritten" in capsys.readouterr().err
