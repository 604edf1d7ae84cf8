"""Saving, exporting, finding again."""

import base64
import csv
import json
import re
import zipfile
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QFileDialog
from pytestqt.qtbot import QtBot

from app import settings
from app.actions import KINDS
from app.jobs.window_folder import WindowFolder
from app.model.tool import Tool
from app.model.view_state import Heatmap, ScaleChoice
from app.panels.command_palette import CommandPalette
from app.panels.help import HelpDialog
from app.window import MainWindow
from surfcmp_core.report import WRITERS
from tests.window.conftest import PATIENCE
from tests.window.hands import drop, kill


def test_a_session_is_saved_and_opened_again(
    sample: MainWindow, files: tuple[Path, Path], tmp_path: Path, qtbot: QtBot
):
    sample.display.change(heatmap=Heatmap.TRUST, relief=False)
    path = tmp_path / "x.surfcmp"
    document = sample.workbench.document
    with qtbot.waitSignal(sample.sessions.saving.finished, timeout=PATIENCE):
        sample.sessions.save(path)
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        drop(sample, *files)
    sample.display.change(heatmap=Heatmap.ABSOLUTE, relief=True)
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        drop(sample, path)
    assert sample.workbench.document == document
    assert sample.display.state.heatmap is Heatmap.TRUST
    assert not sample.display.state.relief


def test_a_session_restores_everything(
    sample: MainWindow, files: tuple[Path, Path], tmp_path: Path, qtbot: QtBot
):
    sample.grid.frames[3].canvas.clicked.emit(0.0, 0.0)
    sample.places.keep()
    sample.alignment_of.add_landmark(1, sample.workbench.shown.content.geometry.origin)
    sample.display.change(section=(-10.0, 0.0, 10.0, 0.0), chain=3)
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        sample.scale.changed.emit(ScaleChoice(2.5, (0.3, 0.7), banded=True, pinned=True))
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        sample.regions_of.draw(Tool.LASSO, ((-9.0, -9.0), (9.0, -9.0), (0.0, 9.0)))
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        sample.alignment.nudged.emit("z", 0.25)
    sample.display.change(section=(-10.0, 0.0, 10.0, 0.0))
    sample.display.press(int(Qt.Key.Key_Left), False)
    document, state, camera = sample.workbench.document, sample.display.state, sample.display.camera
    path = tmp_path / "x.surfcmp"
    with qtbot.waitSignal(sample.sessions.saving.finished, timeout=PATIENCE):
        sample.sessions.save(path)
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        drop(sample, *files)
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        sample.scale.changed.emit(ScaleChoice(1.0, (0.5,), pinned=True))
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        drop(sample, path)
    assert sample.workbench.document == document
    assert sample.display.state == state
    assert sample.display.camera == camera
    assert sample.alignment.pairs.text() == "Now click the same place on surface 2."
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        sample.actions_of.undo.trigger()
    assert sample.workbench.document.paths == files


def test_a_session_says_which_scan_is_missing_and_where_it_was_found(
    window: MainWindow, files: tuple[Path, Path], tmp_path: Path, qtbot: QtBot, monkeypatch
):
    with qtbot.waitSignal(window.workbench.compared, timeout=PATIENCE):
        drop(window, *files)
    path = tmp_path / "x.surfcmp"
    with qtbot.waitSignal(window.sessions.saving.finished, timeout=PATIENCE):
        window.sessions.save(path, embed=False)
    measures = window.workbench.shown.comparison.measures
    with qtbot.waitSignal(window.workbench.compared, timeout=PATIENCE):
        window.opening.open_sample()
    found = files[1].rename(tmp_path / "elsewhere.xyz")
    with qtbot.waitSignal(window.sessions.opening.finished, timeout=PATIENCE):
        window.sessions.open(path)
    assert window.banner.label.text().startswith("after.xyz is not where it was")
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(files[0]), ""))
    with qtbot.waitSignal(window.sessions.opening.finished, timeout=PATIENCE):
        qtbot.mouseClick(window.banner.action, Qt.MouseButton.LeftButton)
    assert window.banner.label.text().startswith("This file is not the after.xyz")
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(found), ""))
    with qtbot.waitSignal(window.sessions.opening.finished, timeout=PATIENCE):
        window.sessions.open(path)
    with qtbot.waitSignal(window.workbench.compared, timeout=PATIENCE):
        qtbot.mouseClick(window.banner.action, Qt.MouseButton.LeftButton)
    assert window.workbench.document.paths == (files[0], found)
    assert window.workbench.shown.comparison.measures == measures
    assert not window.banner.action.isVisible()


@pytest.mark.parametrize("kind", [0, 1])
def test_a_session_is_saved_with_or_without_its_scans(
    window: MainWindow, files: tuple[Path, Path], qtbot: QtBot, monkeypatch, kind: int
):
    with qtbot.waitSignal(window.workbench.compared, timeout=PATIENCE):
        drop(window, *files)
    path = files[0].with_name("x.surfcmp")

    def answer(_parent, _title: str, _name: str, kinds: str) -> tuple[str, str]:
        return str(path), kinds.split(";;")[kind]

    monkeypatch.setattr(QFileDialog, "getSaveFileName", answer)
    with qtbot.waitSignal(window.sessions.saving.finished, timeout=PATIENCE):
        window.sessions.ask_save()
    assert zipfile.is_zipfile(path) == (kind == 0)


