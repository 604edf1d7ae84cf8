"""Outputs are checked before the work, and complete or absent after it."""

import os
from pathlib import Path
from typing import BinaryIO

import pytest

from surfcmp_core.report import WRITERS, OutputError, check_outputs, make_record, write_outputs
from surfcmp_core.system.whole_files import write_all

from .two_squares import two_squares


def new(stream: BinaryIO) -> None:
    stream.write(b"new")


def test_every_ending_is_written_at_once(tmp_path: Path) -> None:
    comparison = two_squares()
    paths = [tmp_path / f"result{ending}" for ending in WRITERS]
    write_outputs(comparison, make_record(comparison), paths)
    assert sorted(tmp_path.iterdir()) == sorted(paths)
    assert all(path.stat().st_size > 100 for path in paths)


def test_endings_may_be_capitals(tmp_path: Path) -> None:
    comparison = two_squares()
    path = tmp_path / "RESULT.JSON"
    check_outputs([path], [])
    write_outputs(comparison, make_record(comparison), [path])
    assert path.read_bytes().startswith(b"{")


@pytest.mark.parametrize("fault", [OSError(28, "No space left on device"), KeyboardInterrupt()])
def test_a_failing_write_leaves_nothing_and_spoils_nothing(
    tmp_path: Path, fault: BaseException
) -> None:
    first, second = tmp_path / "a.json", tmp_path / "b.json"
    first.write_text("old")

    def half(stream: BinaryIO) -> None:
        stream.write(b"ne")
        raise fault

    with pytest.raises((OutputError, KeyboardInterrupt)) as caught:
        write_all({first: new, second: half})
    if isinstance(fault, OSError):
        assert str(caught.value) == f"{second}: cannot be written (No space left on device)"
    assert list(tmp_path.iterdir()) == [first]
    assert first.read_text() == "old"


def test_an_output_is_as_readable_as_any_new_file(tmp_path: Path) -> None:
    plain, path = tmp_path / "plain", tmp_path / "a.json"
    plain.touch()
    write_all({path: new})
    assert path.stat().st_mode == plain.stat().st_mode


def test_a_linked_output_is_written_where_the_link_leads(tmp_path: Path) -> None:
    target, link = tmp_path / "deep.json", tmp_path / "link.json"
    target.write_text("old")
    link.symlink_to(target)
    write_all({link: new})
    assert link.is_symlink()
    assert target.read_text() == "new"


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("a.docx", "unknown ending; known are .json .npz"),
        ("a", "unknown ending"),
        ("nowhere/a.json", "its folder does not exist"),
        ("folder.json", "is a folder"),
        ("input.csv/a.json", "its folder does not exist"),
        ("input.csv", "is an input"),
        ("hard_link.csv", "is an input"),
        ("soft_link.csv", "is an input"),
    ],
)
def test_bad_outputs_are_found_before_the_work(tmp_path: Path, name: str, words: str) -> None:
    (tmp_path / "folder.json").mkdir()
    given = tmp_path / "input.csv"
    given.touch()
    (tmp_path / "hard_link.csv").hardlink_to(given)
    (tmp_path / "soft_link.csv").symlink_to(given)
    before = sorted(tmp_path.iterdir())
    with pytest.raises(OutputError, match=words):
        check_outputs([tmp_path / name], [given])
    assert sorted(tmp_path.iterdir()) == before


def test_an_output_named_twice_is_refused(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="named twice"):
        check_outputs([tmp_path / "a.json", tmp_path / "x" / ".." / "a.json"], [])


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_cannot_be_written_is_found_before_the_work(tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    try:
        with pytest.raises(OutputError, match="cannot be written"):
            check_outputs([tmp_path / "a.json"], [])
    finally:
        tmp_path.chmod(0o700)
