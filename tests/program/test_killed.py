"""Killed at any moment, the program leaves what was saved before whole."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.killing import is_killable

REPORT = """
import json, sys, zipfile
from pathlib import Path
import numpy as np
from surfcmp_core.report import make_record, write_outputs
from tests.core.two_squares import two_squares
from tests.killing import kill_at_random, seed_of

folder = Path(sys.argv[1])
comparison = two_squares()
document = make_record(comparison)
paths = [folder / f"report{ending}" for ending in (".html", ".npz", ".pdf", ".json")]

def save(number):
    write_outputs(comparison, document | {"created": f"at {number}"}, paths)

def is_whole():
    page, arrays, paper, record = paths
    assert page.read_text().rstrip().endswith("</html>")
    assert paper.read_bytes().startswith(b"%PDF")
    assert paper.read_bytes().rstrip().endswith(b"%%EOF")
    with np.load(arrays) as found:
        assert len(found["nodes"]) == len(comparison.united.nodes)
        assert {*found} >= {"triangles", "chain", "compared", "tree1"}
    return json.loads(record.read_text())["created"].startswith("at ")

kill_at_random(folder, save, is_whole, seed_of(sys.argv[2:]))
"""

BATCH = """
import csv, json, sys
from pathlib import Path
from tempfile import TemporaryDirectory
import numpy as np
from surfcmp_core.cli.main import run
from tests.killing import kill_at_random, seed_of

folder = Path(sys.argv[1])
inputs = TemporaryDirectory()
for number in range(5):
    nodes = np.random.default_rng(number).random((200, 3))
    np.savetxt(Path(inputs.name) / f"{number}.xyz", nodes)
table, record = folder / "pairs.csv", folder / "pairs.json"
outputs = ["--out", str(table), "--out", str(record)]

def save(number):
    tolerance = ["--tolerance", str(number), "--threads", "1", "--quiet"]
    assert run(["batch", inputs.name, *outputs, *tolerance], None) == 0

def is_whole():
    with table.open() as stream:
        assert [row["error"] for row in csv.DictReader(stream)] == 10 * [""]
    return len(json.loads(record.read_text())["pairs"]) == 10

kill_at_random(folder, save, is_whole, seed_of(sys.argv[2:]))
"""


@pytest.mark.skipif(not is_killable(), reason="no processes can be forked on this system")
@pytest.mark.timeout(300)
@pytest.mark.parametrize("program", [REPORT, BATCH], ids=["report", "batch"])
def test_what_was_saved_before_a_kill_is_whole(program: str, tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", program, str(tmp_path)],
        cwd=Path(__file__).parents[2],
        capture_output=True,
        text=True,
        check=False,
    )
    print(done.stdout)
    assert done.returncode == 0, done.stdout + done.stderr
