"""Closing while something runs: gone within a second, without a word."""

import os
import random
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QEvent
from pytestqt.qtbot import QtBot

from app.jobs.window_folder import WindowFolder
from app.window import MainWindow
from tests.window.conftest import PATIENCE

PROGRAM = """
import sys, time
from pathlib import Path
from PySide6.QtCore import QTimer
import app.window

closed = []

def close(window):
    assert window.workbench.runner.busy
    closed.append(time.monotonic())
    window.close()

def begin(self, paths):
    self.take(paths)
    shown = [one for one in app.window.QApplication.topLevelWidgets() if hasattr(one, "runners")]
    QTimer.singleShot(int(sys.argv[3]), lambda: close(*shown))

from app.controllers.opening import Opening
Opening.begin = begin
exit_now = app.window.os._exit
def leave(status):
    print(time.monotonic() - closed[0], flush=True)
    exit_now(status)
app.window.os._exit = leave
status = app.window.run([Path(sys.argv[1]), Path(sys.argv[2])])
print(time.monotonic() - closed[0])
sys.exit(status)
"""


@pytest.mark.timeout(300)
def test_fifty_windows_closed_during_a_computation(files: tuple[Path, Path], qtbot: QtBot):
    moments = random.Random(5)
    threads = threading.active_count()
    for _ in range(50):
        window = MainWindow()
        window.show()
        window.start()
        window.sessions.folder = WindowFolder(files[0].with_suffix(""))
        window.opening.take(list(files))
        qtbot.wait(moments.choice([0, 1, 5, 20, 60, 150]))
        start = time.monotonic()
        window.close()
        assert time.monotonic() - start < 5  # the machine may be busy with other things
        window.deleteLater()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    qtbot.waitUntil(lambda: threading.active_count() <= threads, timeout=PATIENCE)


@pytest.mark.parametrize("moment", [1, 400])
def test_the_program_ends_with_its_window(tmp_path: Path, files: tuple[Path, Path], moment: int):
    home = {name: str(tmp_path) for name in ("XDG_CONFIG_HOME", "XDG_STATE_HOME")}
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, *map(str, files), str(moment)],
        capture_output=True,
        text=True,
        timeout=100,
        env={**os.environ, **home},
        check=False,
    )
    assert done.returncode == 0, done.stderr
    said = [line for line in done.stderr.splitlines() if "plugin does not support" not in line]
    assert said == []
    assert float(done.stdout.split()[-1]) < 5
