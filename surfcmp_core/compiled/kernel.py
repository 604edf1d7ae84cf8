"""How the core compiles its kernels.

A kernel trusts its input: public functions validate. Floating point stays strict (no
re-association, no contraction), for the predicates are exact only then.
"""

import sys
from collections.abc import Callable
from typing import Any, cast

import numpy as np

from surfcmp_core.compiled.cache import use_own_cache

use_own_cache()  # which numba would not ask about once it is imported

from numba import njit  # noqa: E402


def _use_no_blas() -> None:
    """Keep numba from importing SciPy's linear algebra, which no kernel asks for, in 0.15 s."""
    name = "scipy.linalg.cython_blas"
    if name not in sys.modules:
        sys.modules[name] = None  # type: ignore[assignment]
        import numba.np.arraymath  # noqa: F401

        del sys.modules[name]


_use_no_blas()


def kernel[F: Callable[..., Any]](function: F) -> F:
    """Compile, cache on disk, and release Python's lock while running."""
    return cast(F, njit(cache=True, nogil=True, error_model="numpy")(function))


def inlined[F: Callable[..., Any]](function: F) -> F:
    """Compile into each caller: for small functions that take arrays."""
    return cast(F, njit(cache=True, nogil=True, error_model="numpy", inline="always")(function))


@inlined
def wide(number: int) -> int:
    """Give an integer one type, int64: for each type of argument a kernel is compiled anew."""
    return np.int64(number)  # type: ignore[return-value]
