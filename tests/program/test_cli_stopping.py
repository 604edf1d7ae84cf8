"""Ctrl-C ends the program soon and leaves nothing, even where something does not unwind."""

import signal
import subprocess
import sys
from pathlib import Path

import psutil
import pytest

PROJECT = Path(__file__).parents[2]

STUBBORN = """
import os, sys, time
from numba import njit
from app.__main__ import main
from surfcmp_core.cli import stopping
from surfcmp_core.report import outputs
from surfcmp_core.system.children import child

@njit("float64(float64, int64)", nogil=True)
def kernel(x, rounds):
    for _ in range(rounds):
        x = x * 0.5 + 1.0 / x
    return x

class HalfMade:
    def __del__(self):
        self.handle

def sleep(seconds):
    for _ in range(10 * seconds):  # a signal just ahead of a sleep does not end it
        time.sleep(0.1)

def stubborn(_comparison, _document, stream):
    stream.write(b"half")
    made = HalfMade()
    if "child" in sys.argv[1]:
        with child("import time; time.sleep(60)") as process:
            print("writing", process.pid, flush=True)
            kernel(1.0, 1 << 40)
    print("writing", os.getpid(), flush=True)
    try:
        if "kernel" in sys.argv[1]:
            kernel(1.0, 1 << 40)
        sleep(1 if "ignored" in sys.argv[1] else 60)
    finally:
        if "stubborn" in sys.argv[1]:
            sleep(60)

stopping.PATIENCE = 0.5
outputs.WRITERS[".npz"] = stubborn
sys.exit(main(sys.argv[2:]))
"""


def _ended(number: int) -> bool:
    """Whether a process ends at once; who takes note of an orphan's end may take a while."""
    try:
        process = psutil.Process(number)
        return process.status() == psutil.STATUS_ZOMBIE or process.wait(5.0) is None
    except psutil.NoSuchProcess:
        return True
    except psutil.TimeoutExpired:
        return False


@pytest.mark.parametrize(
    "kind", ["gentle", "kernel", "child", "stubborn", "stubborn, twice", "ignored"]
)
def test_interruption_ends_soon_and_leaves_nothing(tmp_path: Path, kind: str) -> None:
    for name, height in (("a", 0), ("b", 1)):
        (tmp_path / f"{name}.xyz").write_text(
            "".join(f"{x} {y} {height}\n" for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)))
        )
    before = sorted(tmp_path.iterdir())
    files = [str(tmp_path / "a.xyz"), str(tmp_path / "b.xyz")]
    ignore = "trap '' INT;" if kind == "ignored" else ""
    shell = ["sh", "-c", f'{ignore} exec "$@"', "sh"]
    command = ["compare", *files, "--out", str(tmp_path / "r.npz"), "--quiet"]
    with subprocess.Popen(
        [*shell, sys.executable, "-c", STUBBORN, kind, *command],
        cwd=PROJECT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as running:
        assert running.stdout
        word, number = running.stdout.readline().split()
        assert word == "writing"
        running.send_signal(signal.SIGHUP if kind == "stubborn" else signal.SIGINT)
        if kind.endswith("twice"):
            running.send_signal(signal.SIGTERM)
        said = running.communicate(timeout=30)
    assert _ended(int(number))  # the program, or its child
    if kind == "ignored":
        assert running.returncode == 0
        assert (tmp_path / "r.npz").read_bytes() == b"half"
        return
    assert (running.returncode, *said) == (130, "", "")
    assert sorted(tmp_path.iterdir()) == before
