"""How the stages of a comparison run: told to the user, timed, two at once where allowed."""

from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from time import perf_counter

from surfcmp_core.system.progress import Progress, silent

STAGES = ("read", "triangulate", "spanning_trees", "locate", "interpolate", "interface", "measures")
"""Names of the stages, in the order of the results' `seconds`."""


class Clock:
    """Wall time of each stage; stages that run beside each other overlap."""

    def __init__(self, progress: Progress = silent, read_seconds: float = 0.0) -> None:
        self._seconds = dict.fromkeys(STAGES, 0.0)
        self._seconds["read"] = read_seconds
        self._progress = progress
        self._begin = perf_counter() - read_seconds

    def tell(self, name: str, share: float) -> None:
        """Say how far the work is; it may be stopped there."""
        self._progress(name, share)

    @contextmanager
    def stage(self, name: str, share: float | None = None) -> Iterator[None]:
        """Time a stage; with the share of the whole work done so far, tell that it begins."""
        if share is not None:
            self._progress(name.replace("_", " "), share)
        begin = perf_counter()
        yield
        self._seconds[name] += perf_counter() - begin

    def seconds(self) -> dict[str, float]:
        """Give the times of all stages and in all."""
        return {**self._seconds, "total": perf_counter() - self._begin}


def at_once[A, B](first: Callable[[], A], second: Callable[[], B], threads: int) -> tuple[A, B]:
    """Do two works, at once where two threads are allowed; where one fails, both have ended."""
    if threads < 2:
        return first(), second()
    with ThreadPoolExecutor(1) as pool:
        other = pool.submit(second)
        return first(), other.result()


def both[A, B](work: Callable[[A], B], first: A, second: A, threads: int) -> tuple[B, B]:
    """Do the same for either surface, at once where two threads are allowed."""
    return at_once(lambda: work(first), lambda: work(second), threads)
