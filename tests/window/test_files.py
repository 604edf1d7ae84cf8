"""Saving, exporting, finding again."""

import csv
import json
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app import settings
from app.model.view_state import Heatmap
from app.panels.help import HelpDialog
from app.panels.palette import CommandPalette
from app.window import MainWindow
from tests.window.conftest import PATIENCE
from tests.window.test_window import drop


def test_a_session_is_saved_and_opened_again(
    sample: MainWindow, files: tuple[Path, Path], tmp_path: Path, qtbot: QtBot
):
    sample.display.change(heatmap=Heatmap.TRUST, relief=False)
    path = tmp_path / "x.surfcmp"
    document = sample.session.document
    sample.sessions.save(path)
    with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
        drop(sample, *files)
    sample.display.change(heatmap=Heatmap.ABSOLUTE, relief=True)
    with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
        drop(sample, path)
    assert sample.session.document == document
    assert sample.display.state.heatmap is Heatmap.TRUST
    assert not sample.display.state.relief


def test_a_crash_is_noticed_at_the_next_start(
    sample: MainWindow, files: tuple[Path, Path], tmp_path: Path, qtbot: QtBot
):
    left = sample.sessions.autosave
    sample.sessions._save_now()
    assert left.is_file()
    document = sample.session.document
    with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
        drop(sample, *files)
    assert sample.sessions.offer_recovery()
    assert not left.is_file()
    with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
        qtbot.mouseClick(sample.banner.action, Qt.MouseButton.LeftButton)
    assert sample.session.document == document
    sample.sessions._save_now()
    sample.sessions.close()
    assert not left.is_file()
    assert not sample.sessions.offer_recovery()


def test_a_damaged_session_is_told_in_one_line(sample: MainWindow, tmp_path: Path):
    path = tmp_path / "x.surfcmp"
    path.write_bytes(b"\xff\x00")
    drop(sample, path)
    assert sample.banner.isVisible()
    assert "x.surfcmp" in sample.banner.label.text()


@pytest.mark.parametrize("ending", [".html", ".csv", ".json"])
def test_what_is_shown_is_exported(sample: MainWindow, ending: str, tmp_path: Path, qtbot: QtBot):
    path = tmp_path / f"out{ending}"
    with qtbot.waitSignal(sample.exporting.runner.finished, timeout=PATIENCE):
        sample.exporting.write(path)
    measures = sample.session.shown.comparison.measures
    if ending == ".json":
        assert json.loads(path.read_text())["measures"]["rms"] == measures.rms
    elif ending == ".csv":
        with path.open() as stream:
            rows = sum(1 for _ in csv.reader(stream)) - 1
        assert rows == len(sample.session.shown.comparison.united.triangles)
    else:
        page = path.read_text()
        assert page.count("<figure>") == 3 + 4  # those of the report, and the views
        assert "face_before.ply" in page
    assert [found for found in tmp_path.iterdir() if found.is_file()] == [path]
    assert sample.banner.isVisible()


def test_names_and_paths_can_be_hidden(
    window: MainWindow, files: tuple[Path, Path], tmp_path: Path, qtbot: QtBot
):
    with qtbot.waitSignal(window.session.compared, timeout=PATIENCE):
        drop(window, *files)
    window.actions_of.hide.trigger()
    path = tmp_path / "out" / "page.html"
    path.parent.mkdir()
    with qtbot.waitSignal(window.exporting.runner.finished, timeout=PATIENCE):
        window.exporting.write(path)
    page = path.read_text()
    for file in files:
        assert file.name not in page
        assert str(file.parent) not in page
    sha = window.session.shown.comparison.surfaces[0].sha256
    assert sha
    assert sha in page


def test_an_input_is_not_overwritten(
    window: MainWindow, files: tuple[Path, Path], tmp_path: Path, qtbot: QtBot
):
    csv_files = tuple(file.rename(file.with_suffix(".csv")) for file in files)
    with qtbot.waitSignal(window.session.compared, timeout=PATIENCE):
        drop(window, *csv_files)
    before = csv_files[0].read_bytes()
    with qtbot.waitSignal(window.exporting.runner.failed, timeout=PATIENCE):
        window.exporting.write(csv_files[0])
    assert csv_files[0].read_bytes() == before
    assert csv_files[0].name in window.banner.label.text()


def test_recent_pairs_are_listed_and_forgotten(
    sample: MainWindow, files: tuple[Path, Path], qtbot: QtBot
):
    with qtbot.waitSignal(sample.session.compared, timeout=PATIENCE):
        drop(sample, *files)
    sample.actions_of.recent.aboutToShow.emit()
    names = [action.text() for action in sample.actions_of.recent.actions()]
    assert names[:2] == ["before.xyz – after.xyz", "face_before.ply – face_after.ply"]
    files[0].unlink()
    assert len(settings.recent_pairs()) == 1
    settings.forget_pairs()
    assert settings.recent_pairs() == []


def test_an_action_is_found_by_its_name(sample: MainWindow, qtbot: QtBot):
    sample.actions_of.show_palette()
    palette = sample.findChild(CommandPalette)
    qtbot.keyClicks(palette.line, "map rel")
    assert palette.list.topLevelItemCount() == 1
    qtbot.keyClick(palette.line, Qt.Key.Key_Return)
    assert not sample.display.state.relief


def test_keys_and_guide_are_told(sample: MainWindow, qtbot: QtBot):
    for show in (
        sample.actions_of.show_shortcuts,
        sample.actions_of.show_guide,
        sample.actions_of.show_about,
    ):
        show()
        dialog = sample.findChildren(HelpDialog)[-1]
        assert len(dialog.page.toPlainText()) > 100
        dialog.close()


def test_every_shortcut_is_used_once(sample: MainWindow):
    keys = [a.shortcut().toString() for a in sample.actions_of.all if not a.shortcut().isEmpty()]
    assert len(keys) == len(set(keys))
