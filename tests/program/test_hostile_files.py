"""Hostile files are read aright or refused in one line, soon, in little memory; none is obeyed."""

import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from tests.program import hostile_reading

PARTS = 2
SECONDS = 2.0
"""Of processor time, for one file."""
OCTETS = 200 << 20
"""Above the start, for all files together and so for each."""


def _said(folder: Path, part: int) -> list[dict[str, Any]]:
    """Read every other file in a process of its own."""
    command = [sys.executable, "-m", hostile_reading.__name__, str(folder), str(part), str(PARTS)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=600)
    told = [json.loads(line) for line in done.stdout.splitlines()]
    last = told[-1] if told else {}
    assert done.returncode == 0, f"ended by {done.returncode} after {last}: {done.stderr[-500:]}"
    return [one for one in told if "outcome" in one]


@pytest.fixture(scope="module")
def told(tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, Any]]:
    folders = [tmp_path_factory.mktemp("hostile") for _ in range(PARTS)]
    with ThreadPoolExecutor(PARTS) as pool:
        return [one for part in pool.map(_said, folders, range(PARTS)) for one in part]


@pytest.mark.timeout(600)
def test_each_is_read_aright_or_refused_in_one_line(told: list[dict[str, Any]]) -> None:
    assert len(told) > 1500
    assert [one for one in told if not one["sound"]] == []
    assert sum(one["outcome"] == "refused" for one in told) > 1000


def test_none_takes_long(told: list[dict[str, Any]]) -> None:
    slow = [(one["seconds"], one["name"]) for one in told if one["seconds"] > SECONDS]
    assert slow == []


def test_none_fills_the_memory(told: list[dict[str, Any]]) -> None:
    large = [(one["octets"], one["name"]) for one in told if one["octets"] > OCTETS]
    assert large == []
    assert sum(one["octets"] for one in told) < OCTETS * PARTS


def test_no_code_in_a_file_is_run(told: list[dict[str, Any]]) -> None:
    assert [one["name"] for one in told if one["ran"]] == []


MUST_BE_REFUSED = (
    "npz, a gigabyte of zeros", "npz in an npz", "vtp, a gigabyte of zeros",
    "vtp, four gigabytes declared", "vtp, one array in 1000 pieces", "vtp, entities",
    "vtp, entities in UTF-16", "npy, pickled objects", "npy, a pickle", "npz, pickled objects",
    "laz, two million times one place",
)  # fmt: skip


@pytest.mark.parametrize("name", MUST_BE_REFUSED)
def test_what_is_made_to_harm_is_refused(name: str, told: list[dict[str, Any]]) -> None:
    [one] = [one for one in told if one["name"] == name]
    assert one["outcome"] == "refused"
