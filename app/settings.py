"""What the window remembers from one start to the next."""

import json
from pathlib import Path

from PySide6.QtCore import QByteArray, QSettings, Qt
from PySide6.QtGui import QGuiApplication

MOST_RECENT = 8

Pair = tuple[Path, Path]


def _store() -> QSettings:
    return QSettings(QSettings.Format.IniFormat, QSettings.Scope.UserScope, "surfcmp", "window")


def recent_pairs() -> list[Pair]:
    """Return the pairs opened last that are still there, the newest first."""
    try:
        stored = json.loads(str(_store().value("recent", "[]")))
        pairs = [(Path(one), Path(two)) for one, two in stored]
    except (ValueError, TypeError):
        return []
    return [pair for pair in pairs if all(path.is_file() for path in pair)]


def remember_pair(pair: Pair) -> None:
    """Put a pair at the head of the recent ones."""
    pairs = [pair, *(other for other in recent_pairs() if other != pair)][:MOST_RECENT]
    _store().setValue("recent", json.dumps([[str(path) for path in pair] for pair in pairs]))


def forget_pairs() -> None:
    """Forget which files were opened."""
    _store().remove("recent")


def dark_wanted() -> bool:
    """Return whether the window is to be dark: as chosen last, else as the system is."""
    stored = _store().value("dark")
    if stored is not None:
        return str(stored) == "true"
    return QGuiApplication.styleHints().colorScheme() == Qt.ColorScheme.Dark


def remember_dark(dark: bool) -> None:
    """Keep the choice of theme."""
    _store().setValue("dark", "true" if dark else "false")


def window_layout() -> tuple[QByteArray, QByteArray]:
    """Return the stored geometry and arrangement of the window; empty where none is."""
    store = _store()
    found = [store.value(key) for key in ("geometry", "arrangement")]
    geometry, arrangement = (
        value if isinstance(value, QByteArray) else QByteArray() for value in found
    )
    return geometry, arrangement


def remember_layout(geometry: QByteArray, arrangement: QByteArray) -> None:
    """Keep the geometry and arrangement of the window."""
    store = _store()
    store.setValue("geometry", geometry)
    store.setValue("arrangement", arrangement)


def names_hidden() -> bool:
    """Return whether exports leave out names and paths of files."""
    return str(_store().value("names hidden")) == "true"


def hide_names(hidden: bool) -> None:
    """Keep whether exports leave out names and paths of files."""
    _store().setValue("names hidden", "true" if hidden else "false")
