"""How soon the window answers: ``python -m tests.benchmarks.window [A B | COUNT]``.

Needs a screen (xvfb-run will do). Without files the sample pair is opened; with a COUNT two clouds
of so many nodes each. The sample's times count from the start of the process, imports included.
"""

import os
import sys
import time

BEGIN = float(os.environ.get("SURFCMP_BEGIN", time.time()))  # before the imports below

from collections.abc import Callable, Iterator  # noqa: E402
from dataclasses import replace  # noqa: E402
from pathlib import Path  # noqa: E402
from tempfile import TemporaryDirectory  # noqa: E402
from typing import TYPE_CHECKING  # noqa: E402

import numpy as np  # noqa: E402
from PySide6.QtCore import QEventLoop, QSettings, QTimer  # noqa: E402
from PySide6.QtWidgets import QApplication  # noqa: E402

if TYPE_CHECKING:
    from app.drawing.studio import Pictures
    from app.window import MainWindow

TURNING_SECONDS = 3.0
IDLE_SECONDS = 2.5
"""After this the window has loaded all it needs."""
TICK = 0.01


def say(what: str, value: float, unit: str, goal: str = "") -> None:
    """Print one figure, and what it should be."""
    print(f"{what:44s}{value:8.{0 if unit in {'ms', '%'} else 2}f} {unit:3s} {goal}", flush=True)


class Lateness:
    """How late the window's thread was for what should come every 10 ms."""

    def __init__(self) -> None:
        self._late: list[float] = []
        self._last = time.perf_counter()
        self._timer = QTimer(interval=round(1000 * TICK))
        self._timer.timeout.connect(self._tick)
        self._timer.start()

    def _tick(self) -> None:
        now = time.perf_counter()
        self._late.append(now - self._last - TICK)
        self._last = now

    def tell(self, name: str, goal: str = "") -> None:
        """Print the worst since the last time, and begin anew."""
        late, self._late = np.array(self._late), []
        say(f"window's thread late while {name}, at most", 1000 * late.max(), "ms", goal)
        say("  within 50 ms", 100 * float(np.mean(late <= 0.05)), "%", f"of {len(late)}")


class Run:
    """One window, and what has come to its screen."""

    def __init__(self, window: "MainWindow") -> None:
        self.window = window
        self.pictures: list[tuple[float, Pictures]] = []
        window.display.shown.connect(lambda p: self.pictures.append((time.perf_counter(), p)))

    def wait(self, done: "Callable[[Pictures], bool]", seconds: float = 300.0) -> float:
        """Return when the first picture to come that is `done` reached the screen."""
        loop, first = QEventLoop(), len(self.pictures)
        QTimer.singleShot(round(1000 * seconds), loop.quit)
        found: list[float] = []

        def look(_: object) -> None:
            for at, pictures in self.pictures[first:]:
                if not found and done(pictures):
                    found.append(at)
                    loop.quit()

        connection = self.window.display.shown.connect(look)
        loop.exec()
        self.window.display.shown.disconnect(connection)
        return found[0] if found else float("nan")

    def pause(self, seconds: float) -> None:
        """Let the window live for so long."""
        loop = QEventLoop()
        QTimer.singleShot(round(1000 * seconds), loop.quit)
        loop.exec()


def measure_start(run: Run, lateness: Lateness, paths: list[Path]) -> None:
    """Compare, until the last picture is finished; files are opened once the window is idle."""
    begin, goal = BEGIN, "≤ 4 s" if not paths else ""
    if paths:
        run.pause(IDLE_SECONDS)
        lateness.tell("starting")
        begin = time.time()
    ready: list[float] = []
    run.window.workbench.compared.connect(lambda _: ready.append(time.time() - begin))
    run.window.opening.begin(paths)
    run.wait(lambda _: True)
    say("compared", ready[0], "s")
    say("first heatmap", time.time() - begin, "s", goal)
    if not run.pictures[-1][1].final:
        run.wait(lambda pictures: pictures.final)
    say("all views finished", time.time() - begin, "s")
    lateness.tell("comparing", "≤ 50 ms")


