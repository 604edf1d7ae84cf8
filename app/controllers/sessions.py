"""Saving and opening sessions; after a crash, the last one is offered."""

from pathlib import Path
from typing import TYPE_CHECKING

from platformdirs import user_state_path
from PySide6.QtCore import QObject, QTimer
from PySide6.QtWidgets import QFileDialog

from app.model.document import Document
from app.model.session_file import ENDING, from_text, to_text, write
from app.model.view_state import ViewState
from surfcmp_core.errors import InputError

if TYPE_CHECKING:
    from app.window import MainWindow

AUTOSAVE_MILLISECONDS = 3000


class Sessions(QObject):
    """Keeps what the user does."""

    def __init__(self, window: "MainWindow", autosave: Path | None = None) -> None:
        super().__init__(window)
        self._window = window
        folder = user_state_path("surfcmp", appauthor=False)
        self.autosave = autosave or folder / f"autosave{ENDING}"
        self._wanted: tuple[Document, ViewState] | None = None
        self._later = QTimer(self, singleShot=True, interval=AUTOSAVE_MILLISECONDS)
        self._later.timeout.connect(self._save_now)
        window.session.changed.connect(self._later.start)
        window.display.changed.connect(self._later.start)

    def ask_save(self) -> None:
        """Ask where to and save the session."""
        name = QFileDialog.getSaveFileName(
            self._window, self.tr("Save the session"), f"comparison{ENDING}", f"*{ENDING}"
        )[0]
        if name:
            self.save(Path(name).with_suffix(ENDING))

    def save(self, path: Path) -> None:
        """Save the session, completely or not at all."""
        try:
            write(path, self._text(path.parent))
        except OSError as error:
            text = self.tr("{} cannot be written ({})")
            self._window.banner.tell(text.format(path, error.strerror))

    def ask_open(self) -> None:
        """Ask for a session and open it."""
        name = QFileDialog.getOpenFileName(
            self._window, self.tr("Open a session"), "", f"*{ENDING}"
        )[0]
        if name:
            self.open(Path(name))

    def open(self, path: Path) -> None:
        """Open a session."""
        try:
            text = path.read_text(encoding="utf-8")
            document, state, _ = from_text(text, path.parent, path.name)
        except (OSError, UnicodeDecodeError) as error:
            self._window.banner.tell(self.tr("{}: cannot be read ({})").format(path.name, error))
            return
        except InputError as error:
            self._window.banner.tell(str(error))
            return
        self._wanted = (document, state)
        session = self._window.session
        if session.shown is not None and session.shown.document == document:
            self.apply_state(document)
        session.set_document(document)

    def apply_state(self, document: Document) -> None:
        """Look at `document` as it was looked at when it was saved."""
        if self._wanted is not None and self._wanted[0] == document:
            state, self._wanted = self._wanted[1], None
            dark = self._window.display.state.dark
            changes = {name: getattr(state, name) for name in ViewState.__slots__}
            self._window.display.change(**{**changes, "dark": dark})

    def offer_recovery(self) -> bool:
        """Offer what was autosaved, if the program ended without saying so; say whether it did."""
        if not self.autosave.is_file():
            return False
        rescued = self.autosave.with_name(f"rescued{ENDING}")
        try:
            self.autosave.replace(rescued)
        except OSError:
            return False
        self._window.banner.ask(
            self.tr("The last session did not end properly."),
            self.tr("Restore it"),
            lambda: self.open(rescued),
        )
        return True

    def close(self) -> None:
        """Forget the autosaved session: this one ends properly."""
        self._later.stop()
        self.autosave.unlink(missing_ok=True)

    def _save_now(self) -> None:
        if not self._window.session.document.complete:
            return
        try:
            self.autosave.parent.mkdir(parents=True, exist_ok=True)
            write(self.autosave, self._text(self.autosave.parent))
        except OSError:
            self._later.stop()  # a full disk must not disturb the work

    def _text(self, folder: Path) -> str:
        session = self._window.session
        shown = session.shown
        one = two = ""
        if shown is not None and shown.document.paths == session.document.paths:
            one, two = (surface.sha256 for surface in shown.comparison.surfaces)
        return to_text(session.document, self._window.display.state, (one, two), folder.absolute())
