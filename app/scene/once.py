"""What was found once and is wanted again."""

from collections.abc import Callable
from functools import lru_cache
from typing import Any

MOST = 4
"""Results kept of each function: of the two surfaces, whole and coarse."""


class Once:
    """Keeps the newest results of pure functions, for as long as it lives itself."""

    def __init__(self) -> None:
        self._kept: dict[Callable[..., Any], Callable[..., Any]] = {}

    def __call__[**P, T](self, function: Callable[P, T], *args: P.args, **named: P.kwargs) -> T:
        """Return what the function gives: the very same for the same arguments."""
        if function not in self._kept:
            self._kept.setdefault(function, lru_cache(MOST)(function))
        found: T = self._kept[function](*args, **named)
        return found