def test_a_session_is_saved_again_where_it_lies(
    window: MainWindow, files: tuple[Path, Path], tmp_path: Path, qtbot: QtBot, monkeypatch
):
    with qtbot.waitSignal(window.workbench.compared, timeout=PATIENCE):
        drop(window, *files)
    path, asked = tmp_path / "x.surfcmp", []

    def answer(*_: object) -> tuple[str, str]:
        asked.append(path)
        return str(path), kinds_without_scans

    kinds_without_scans = "Session without its scans (*.surfcmp)"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", answer)
    for heatmap in (Heatmap.TRUST, Heatmap.HEIGHT_1):
        window.display.change(heatmap=heatmap)
        with qtbot.waitSignal(window.sessions.saving.finished, timeout=PATIENCE):
            qtbot.keyClick(window, Qt.Key.Key_S, Qt.KeyboardModifier.ControlModifier)
        assert json.loads(path.read_text())["view"]["heatmap"] == heatmap
    assert len(asked) == 1
    with qtbot.waitSignal(window.workbench.compared, timeout=PATIENCE):
        window.opening.swap_surfaces()
    with qtbot.waitSignal(window.sessions.saving.finished, timeout=PATIENCE):
        qtbot.keyClick(window, Qt.Key.Key_S, Qt.KeyboardModifier.ControlModifier)
    assert len(asked) == 2


def test_nothing_is_saved_without_surfaces(window: MainWindow, tmp_path: Path):
    window.sessions.ask_save()
    assert window.banner.isVisible()
    window.sessions.save(tmp_path / "x.surfcmp")
    assert not window.sessions.saving.busy


def end_here(window: MainWindow) -> None:
    """Let go of what is kept, as if the program had ended here, and keep something new."""
    folder = window.sessions.folder
    kill(folder)
    window.sessions.folder = WindowFolder(folder.path.parent)


def test_unpacked_scans_go_with_the_window(
    window: MainWindow, files: tuple[Path, Path], tmp_path: Path, qtbot: QtBot
):
    with qtbot.waitSignal(window.workbench.compared, timeout=PATIENCE):
        drop(window, *files)
    path = tmp_path / "x.surfcmp"
    with qtbot.waitSignal(window.sessions.saving.finished, timeout=PATIENCE):
        window.sessions.save(path, embed=True)
    files[0].unlink()
    with qtbot.waitSignal(window.workbench.compared, timeout=PATIENCE):
        window.sessions.open(path)
    unpacked = window.workbench.document.paths[0]
    assert unpacked != files[0]
    assert unpacked.is_file()
    window.sessions.autosave()
    end_here(window)
    assert window.sessions.offer_recovery()
    window.close()
    assert not unpacked.exists()


def test_a_crash_is_noticed_at_the_next_start(
    sample: MainWindow, files: tuple[Path, Path], tmp_path: Path, qtbot: QtBot
):
    sample.sessions.autosaving.blockSignals(True)  # only what is saved here
    sample.sessions.autosave()
    left = sample.sessions.folder.autosave
    assert left.is_file()
    document = sample.workbench.document
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        drop(sample, *files)
    end_here(sample)
    assert sample.sessions.offer_recovery()
    assert not left.is_file()
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        qtbot.mouseClick(sample.banner.action, Qt.MouseButton.LeftButton)
    assert sample.workbench.document == document
    sample.sessions.autosave()
    sample.sessions.close()
    assert list(left.parent.parent.iterdir()) == []
    assert not sample.sessions.offer_recovery()


def test_a_damaged_session_is_told_in_one_line(sample: MainWindow, tmp_path: Path, qtbot: QtBot):
    path = tmp_path / "x.surfcmp"
    path.write_bytes(b"\xff\x00")
    with qtbot.waitSignal(sample.sessions.opening.failed, timeout=PATIENCE):
        drop(sample, path)
    assert sample.banner.isVisible()
    assert "x.surfcmp" in sample.banner.label.text()


def test_every_format_can_be_exported():
    assert set(KINDS) == set(WRITERS)


@pytest.mark.parametrize("ending", [".html", ".csv", ".json"])
def test_what_is_shown_is_exported(sample: MainWindow, ending: str, tmp_path: Path, qtbot: QtBot):
    path = tmp_path / f"out{ending}"
    with qtbot.waitSignal(sample.exporting.runner.finished, timeout=PATIENCE):
        sample.exporting.write(path)
    measures = sample.workbench.shown.comparison.measures
    if ending == ".json":
        assert json.loads(path.read_text())["measures"]["rms"] == measures.rms
    elif ending == ".csv":
        with path.open() as stream:
            rows = sum(1 for _ in csv.reader(stream)) - 1
        assert rows == len(sample.workbench.shown.comparison.united.triangles)
    else:
        page = path.read_text()
        assert page.count("<figure>") == 3 + 4  # those of the report, and the views
        assert "face_before.ply" in page
    assert [found for found in tmp_path.iterdir() if found.is_file()] == [path]
    assert sample.banner.isVisible()


