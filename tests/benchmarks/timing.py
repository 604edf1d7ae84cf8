"""Medians of repeated runs."""

import gc
from collections.abc import Callable
from statistics import median
from time import perf_counter
from typing import Any

REPEATS = 5


def seconds(*works: Callable[[], Any], repeats: int = REPEATS) -> list[float]:
    """Return the median time of each work; they take turns, so that noise meets all alike."""
    times: list[list[float]] = [[] for _ in works]
    for _ in range(repeats):
        for work, taken in zip(works, times, strict=True):
            gc.collect()
            begin = perf_counter()
            work()
            taken.append(perf_counter() - begin)
    return [median(taken) for taken in times]
