"""Killed at any moment of saving a session, the program leaves the one saved before whole."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.killing import is_killable

PROGRAM = """
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
import numpy as np
from app.jobs.session_files import open_session, save_session
from app.model.document import Document
from surfcmp_core.comparing.options import Options
from app.model.view_state import ViewState
from surfcmp_core.system.progress import silent
from tests.killing import kill_at_random, seed_of

folder = Path(sys.argv[1])
session = folder / "x.surfcmp"
inputs = TemporaryDirectory()
scans = [Path(inputs.name) / name for name in ("one.npy", "two.npy")]
for number, scan in enumerate(scans):
    np.save(scan, np.random.default_rng(number).random((20_000, 3)))

def save(number):
    document = Document((scans[0], scans[1]), Options(unit=f"{number}"))
    save_session(session, document, ViewState(), ("", ""), None, True, silent)

def is_whole():
    moved = [scan.rename(scan.with_suffix(".moved")) for scan in scans]
    with TemporaryDirectory() as unpacked:  # which compares what it unpacks with its SHA-256
        opened = open_session(session, Path(unpacked), {}, silent)
        assert all(path.is_relative_to(unpacked) for path in opened.document.paths)
    for scan, away in zip(scans, moved):
        away.rename(scan)
    return opened.fault is None and str(opened.document.options.unit).isdigit()

kill_at_random(folder, save, is_whole, seed_of(sys.argv[2:]))
"""


@pytest.mark.skipif(not is_killable(), reason="no processes can be forked on this system")
@pytest.mark.timeout(300)
def test_a_session_saved_before_a_kill_is_whole(tmp_path: Path):
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, str(tmp_path)],
        cwd=Path(__file__).parents[2],
        capture_output=True,
        text=True,
        check=False,
    )
    print(done.stdout)
    assert done.returncode == 0, done.stdout + done.stderr