def test_one_action_writes_the_whole_report(
    sample: MainWindow, tmp_path: Path, qtbot: QtBot, monkeypatch
):
    monkeypatch.setattr(
        QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "report.html"), "")
    )
    with qtbot.waitSignal(sample.exporting.runner.finished, timeout=PATIENCE):
        qtbot.keyClick(sample, Qt.Key.Key_P, Qt.KeyboardModifier.ControlModifier)
    found = {path.name: path.read_bytes()[:5] for path in tmp_path.iterdir() if path.is_file()}
    assert found == {"report.html": b"<!doc", "report.pdf": b"%PDF-"}
    assert "report.pdf" in sample.banner.label.text()


def test_reports_are_light_where_the_window_is_dark(
    sample: MainWindow, tmp_path: Path, qtbot: QtBot
):
    canvas = sample.grid.frames[0].canvas
    corner = (8, canvas.height() // 2)
    sample.actions_of.toggle_dark()
    qtbot.waitUntil(lambda: canvas.grab().toImage().pixelColor(*corner).lightness() < 60)
    dark = canvas.grab().toImage().pixelColor(*corner)
    with qtbot.waitSignal(sample.exporting.runner.finished, timeout=PATIENCE):
        sample.exporting.write(tmp_path / "out.html")
    page = (tmp_path / "out.html").read_text()
    (found,) = re.findall(r'<img alt="Surface 1" src="data:image/png;base64,([^"]+)"', page)
    picture = QImage.fromData(base64.b64decode(found))
    assert picture.pixelColor(16, picture.height() // 2).lightness() > 200
    assert canvas.grab().toImage().pixelColor(*corner) == dark
    sample.actions_of.toggle_dark()


def test_exports_have_the_scale_and_regions_of_the_window(
    sample: MainWindow, tmp_path: Path, qtbot: QtBot
):
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        sample.regions_of.draw(Tool.LASSO, ((20.0, -50.0), (70.0, -50.0), (40.0, 0.0)))
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
        sample.regions.weighed.emit(0, 2.0)
    tolerances = sample.display.state.scale.tolerances
    sample.scale.changed.emit(ScaleChoice(1.5, tolerances, banded=True, pinned=True))
    data = {}
    for ending in (".json", ".html", ".pdf"):
        path = tmp_path / f"out{ending}"
        with qtbot.waitSignal(sample.exporting.runner.finished, timeout=PATIENCE):
            sample.exporting.write(path)
        data[ending] = path.read_bytes()
    record = json.loads(data[".json"])
    assert record["scale"] == {"end": 1.5, "bands": [0.5, 1.0, 2.0], "signed": True}
    shown = sample.workbench.shown
    drawn, rest = record["regions"]
    assert (drawn["name"], drawn["weight"], rest["name"]) == ("Region 1", 2.0, None)
    assert drawn["measures"]["p95"] == shown.regions[0].measures.p95
    parts = drawn["measures"]["rho_V"], rest["measures"]["rho_V"]
    assert sum(parts) == pytest.approx(record["measures"]["rho_V"], rel=1e-12)
    weighted = record["measures"]["rho_V_mu"]
    assert weighted == shown.content.comparison.measures.rho_V_mu
    assert weighted == pytest.approx(2 * parts[0] + parts[1], rel=1e-12)
    assert b"Region 1" in data[".html"]
    assert data[".pdf"].count(b"/Subtype /Image") >= 2 + 4  # the maps, and the views


def test_names_and_paths_can_be_hidden(
    window: MainWindow, files: tuple[Path, Path], tmp_path: Path, qtbot: QtBot
):
    with qtbot.waitSignal(window.workbench.compared, timeout=PATIENCE):
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
    sha = window.workbench.shown.comparison.surfaces[0].sha256
    assert sha
    assert sha in page
    title = window.grid.frames[0].title
    hidden = window.exporting.picture_of_views(1).toImage()
    assert title.fact.text() == files[0].name  # on the screen it still stands
    window.actions_of.hide.trigger()
    assert window.exporting.picture_of_views(1).toImage() != hidden


def test_an_input_is_not_overwritten(
    window: MainWindow, files: tuple[Path, Path], tmp_path: Path, qtbot: QtBot
):
    csv_files = tuple(file.rename(file.with_suffix(".csv")) for file in files)
    with qtbot.waitSignal(window.workbench.compared, timeout=PATIENCE):
        drop(window, *csv_files)
    before = csv_files[0].read_bytes()
    with qtbot.waitSignal(window.exporting.runner.failed, timeout=PATIENCE):
        window.exporting.write(csv_files[0])
    assert csv_files[0].read_bytes() == before
    assert csv_files[0].name in window.banner.label.text()


def test_recent_pairs_are_listed_and_forgotten(
    sample: MainWindow, files: tuple[Path, Path], qtbot: QtBot
):
    with qtbot.waitSignal(sample.workbench.compared, timeout=PATIENCE):
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
