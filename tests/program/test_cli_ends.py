"""How commands end: exit statuses, one line for what is wrong, nothing half-written."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from app.__main__ import main
from surfcmp_core.cli.main import run
from surfcmp_core.report import WRITERS
from tests.program.said import lines

PROJECT = Path(__file__).parents[2]


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
    assert run([word.format(a=pair[0], b=pair[1]) for word in arguments], pytest.fail) == 2
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


def test_both_files_are_named_where_both_are_at_fault(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scale = "1e-200"
    files = [tmp_path / "a.xyz", tmp_path / "b.xyz"]
    for file in files:
        file.write_text(
            "".join(f"{x}{scale[1:]} {y}{scale[1:]} 0\n" for x, y in ("00", "90", "09"))
        )
    assert main(["compare", *map(str, files)]) == 3
    (line,) = lines(capsys)
    said = "coordinates x, y up to 9e-200 are too small to give areas"
    assert line == f"surfcmp: a.xyz and b.xyz: {said}"


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
    assert "(test_cli_ends.py, line " in line
