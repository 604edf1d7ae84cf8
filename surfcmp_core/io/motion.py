"""The 4x4 matrix of `--align FILE`."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.surface.refusals import fault_of_motion


def read_motion(path: Path) -> NDArray[np.float64]:
    """Read the rigid motion that carries surface 2 onto surface 1.

    Parameters
    ----------
    path
        Text (four lines of four numbers, separated by white space, comma or semicolon; what
        follows a # is left out) or .npy.

    Returns
    -------
    (4, 4) float64
        Acting on columns (x, y, z, 1).

    Raises
    ------
    InputError
        No such file, not 16 numbers, or not a rigid motion.
    """
    try:
        if path.suffix.lower() == ".npy":
            matrix = np.asarray(np.load(path, allow_pickle=False), dtype=np.float64)
        else:
            text = path.read_text(encoding="utf-8-sig")
            lines = text.replace(",", " ").replace(";", " ").splitlines()
            rows = [line.partition("#")[0].split() for line in lines]
            matrix = np.array([[float(word) for word in row] for row in rows if row])
    except OSError as error:
        raise InputError(str(error.strerror or error), where=(str(path),)) from error
    except ValueError as error:
        raise InputError("not a 4×4 matrix of numbers", where=(str(path),)) from error
    fault = fault_of_motion(matrix)
    if fault:
        raise InputError(fault, where=(str(path),))
    return matrix
