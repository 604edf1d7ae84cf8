"""Compare two surfaces z = F(x, y) given on unstructured grids of different density.

>>> from surfcmp_core import read_surface, compare  # doctest: +SKIP
>>> result = compare(read_surface("a.ply"), read_surface("b.ply"))  # doctest: +SKIP
>>> result.measures.mean_abs  # doctest: +SKIP
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from surfcmp_core.comparing.comparison import Comparison
    from surfcmp_core.comparing.options import Options
    from surfcmp_core.comparing.request import compare, compare_files
    from surfcmp_core.errors import InputError
    from surfcmp_core.io import read_surface
    from surfcmp_core.surface import Surface

    __version__: str

__all__ = [
    "Comparison",
    "InputError",
    "Options",
    "Surface",
    "__version__",
    "compare",
    "compare_files",
    "read_surface",
]

_HOMES = {
    "Comparison": "surfcmp_core.comparing.comparison",
    "InputError": "surfcmp_core.errors",
    "Options": "surfcmp_core.comparing.options",
    "Surface": "surfcmp_core.surface",
    "compare": "surfcmp_core.comparing.request",
    "compare_files": "surfcmp_core.comparing.request",
    "read_surface": "surfcmp_core.io",
}


def __getattr__(name: str) -> Any:
    """Import what is asked for only when it is: reading a file needs no kernels."""
    if name == "__version__":
        from importlib.metadata import version

        return version("surfcmp")
    if name in _HOMES:
        from importlib import import_module

        return getattr(import_module(_HOMES[name]), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """Name also what has not been asked for yet."""
    return sorted({*globals(), *__all__})
