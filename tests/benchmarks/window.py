"""How soon the window answers: ``python -m tests.benchmarks.window [A B]``.

Needs a screen (xvfb-run will do). Without files the sample pair is opened. Times count from the
start of the process, imports included.
"""

import os
import sys
import time
from dataclasses import replace
from pathlib import Path

BEGIN = float(os.environ.get("SURFCMP_BEGIN", time.time()))
TURNS = 150


def since() -> float:
    """Return seconds since the process began."""
    return time.time() - BEGIN


def main() -> int:
    """Measure and print."""
    from PySide6.QtCore import QTimer
    from PySide6.QtWidgets import QApplication

    from app.views.studio import Pictures
    from app.window import MainWindow

    app = QApplication(sys.argv[:1])
    app.setStyle("Fusion")
    window = MainWindow()
    window.resize(1400, 1000)
    window.show()
    app.processEvents()
    print(f"window visible            {since():7.2f} s")
    window.start()
    lateness: list[float] = []
    last = [time.perf_counter()]
    frames: list[Pictures] = []
    marks: dict[str, float] = {}

    def tick() -> None:
        now = time.perf_counter()
        lateness.append(now - last[0] - 0.01)
        last[0] = now

    def worst(name: str) -> None:
        late = sorted(lateness)
        share = sum(value <= 0.05 for value in late) / len(late)
        print(
            f"GUI late while {name:10s} {1000 * late[-1]:7.0f} ms at most,"
            f" {100 * share:.1f} % of ticks within 50 ms"
        )
        lateness.clear()

    def shown(pictures: Pictures) -> None:
        if pictures.wish.content is None:
            return
        frames.append(pictures)
        if "first" not in marks:
            marks["first"] = since()
            print(f"first heatmap             {marks['first']:7.2f} s")
        if pictures.final and "turn" not in marks:
            worst("comparing")
            marks["turn"] = time.perf_counter()
            frames.clear()
            turn()
        elif pictures.final and "rest" in marks and "full" not in marks:
            marks["full"] = time.perf_counter()
            print(f"full picture after rest   {marks['full'] - marks['rest']:7.2f} s")
            QTimer.singleShot(200, change)
        elif "change" in marks and "changed" not in marks:
            marks["changed"] = time.perf_counter()
            print(f"new picture after change  {marks['changed'] - marks['change']:7.2f} s")
            marks["close"] = time.perf_counter()
            window.close()

    def turn() -> None:
        window.display._turn(0.02, 0.005)
        marks["turns"] = marks.get("turns", 0) + 1
        if marks["turns"] < TURNS:
            QTimer.singleShot(10, turn)
            return
        moving = [picture for picture in frames if picture.wish.moving]
        seconds = time.perf_counter() - marks["turn"]
        print(f"frames while turning      {len(moving) / seconds:7.1f} in a second")
        worst("turning")
        marks["rest"] = time.perf_counter()

    def change() -> None:
        marks["change"] = time.perf_counter()
        scale = window.display.state.scale
        window.display.change(scale=replace(scale, limit=scale.limit * 0.7))
        print(f"GUI busy with a change    {1000 * (time.perf_counter() - marks['change']):7.0f} ms")
        begin = time.perf_counter()
        window.display._pick(3, 0.01, 0.02)
        print(f"GUI busy with a pick      {1000 * (time.perf_counter() - begin):7.0f} ms")

    timer = QTimer(interval=10)
    timer.timeout.connect(tick)
    timer.start()
    window.display.shown.connect(shown)
    window.session.compared.connect(lambda _: print(f"compared                  {since():7.2f} s"))
    window.opening.begin([Path(word) for word in sys.argv[1:]])
    app.exec()
    print(f"closed within             {time.perf_counter() - marks['close']:7.2f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
