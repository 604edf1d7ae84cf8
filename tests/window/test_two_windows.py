"""Windows at the same time keep their own things, and find what a dead one has left."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from app.jobs.session_files import save_session
from app.jobs.window_folder import WindowFolder
from app.model.document import Document
from app.model.view_state import ViewState
from surfcmp_core.system.progress import silent
from tests.window.hands import kill

PROGRAM = """
import json, sys, threading
from dataclasses import replace
from pathlib import Path
from PySide6.QtCore import QObject, Signal
import app.window
from app.controllers.saving import Sessions

def say(**what):
    print(json.dumps(what), flush=True)

class Ear(QObject):
    heard = Signal(list)

def listen(window):
    ear = Ear(window)
    ear.heard.connect(lambda words: act(window, *words))

    def read():
        for line in sys.stdin:
            ear.heard.emit(line.split())

    threading.Thread(target=read, daemon=True).start()

def act(window, word, *more):
    workbench = window.workbench
    if word == "open":
        window.sessions.open(Path(*more))
    elif word == "compare":
        options = replace(workbench.document.options, domain=more[0])
        workbench.set_document(replace(workbench.document, options=options))
    elif word == "restore":
        window.banner.action.click()
    elif word == "save":
        window.sessions.autosave()
        say(saved=str(window.sessions.folder.autosave))
    elif word == "close":
        window.close()

def started(window):
    windows.append(window)
    start(window)

def offered(sessions):
    found, (window,) = offer(sessions), windows
    listen(window)
    window.workbench.compared.connect(lambda _: say(compared=[*map(str, paths_of(window))]))
    window.workbench.failed.connect(lambda text: say(failed=text))
    window.sessions.opening.failed.connect(lambda text: say(failed=text))
    say(offered=found)
    return True  # no sample in any case

def paths_of(window):
    return window.workbench.document.paths

windows = []
start, app.window.MainWindow.start = app.window.MainWindow.start, started
offer, Sessions.offer_recovery = Sessions.offer_recovery, offered
sys.exit(app.window.run([]))
"""


class Window:
    """A window in a process of its own, which does what it is told."""

    def __init__(self, home: Path) -> None:
        own = {name: str(home) for name in ("XDG_CONFIG_HOME", "XDG_STATE_HOME")}
        self.process = subprocess.Popen(
            [sys.executable, "-c", PROGRAM],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env=os.environ | own,
        )
        self.offered = self.hears("offered")

    def hears(self, what: str) -> Any:
        assert self.process.stdout
        said = json.loads(self.process.stdout.readline())
        assert list(said) == [what], said
        return said[what]

    def tell(self, *words: object) -> None:
        assert self.process.stdin
        print(*words, file=self.process.stdin, flush=True)

    def close(self) -> None:
        self.tell("close")
        self.ends(0)

    def ends(self, status: int) -> None:
        assert self.process.stdin
        assert self.process.stdout
        assert self.process.wait(60) == status
        self.process.stdin.close()
        self.process.stdout.close()


@pytest.fixture
def session(files: tuple[Path, Path], tmp_path: Path) -> Path:
    """Save a session with its scans, which are nowhere else then."""
    path = tmp_path / "x.surfcmp"
    save_session(path, Document(files), ViewState(), ("", ""), None, True, silent)
    for file in files:
        file.unlink()
    return path


@pytest.mark.timeout(300)
def test_two_windows_do_not_disturb_each_other(session: Path, tmp_path: Path):
    home = tmp_path / "home"
    first = Window(home)
    assert not first.offered
    first.tell("open", session)
    scans = first.hears("compared")
    first.tell("save")
    saved = Path(first.hears("saved"))

    second = Window(home)  # while the first one lives
    assert not second.offered
    second.close()
    first.tell("compare", "hull")
    assert first.hears("compared") == scans

    first.process.send_signal(signal.SIGKILL)
    first.ends(-signal.SIGKILL)
    assert saved.is_file()
    third = Window(home)
    assert third.offered
    fourth = Window(home)  # what one window has taken is not offered twice
    assert not fourth.offered
    third.tell("restore")
    assert third.hears("compared") == scans
    fourth.close()
    third.tell("compare", "hull")
    assert third.hears("compared") == scans
    third.close()
    assert not list((home / "surfcmp" / "windows").iterdir())


def left_behind(folder: Path, text: str) -> Path:
    """Do as a window that saves a session and is killed."""
    kept = WindowFolder(folder)
    kept.begin()
    kept.autosave.write_text(text)
    kill(kept)
    return kept.path


def test_each_dead_window_is_offered_once_the_newest_first(tmp_path: Path):
    for age, name in ((9, "middle"), (20, "oldest"), (3, "newest")):
        os.utime(left_behind(tmp_path, name) / "autosave.surfcmp", (-age + 1e9, -age + 1e9))
    windows = [WindowFolder(tmp_path) for _ in range(4)]
    found = [window.rescue() for window in windows]
    assert [path and path.read_text() for path in found] == ["newest", "middle", "oldest", None]
    kill(windows[1])  # dies too, before it has saved anything
    again = WindowFolder(tmp_path)
    assert again.rescue().read_text() == "middle"
    for window in (windows[0], *windows[2:], again):
        window.close()
    assert list(tmp_path.iterdir()) == []


def test_what_was_left_without_a_session_goes(tmp_path: Path):
    kept = WindowFolder(tmp_path)
    kept.begin()
    (kept.scans / "one").mkdir(parents=True)
    living = WindowFolder(tmp_path)
    living.begin()
    kill(kept)
    assert WindowFolder(tmp_path).rescue() is None
    assert not kept.path.exists()
    assert living.path.is_dir()
    living.close()


def test_nothing_is_made_before_something_is_kept(tmp_path: Path):
    kept = WindowFolder(tmp_path / "state")
    assert kept.rescue() is None
    kept.close()
    assert list(tmp_path.iterdir()) == []
