"""Any finite numbers: a finite result, or one line that says what is wrong; never a crash."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.extremes import EXTREMES

PARTS = 2


@pytest.mark.parametrize("part", range(PARTS))
def test_any_finite_numbers_give_a_result_or_one_line(part: int) -> None:
    command = [sys.executable, "-X", "faulthandler", "-m", "tests.extremes"]
    done = subprocess.run(
        [*command, "--part", str(part), "--parts", str(PARTS)],
        cwd=Path(__file__).parents[2],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-2000:]
    lines = done.stdout.splitlines()
    assert lines[-1].endswith("0 wrong")
    assert len(lines) > len(EXTREMES) / (2 * PARTS)