def measure_turning(run: Run, lateness: Lateness) -> None:
    """Turn all views by the hand, then let it rest."""
    begin = time.perf_counter()
    run.pictures.clear()
    while time.perf_counter() - begin < TURNING_SECONDS:
        run.window.grid.frames[0].canvas.turned.emit(0.02, 0.005)
        run.pause(TICK)
    frames = sum(pictures.wish.moving for _, pictures in run.pictures)
    say("frames while turning", frames / (time.perf_counter() - begin), "/s", "≥ 10")
    lateness.tell("turning")
    rest = time.perf_counter()
    say("full picture after rest", run.wait(lambda p: p.final) - rest, "s", "≤ 1 s")


def changes(window: "MainWindow") -> Iterator[tuple[str, Callable[[], object]]]:
    """Give what a person changes, one after the other."""
    display = window.display

    def scale(**given: object) -> None:
        window.scale.changed.emit(replace(display.state.scale, **given))  # type: ignore[arg-type]

    limit, tolerances = display.state.scale.limit, display.state.scale.tolerances
    yield "range", lambda: scale(limit=0.7 * limit)
    yield "bands", lambda: scale(banded=True)
    yield "tolerance", lambda: scale(tolerances=(*tolerances[:-1], 1.2 * tolerances[-1]))
    yield "brush", lambda: display.change(brush=(0.1 * limit, 0.5 * limit))
    yield "map of trust", lambda: display.change(heatmap=type(display.state.heatmap).TRUST)
    yield "chain", lambda: display.change(chain=0)
    yield "map", lambda: display.change(relief=False)


def measure_changes(run: Run) -> None:
    """Change one thing after the other."""
    for name, change in changes(run.window):
        run.pause(0.3)
        begin = time.perf_counter()
        change()
        busy = time.perf_counter() - begin
        seen = run.wait(lambda pictures: bool(pictures.images), 20)
        say(f"new picture after another {name}", 1000 * (seen - begin), "ms", "≤ 100 ms")
        if busy > 0.02:
            say("  window's thread busy", 1000 * busy, "ms")
        if not run.pictures[-1][1].final:
            run.wait(lambda pictures: pictures.final, 20)
        while run.window.workbench.runner.busy:
            run.pause(0.1)
    for relief in (False, True):
        run.window.display.change(relief=relief, picked=None)
        run.pause(2.0)
        begin = time.perf_counter()
        run.window.grid.frames[3].canvas.clicked.emit(0.01, 0.02)
        name = "relief" if relief else "map"
        say(f"pick on the {name}", 1000 * (time.perf_counter() - begin), "ms", "≤ 100 ms")


def own_pair(count: int, folder: Path) -> list[Path]:
    """Write two clouds of `count` nodes and return their paths."""
    from tests.benchmarks.surfaces import uniform_surface

    paths = [folder / f"{name}.npy" for name in ("one", "two")]
    for seed, path in enumerate(paths, 1):
        np.save(path, 100.0 * uniform_surface(count, seed).points)
    return paths


def main() -> int:
    """Measure and print."""
    global BEGIN
    words, folder = sys.argv[1:], TemporaryDirectory(prefix="surfcmp-")
    if len(words) == 1:
        begin = time.time()
        paths = own_pair(int(words[0]), Path(folder.name))
        BEGIN += time.time() - begin
    else:
        paths = [Path(word) for word in words]
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, folder.name)
    app = QApplication(sys.argv[:1])
    app.setStyle("Fusion")
    from app.window import MainWindow

    window = MainWindow()
    window.resize(1400, 1000)
    window.show()
    app.processEvents()
    say("window visible", time.time() - BEGIN, "s", "≤ 2 s")
    window.start()
    run, lateness = Run(window), Lateness()
    measure_start(run, lateness, paths)
    measure_turning(run, lateness)
    measure_changes(run)
    window.opening.swap_surfaces()
    run.pause(1.0)
    begin = time.perf_counter()
    window.close()
    say("closed while comparing", time.perf_counter() - begin, "s", "≤ 1 s")
    print(f"load of the machine{'':25s}", *(f"{load:.1f}" for load in os.getloadavg()))
    sys.stdout.flush()
    os._exit(0)


if __name__ == "__main__":
    main()
