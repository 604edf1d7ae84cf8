"""One piece of work at a time on a thread beside the window; only the newest one counts."""

import threading
import time
from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from app.jobs.priority import COMPUTING, give_way
from surfcmp_core.errors import Cancelled, SurfcmpError
from surfcmp_core.system.progress import Progress


class Runner(QObject):
    """Runs work, tells its progress, and drops what was overtaken or cancelled.

    Every piece of work has a generation number. The signals reach the window's thread; those of
    an old generation are swallowed there.
    """

    progressed = Signal(str, float)
    finished = Signal(object)
    failed = Signal(str)
    cancelled = Signal()
    _told = Signal(int, str, object)

    def __init__(self) -> None:
        super().__init__()
        self._generation = 0
        self._busy = False
        self._threads: list[threading.Thread] = []
        self._told.connect(self._receive)

    @property
    def busy(self) -> bool:
        """Whether a result is still to come."""
        return self._busy

    def start(self, work: Callable[[Progress], object]) -> None:
        """Run ``work(progress)``; what was running is told to stop and its result dropped."""
        self._generation += 1
        self._busy = True
        thread = threading.Thread(
            target=self._work, args=(work, self._generation), name="comparison", daemon=True
        )
        self._threads = [t for t in self._threads if t.is_alive()] + [thread]
        thread.start()

    def cancel(self) -> None:
        """Tell the work to stop; its result will not come."""
        self._generation += 1
        if self._busy:
            self._busy = False
            self.cancelled.emit()

    def stop(self) -> None:
        """Tell all work to stop, without a word to anybody."""
        self._generation += 1
        self._busy = False

    def wait(self, seconds: float) -> bool:
        """Wait at most `seconds` for stopped work; return whether all of it has ended."""
        end = time.monotonic() + seconds
        for thread in self._threads:
            thread.join(max(end - time.monotonic(), 0.0))
        return not any(thread.is_alive() for thread in self._threads)

    def _work(self, work: Callable[[Progress], object], generation: int) -> None:
        def progress(stage: str, fraction: float) -> None:
            if generation != self._generation:
                raise Cancelled
            self._told.emit(generation, "progress", (stage, fraction))

        give_way(COMPUTING)
        try:
            self._told.emit(generation, "finished", work(progress))
        except Cancelled:
            pass
        except (SurfcmpError, OSError) as error:
            self._told.emit(generation, "failed", str(error))
        except MemoryError:
            self._told.emit(generation, "failed", self.tr("not enough memory for these surfaces"))
        except Exception as error:  # a fault of ours: the window stays, and says so
            import traceback

            traceback.print_exc()
            first = (str(error).splitlines() or [""])[0][:160]
            text = self.tr("internal error, please report it: {}")
            name = type(error).__name__
            self._told.emit(generation, "failed", text.format(f"{name}: {first}"))

    def _receive(self, generation: int, kind: str, value: object) -> None:
        if generation != self._generation:
            return
        if kind == "progress":
            assert isinstance(value, tuple)
            self.progressed.emit(*value)
            return
        self._busy = False
        if kind == "finished":
            self.finished.emit(value)
        else:
            self.failed.emit(str(value))
