"""Work on the triangles of T, a few at once."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial

AT_ONCE = 1 << 16
"""Triangles in a chunk; the measures are the same whatever it is."""


def over_chunks[Result](
    work: Callable[[int, int], Result],
    count: int,
    threads: int,
    progress: Callable[[float], None] | None = None,
) -> list[Result]:
    """Do all of some work in chunks that do not depend on the number of threads.

    Parameters
    ----------
    work : callable
        ``work(begin, end)`` does that part of it, without Python's lock.
    count : int
        Do 0..count - 1.
    threads : int
        How many may work at once.
    progress : callable, optional
        Called before each chunk is waited for, with the share done; may raise to cancel.

    Returns
    -------
    list
        What `work` returned, in order.
    """
    results: list[Result] = []
    with ThreadPoolExecutor(threads) as pool:
        parts = [
            pool.submit(partial(work, begin, min(begin + AT_ONCE, count)))
            for begin in range(0, count, AT_ONCE)
        ]
        try:
            for done, part in enumerate(parts):
                if progress is not None:
                    progress(done / len(parts))
                results.append(part.result())
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    return results
