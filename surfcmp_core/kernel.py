"""How the core compiles its kernels.

A kernel trusts its input: public functions validate. Floating point stays strict (no
re-association, no contraction), for the predicates are exact only then.
"""

from collections.abc import Callable
from typing import Any, cast

from surfcmp_core._cache import use_own_cache

use_own_cache()  # which numba would not ask about once it is imported

from numba import njit  # noqa: E402


def kernel[F: Callable[..., Any]](function: F) -> F:
    """Compile, cache on disk, and release Python's lock while running."""
    return cast(F, njit(cache=True, nogil=True, error_model="numpy")(function))


def inlined[F: Callable[..., Any]](function: F) -> F:
    """Compile into each caller: for small functions that take arrays."""
    return cast(F, njit(cache=True, nogil=True, error_model="numpy", inline="always")(function))
