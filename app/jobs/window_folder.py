"""What a window keeps on disk while it runs, apart from what other windows keep.

In the folder of all windows each has a folder of its own, and beside it a file that it holds as
long as it lives (`surfcmp_core.system.lock`). What nobody holds was left by a window that did not
end properly; the next one to start takes it for its own.
"""

import secrets
import shutil
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO

from app.model.session_text import ENDING
from surfcmp_core.system.lock import drop, make_held, take_over


class WindowFolder:
    """One window's folder: the session as saved last, and scans unpacked from sessions.

    Parameters
    ----------
    parent : Path
        The folder of all windows. Nothing is made in it before something is to be kept.
    """

    def __init__(self, parent: Path) -> None:
        self._parent = parent
        self._lock = parent / f"{secrets.token_hex(8)}.lock"
        self._held: BinaryIO | None = None

    @property
    def path(self) -> Path:
        """The window's own folder; see `begin`."""
        return self._lock.with_suffix("")

    @property
    def autosave(self) -> Path:
        """The session as it was a moment ago."""
        return self.path / f"autosave{ENDING}"

    @property
    def scans(self) -> Path:
        """Folder of scans unpacked from sessions."""
        return self.path / "scans"

    def begin(self) -> None:
        """Make the folder, and hold it until the window closes or its process ends.

        Raises
        ------
        OSError
            It cannot be made.
        """
        if self._held is None:
            self._parent.mkdir(parents=True, exist_ok=True)
            self._held = make_held(self._lock)
        self.path.mkdir(exist_ok=True)

    def rescue(self) -> Path | None:
        """Take for its own what the last window that did not end properly has left.

        Returns
        -------
        Path or None
            The session that it had saved last, in this window's folder from now on. None where
            there is none, and where this window keeps something already: then it has begun.
        """
        if self._held is not None:
            return None
        left = sorted(self._left_behind(), key=lambda one: one[0].stat().st_mtime)
        if not left:
            return None
        saved, self._lock, self._held = left.pop()
        for _, _, held in left:
            held.close()  # for the next windows that start
        return saved.replace(self.path / f"rescued{ENDING}")

    def close(self) -> None:
        """Forget all that is kept: the window ends properly."""
        if self._held is not None:
            _remove(self._lock, self._held)
            self._held = None

    def _left_behind(self) -> Iterator[tuple[Path, Path, BinaryIO]]:
        """Give sessions saved by windows that have ended; remove what was left without one."""
        for lock in self._parent.glob("*.lock"):
            held = take_over(lock)
            if held is None:
                continue
            names = [lock.with_suffix("") / f"{name}{ENDING}" for name in ("autosave", "rescued")]
            saved = next((path for path in names if path.is_file()), None)
            if saved is None:
                _remove(lock, held)
            else:
                yield saved, lock, held


def _remove(lock: Path, held: BinaryIO) -> None:
    shutil.rmtree(lock.with_suffix(""), ignore_errors=True)
    with suppress(OSError):
        drop(held, lock)
