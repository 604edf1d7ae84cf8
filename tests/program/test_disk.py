"""A full disk, at whatever write it shows: one line, the old files whole, nothing left beside."""

import errno
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
import pytest

from surfcmp_core.io.clouds import CLOUD_WRITERS
from surfcmp_core.report import WRITERS, make_record
from surfcmp_core.surface import Surface
from surfcmp_core.system import whole_files
from surfcmp_core.system.whole_files import OutputError, write_all
from tests.core.two_squares import two_squares

PROJECT = Path(__file__).parents[2]
OLD = b"old and whole"
LIGHT = [ending for ending in WRITERS if ending not in {".html", ".pdf", ".png"}]


class Disk:
    """A stream on a disk that is full from the k-th write on."""

    def __init__(self, stream: BinaryIO, left: int) -> None:
        self.stream, self.left, self.writes = stream, left, 0

    def write(self, data: Any) -> int:
        if self.writes == self.left:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        self.writes += 1
        return self.stream.write(data)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.stream, name)


@contextmanager
def full_after(writes: int) -> Iterator[list[Disk]]:
    """Let the disk be full after so many writes to any file."""
    made, plain = [], whole_files.make_held

    def held(path: Path) -> Disk:
        made.append(Disk(plain(path), writes))
        return made[-1]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(whole_files, "make_held", held)
        yield made


def assert_every_write_may_fail(
    folder: Path, write: Callable[[BinaryIO], None], most: int | None = None
) -> None:
    """Fail at each write (or at `most` of them): the old file is there, and it alone."""
    path = folder / "result"
    with full_after(-1) as disks:
        write_all({path: write})
    writes = disks[0].writes
    assert writes > 0
    path.write_bytes(OLD)
    for k in sorted({*np.linspace(0, writes - 1, most or writes, dtype=int).tolist()}):
        with full_after(k), pytest.raises(OutputError) as caught:
            write_all({path: write})
        assert str(caught.value) == f"{path}: cannot be written (No space left on device)"
        assert [*folder.iterdir()] == [path]
        assert path.read_bytes() == OLD


@pytest.mark.parametrize("ending", LIGHT)
def test_no_write_of_a_result_may_spoil_the_old_one(tmp_path: Path, ending: str) -> None:
    comparison = two_squares()
    write = partial(WRITERS[ending], comparison, make_record(comparison))
    assert_every_write_may_fail(tmp_path, write)


@pytest.mark.parametrize("ending", [".html", ".pdf", ".png"])
def test_no_write_of_a_report_may_spoil_the_old_one(tmp_path: Path, ending: str) -> None:
    comparison = two_squares()
    write = partial(WRITERS[ending], comparison, make_record(comparison))
    assert_every_write_may_fail(tmp_path, write, most=3)


@pytest.mark.parametrize("ending", CLOUD_WRITERS)
def test_no_write_of_nodes_may_spoil_the_old_ones(tmp_path: Path, ending: str) -> None:
    surface = Surface(np.arange(60.0).reshape(20, 3), unit="mm")
    assert_every_write_may_fail(tmp_path, partial(CLOUD_WRITERS[ending], surface))


@pytest.mark.parametrize("step", ["flush", "fsync", "replace"])
def test_a_fault_at_the_end_spoils_no_file_of_several(
    tmp_path: Path, step: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, second = tmp_path / "a.json", tmp_path / "b.json"
    for path in (first, second):
        path.write_bytes(OLD)
    calls = 0

    def fails_the_second_time(plain: Callable[..., Any]) -> Callable[..., Any]:
        def call(*args: Any) -> Any:
            nonlocal calls
            calls += 1
            if calls == 2:
                raise OSError(errno.EDQUOT, os.strerror(errno.EDQUOT))
            return plain(*args)

        return call

    if step == "flush":
        monkeypatch.setattr(Disk, "flush", fails_the_second_time(lambda _: None), raising=False)
    else:
        monkeypatch.setattr(os, step, fails_the_second_time(getattr(os, step)))
    with full_after(-1), pytest.raises(OutputError, match=r"b\.json: cannot be written"):
        write_all({path: lambda stream: stream.write(b"new") for path in (first, second)})
    assert calls >= 2
    assert sorted(tmp_path.iterdir()) == [first, second]
    assert [path.read_bytes() for path in (first, second)] == [OLD, OLD]


def test_a_folder_in_the_place_of_a_result_leaves_the_others(tmp_path: Path) -> None:
    first, second = tmp_path / "a.json", tmp_path / "b.json"
    first.write_bytes(OLD)
    second.mkdir()
    with pytest.raises(OutputError, match=r"b\.json: is a folder"):
        write_all({path: lambda stream: stream.write(b"new") for path in (first, second)})
    assert sorted(tmp_path.iterdir()) == [first, second]
    assert first.read_bytes() == OLD


def test_a_folder_that_vanishes_meanwhile_is_told(tmp_path: Path) -> None:
    there = tmp_path / "there"
    there.mkdir()

    def write(stream: BinaryIO) -> None:
        stream.write(b"new")
        shutil.rmtree(there)

    with pytest.raises(OutputError, match="its folder does not exist"):
        write_all({there / "a.json": write})


def test_a_name_as_long_as_names_may_be(tmp_path: Path) -> None:
    path = tmp_path / ("a" * 250 + ".json")
    write_all({path: lambda stream: stream.write(b"new")})
    assert path.read_bytes() == b"new"


LIMITED = """
import resource, signal, sys
from app.__main__ import main
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[1]),) * 2)
sys.exit(main(sys.argv[2:]))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="no limit of a file's size")
@pytest.mark.parametrize("command", ["compare", "batch", "thin"])
def test_commands_end_with_one_line_where_a_file_may_not_grow(
    pair: tuple[str, str], tmp_path: Path, command: str
) -> None:
    out = tmp_path / ("result.ply" if command == "thin" else "result.csv")
    out.write_bytes(OLD)
    before = sorted(tmp_path.iterdir())
    files = [pair[0], "--keep", "1"] if command == "thin" else [*pair]
    done = subprocess.run(
        [sys.executable, "-c", LIMITED, "100", command, *files, "--quiet", "--out", str(out)],
        capture_output=True,
        text=True,
        check=False,
        cwd=PROJECT,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},
    )
    assert done.returncode == 3
    assert done.stderr == f"surfcmp: {out}: cannot be written (File too large)\n"
    assert sorted(tmp_path.iterdir()) == before
    assert out.read_bytes() == OLD


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
def test_a_full_disk_behind_standard_output_is_one_line(pair: tuple[str, str]) -> None:
    with Path("/dev/full").open("wb") as full:
        done = subprocess.run(
            [sys.executable, "-m", "app", "compare", *pair, "--json", "--quiet"],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
            cwd=PROJECT,
        )
    assert done.returncode == 3
    assert done.stderr == "surfcmp: standard output: No space left on device\n"
