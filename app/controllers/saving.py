"""Saving and opening sessions; after a crash, the last one is offered."""

from contextlib import suppress
from functools import partial
from pathlib import Path

from platformdirs import user_state_path
from PySide6.QtCore import QObject, QTimer

from app.controllers.asking import Asking, Telling
from app.controllers.display import Display
from app.controllers.workbench import Workbench
from app.jobs.runner import Runner
from app.jobs.session_files import Fault, Located, Opened, open_session, save_session
from app.jobs.window_folder import WindowFolder
from app.model.session_text import ENDING, Eye, from_text, to_text, write
from app.scene.camera import Camera
from surfcmp_core.errors import InputError
from surfcmp_core.system.whole_files import OutputError

AUTOSAVE_MILLISECONDS = 3000
_Paths = tuple[Path | None, Path | None]
SMALL = 64 << 20
"""Scans of so many bytes in all are put into the session unless the user says otherwise."""


class Sessions(QObject):
    """Keeps what the user does."""

    def __init__(
        self, workbench: Workbench, display: Display, telling: Telling, asking: Asking
    ) -> None:
        super().__init__()
        self._workbench = workbench
        self._display = display
        self._telling = telling
        self._asking = asking
        self.folder = WindowFolder(user_state_path("surfcmp", appauthor=False) / "windows")
        self.saving, self.opening = Runner(), Runner()
        self.saving.finished.connect(self._saved)
        self.opening.finished.connect(self._opened)
        for runner in (self.saving, self.opening):
            runner.failed.connect(telling.tell)
        self._located: Located = {}
        self._place: tuple[Path, _Paths, bool] | None = None
        """Where the session lies, which surfaces it is about, whether it holds their scans."""
        self.autosaving = QTimer(self, singleShot=True, interval=AUTOSAVE_MILLISECONDS)
        self.autosaving.timeout.connect(self.autosave)
        workbench.changed.connect(self.autosaving.start)
        display.changed.connect(self.autosaving.start)

    def save_again(self) -> None:
        """Save the session where it was saved or opened; ask where it is another pair's."""
        paths = self._workbench.document.paths
        if self._place is not None and self._place[1] == paths:
            self.save(self._place[0], embed=self._place[2])
        else:
            self.ask_save()

    def ask_save(self) -> None:
        """Ask where to, and whether with the scans, and save the session."""
        if not self._workbench.document.complete:
            self._telling.tell(self.tr("There are no two surfaces to save yet"), "note")
            return
        paths = self._workbench.document.paths
        size = sum(path.stat().st_size for path in paths if path is not None and path.is_file())
        text = self.tr("Session with its scans, {:.1f} MB (*{})").format(size / 1e6, ENDING)
        kinds = [text, self.tr("Session without its scans (*{})").format(ENDING)]
        if size > SMALL:
            kinds.reverse()
        path, kind = self._asking.place(
            self.tr("Save the session"), f"comparison{ENDING}", ";;".join(kinds)
        )
        if path is not None:
            self.save(path.with_suffix(ENDING), embed=(kind or kinds[0]) == text)

    def save(self, path: Path, *, embed: bool = True) -> None:
        """Save the session beside the window, completely or not at all."""
        document, state = self._workbench.document, self._display.state
        if not document.complete:
            self._telling.tell(self.tr("There are no two surfaces to save yet"), "note")
            return
        self._place = (path, document.paths, embed)
        work = partial(save_session, path, document, state, self._hashes(), self._eye(), embed)
        self.saving.start(work)

    def ask_open(self) -> None:
        """Ask for a session and open it."""
        path = self._asking.file(self.tr("Open a session"), kinds=f"*{ENDING}")
        if path is not None:
            self.open(path)

    def open(self, path: Path, located: Located | None = None) -> None:
        """Open a session; `located` says where the user found scans that were not in place."""
        self._located = located or {}
        with suppress(OSError):  # which is told where scans are to be unpacked
            self.folder.begin()
        self.opening.start(partial(open_session, path, self.folder.scans, self._located))

    def offer_recovery(self) -> bool:
        """Offer what a window that did not end properly has saved; say whether there is any."""
        try:
            rescued = self.folder.rescue()
            if rescued is None:
                return False
            from_text(rescued.read_text(encoding="utf-8"), rescued.parent, rescued.name)
        except (OSError, UnicodeDecodeError, InputError):
            return False
        self._telling.ask(
            self.tr("The last session did not end properly."),
            self.tr("Restore it"),
            lambda: self.open(rescued),
        )
        return True

    def autosave(self) -> None:
        """Save the session, without its scans, in case the program does not end properly."""
        workbench = self._workbench
        if not workbench.document.complete:
            return
        try:
            self.folder.begin()
            state = self._display.state
            here = self.folder.path.absolute()
            text = to_text(workbench.document, state, self._hashes(), here, self._eye())
            write(self.folder.autosave, text)
        except (OSError, OutputError):
            self.autosaving.stop()  # a full disk must not disturb the work

    def close(self) -> None:
        """Forget the session saved last and its scans: this one ends properly."""
        self.autosaving.stop()
        self.folder.close()

    def _saved(self, path: Path) -> None:
        self._telling.tell(self.tr("Saved {}").format(path), "note")

    def _opened(self, opened: Opened) -> None:
        if opened.fault is not None:
            self._ask_for_scan(opened.path, opened.fault)
            return
        if not opened.document.complete:
            text = self.tr("{}: there are no two surfaces in it").format(opened.path.name)
            self._telling.tell(text)
            return
        self._telling.hide()
        if opened.path.parent != self.folder.path:
            self._place = (opened.path, opened.document.paths, opened.embedded)
        camera = None
        if opened.camera is not None:
            focus, back, up, (height,) = opened.camera
            camera = Camera(focus, back, up, height)
        self._workbench.restore(opened.document, opened.state, camera)

    def _ask_for_scan(self, path: Path, fault: Fault) -> None:
        """Say what is amiss with a scan, and offer what can be done."""
        texts = {
            "missing": self.tr("{} is not where it was when the session was saved."),
            "changed": self.tr("{} has changed since the session was saved."),
            "another": self.tr("This file is not the {} that the session was saved with."),
        }
        located = dict(self._located)
        if fault.kind == "another" and fault.path is not None:
            located[fault.number] = (fault.path, True)
            answer, work = self.tr("Use it all the same"), partial(self.open, path, located)
        else:
            answer, work = self.tr("Locate…"), partial(self._ask_where, path, fault, located)
        self._telling.ask(texts[fault.kind].format(fault.name), answer, work)

    def _ask_where(self, path: Path, fault: Fault, located: dict[int, tuple[Path, bool]]) -> None:
        title = self.tr("Where is {}?").format(fault.name)
        start = str(fault.path or path.parent)
        found = self._asking.file(title, start)
        if found is not None:
            self.open(path, {**located, fault.number: (found, False)})

    def _eye(self) -> Eye:
        camera = self._display.camera
        return camera.focus, camera.back, camera.up, (camera.height,)

    def _hashes(self) -> tuple[str, str]:
        """Return the SHA-256 of the inputs, empty where they were not read yet."""
        workbench = self._workbench
        shown = workbench.shown
        if shown is None or shown.document.paths != workbench.document.paths:
            return "", ""
        one, two = (surface.sha256 for surface in shown.comparison.surfaces)
        return one, two
