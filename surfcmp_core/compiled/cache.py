"""Where numba keeps the compiled kernels."""

import atexit
import hashlib
import os
import shutil
import tempfile
import time
from pathlib import Path

from platformdirs import user_cache_path

_KEPT = 30 * 24 * 3600.0
"""Seconds for which kernels of other sources are kept."""
WITHOUT_KERNELS = frozenset(
    {"__init__.py", "alignment", "cli", "colours", "comparing", "io", "report", "system"}
)
"""Parts of the core that hold no kernel, nor anything that one is compiled from."""


def use_own_cache() -> None:
    """Send compiled kernels to a folder of the user's that belongs to these very sources.

    To be called before numba is first imported. Numba looks only at the file of a kernel, not at
    those of the kernels it calls: beside the sources a changed predicate would leave its callers
    as they were. Does nothing where the user has chosen a place by the environment variable
    NUMBA_CACHE_DIR. Where no folder of the user can be written, the kernels live in a temporary
    folder until the process ends.
    """
    if "NUMBA_CACHE_DIR" in os.environ:
        return
    kernels = user_cache_path("surfcmp") / "kernels"
    folder = kernels / _digest()
    try:
        if not folder.is_dir():
            folder.mkdir(parents=True)
            _drop_old(kernels)
        writable = os.access(folder, os.W_OK)
    except OSError:
        writable = False
    os.environ["NUMBA_CACHE_DIR"] = str(folder) if writable else _temporary_folder()


def _digest() -> str:
    """Name these sources: a change in any that a kernel is compiled from changes it."""
    sources = hashlib.sha256()
    core = Path(__file__).parents[1]
    for path in sorted(core.rglob("*.py")):
        if path.relative_to(core).parts[0] not in WITHOUT_KERNELS:
            sources.update(path.read_bytes())
    return sources.hexdigest()[:16]


def _drop_old(kernels: Path) -> None:
    for folder in kernels.iterdir():
        if time.time() - folder.stat().st_mtime > _KEPT:
            shutil.rmtree(folder, ignore_errors=True)


def _temporary_folder() -> str:
    """Make a folder that only this user can read and that goes with the process."""
    folder = tempfile.mkdtemp(prefix="surfcmp-kernels-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


def is_compiled(function: object) -> bool:
    """Tell whether some run before this one has left the compiled kernel in the cache.

    Parameters
    ----------
    function
        A kernel.

    Returns
    -------
    bool
        True also where kernels are not compiled at all.
    """
    folder = getattr(getattr(function, "_cache", None), "cache_path", None)
    if folder is None:
        return True
    name = f"{function.__module__.rpartition('.')[2]}.{getattr(function, '__name__', '')}"
    return any(Path(folder).glob(f"{name}-*.nbi"))
