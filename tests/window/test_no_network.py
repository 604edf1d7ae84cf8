"""The window starts, shows its sample pair and closes without a network."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.network import seen, watched

PROGRAM = """
import os, re, sys
from pathlib import Path
import app.window

def sockets_of_networks():
    own = {os.readlink(f"/proc/self/fd/{name}") for name in os.listdir("/proc/self/fd")
           if os.path.lexists(f"/proc/self/fd/{name}")}
    found = []
    for kind in ("tcp", "tcp6", "udp", "udp6", "raw", "raw6"):
        table = Path(f"/proc/self/net/{kind}")
        rows = table.read_text().splitlines()[1:] if table.exists() else []
        found += [row for row in rows if f"socket:[{row.split()[9]}]" in own]
    return found

begin = app.window.MainWindow.start
def start(window):
    begin(window)
    def shown(_):
        print(sockets_of_networks() if os.path.isdir("/proc/self/fd") else [], flush=True)
        window.close()
    window.workbench.compared.connect(shown)

app.window.MainWindow.start = start
sys.exit(app.window.run([]))
"""


@pytest.mark.timeout(300)
def test_the_window_asks_no_network(tmp_path: Path):
    environment = watched(tmp_path)
    for name in ("XDG_CONFIG_HOME", "XDG_STATE_HOME"):
        environment[name] = str(tmp_path / "home")
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout == "[]\n"
    assert seen(tmp_path) == ""
