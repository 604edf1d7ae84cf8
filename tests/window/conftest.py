"""What the tests of the window share: a screen, and a window that is surely closed."""

import os
import tempfile
from collections.abc import Iterator
from pathlib import Path

if not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import numpy as np
import pytest
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication, QEvent, QSettings
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from app.jobs.window_folder import WindowFolder
from app.window import MainWindow
from tests.window.builders import comparison_of, hills

QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, tempfile.mkdtemp())

PATIENCE = 180_000
"""Milliseconds to wait for a comparison: kernels may have to be compiled first."""


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    """Give an empty window on the screen."""
    QSettings(QSettings.Format.IniFormat, QSettings.Scope.UserScope, "surfcmp", "window").clear()
    window = MainWindow()
    qtbot.addWidget(window)
    window.resize(1000, 700)
    window.show()
    window.start()
    window.sessions.folder = WindowFolder(tmp_path / "state")
    window.activateWindow()
    qtbot.waitActive(window)
    yield window
    window.close()
    for runner in window.runners:
        assert runner.wait(PATIENCE / 1000)
    # Left to the next loop of events, it would be styled anew with every later one: in 3 s.
    window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert not isValid(window)


@pytest.fixture
def sample(window: MainWindow, qtbot: QtBot) -> MainWindow:
    """Give the window with the sample pair compared and drawn."""
    with qtbot.waitSignal(window.display.shown, timeout=PATIENCE):
        window.opening.begin([])
    return window


@pytest.fixture
def files(tmp_path: Path) -> tuple[Path, Path]:
    """Give two small clouds, 1 mm apart and a hill between them."""
    one, two = hills(300, 1), hills(200, 2, lift=3.0)
    two[:, 2] += 1.0
    paths = (tmp_path / "before.xyz", tmp_path / "after.xyz")
    for path, nodes in zip(paths, (one, two), strict=True):
        np.savetxt(path, nodes)
    return paths


@pytest.fixture(scope="session")
def clouds() -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Give two small clouds as arrays."""
    return hills(120, 1), hills(80, 2, lift=3.0)


@pytest.fixture(scope="session")
def small(clouds: tuple[NDArray[np.float64], NDArray[np.float64]]):
    """Give a small comparison with a hole in the middle of surface 2."""
    return comparison_of(*clouds, hole=20.0)
