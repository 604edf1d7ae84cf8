"""A picture of the window: ``python -m app.screenshot OUT.png [A B]``."""

import os
import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

from PySide6.QtCore import QSettings, QSize, QTimer
from PySide6.QtWidgets import QApplication

from app.drawing.studio import Pictures
from app.jobs.window_folder import WindowFolder
from app.window import MainWindow

SECONDS = 120
"""After this the picture has failed."""


def screenshot(
    out: Path,
    paths: list[Path],
    size: QSize | None = None,
    before: Callable[[MainWindow], None] | None = None,
) -> bool:
    """Open files (or the sample pair), wait for the finished pictures, write a PNG; say if it is.

    `before` changes the window once the comparison is shown.
    """
    app = QApplication.instance() or QApplication(sys.argv[:1])
    assert isinstance(app, QApplication)
    app.setStyle("Fusion")
    folder = TemporaryDirectory(prefix="surfcmp-")
    # as at a first start, and without a trace
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, folder.name)
    window = MainWindow()
    window.resize(size or QSize(1400, 1000))
    window.show()
    done: list[bool] = []
    last: list[Pictures] = []

    def finish() -> None:
        display, wish = window.display, last[-1].wish
        if (wish.state.drawn, wish.camera) != (display.state.drawn, display.camera):
            settled.start()  # other pictures are on their way
            return
        done.append(window.grab().save(str(out)))
        window.close()
        app.quit()

    settled = QTimer(singleShot=True, interval=400)
    settled.timeout.connect(finish)

    def shown(pictures: Pictures) -> None:
        nonlocal before
        last[:] = [pictures]
        if not pictures.final:
            settled.stop()
            return
        if before is not None:
            change, before = before, None
            change(window)
        settled.start()

    window.start()
    window.sessions.folder = WindowFolder(Path(folder.name))
    window.display.shown.connect(shown)
    window.workbench.failed.connect(lambda message: (print(message, file=sys.stderr), app.quit()))
    QTimer.singleShot(1000 * SECONDS, app.quit)
    window.opening.begin(paths)
    app.exec()
    folder.cleanup()
    return any(done)


def main() -> int:
    """Run as a program."""
    if len(sys.argv) not in {2, 4}:
        print(__doc__, file=sys.stderr)
        return 2
    if not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    out, *paths = (Path(word) for word in sys.argv[1:])
    return 0 if screenshot(out, paths) else 3


if __name__ == "__main__":
    sys.exit(main())
