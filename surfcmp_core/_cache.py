"""Where numba keeps the compiled kernels."""

import os
from pathlib import Path


def use_writable_cache() -> None:
    """Send compiled kernels to the user's cache folder where the package's own is read-only.

    To be called before numba is first imported. Does nothing where the package can be written (then
    numba's own place, the `__pycache__` beside each kernel, serves) or where the user has chosen a
    place by the environment variable NUMBA_CACHE_DIR. Where no folder of the user can be written
    either, the kernels live in a temporary folder until the process ends.
    """
    if "NUMBA_CACHE_DIR" in os.environ or os.access(Path(__file__).parent, os.W_OK):
        return
    from platformdirs import user_cache_path

    folder = user_cache_path("surfcmp") / "kernels"
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        writable = False
    else:
        writable = os.access(folder, os.W_OK)
    os.environ["NUMBA_CACHE_DIR"] = str(folder) if writable else _temporary_folder()


def _temporary_folder() -> str:
    """Make a folder that only this user can read and that goes with the process."""
    import atexit
    import shutil
    import tempfile

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
