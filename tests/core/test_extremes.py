"""Any finite numbers: a finite result, or one line that says what is wrong; never a crash."""

import subprocess
import sys
from pathlib import Path

from tests.extremes import EXTREMES


def test_any_finite_numbers_give_a_result_or_one_line() -> None:
    done = subprocess.run(
        [sys.executable, "-X", "faulthandler", "-m", "tests.extremes"],
        cwd=Path(__file__).parents[2],
        capture_output=True,
        text=True,
        check=False,
    )
    lines = done.stdout.splitlines()
    assert done.returncode == 0, (lines[-1:], done.stderr[-2000:])
    assert all(":" in line for line in lines[:-1])
    assert len(lines) > 10 * len(EXTREMES)
