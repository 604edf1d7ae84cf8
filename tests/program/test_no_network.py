"""Nothing goes into a network, and nothing comes from one."""

import subprocess
import sys
from pathlib import Path

import pytest

from surfcmp_core.report import WRITERS
from tests.network import seen, watched

COMMANDS = {
    "compare": ["compare", "A", "B", *(w for e in WRITERS for w in ("--out", f"DIR/r{e}"))],
    "best fit": ["compare", "A", "B", "--align", "icp", "--exact"],
    "batch": ["batch", "A", "B", "--out", "DIR/pairs.csv", "--out", "DIR/pairs.json"],
    "info": ["info", "A"],
    "thin": ["thin", "A", "--keep", "0.5", "--out", "DIR/thinned.ply"],
    "help": ["--help"],
}


def run(folder: Path, *command: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, *command],
        env=watched(folder),
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.parametrize("command", COMMANDS.values(), ids=COMMANDS)
def test_no_command_asks_a_network(
    command: list[str], pair: tuple[str, str], tmp_path: Path
) -> None:
    names = {"A": pair[0], "B": pair[1]}
    folder = tmp_path / "watched"
    folder.mkdir()
    words = [names.get(word, word).replace("DIR", str(tmp_path)) for word in command]
    done = run(folder, "-m", "app", *words)
    assert done.returncode == 0, done.stderr
    assert seen(folder) == ""


@pytest.mark.parametrize(
    "program",
    [
        "import socket; socket.create_connection(('127.0.0.1', 9))",
        "import socket; socket.getaddrinfo('localhost', 80)",
        "import urllib.request as r; r.urlopen('http://127.0.0.1:9/')",
        "import subprocess, sys; subprocess.run([sys.executable, '-c', 'import socket as s;"
        ' s.socket(s.AF_INET, s.SOCK_DGRAM).sendto(b"", ("127.0.0.1", 9))\'], check=True)',
    ],
)
def test_who_asks_a_network_is_seen(program: str, tmp_path: Path) -> None:
    assert run(tmp_path, "-c", program).returncode != 0
    assert seen(tmp_path) != ""
