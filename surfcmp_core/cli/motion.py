"""The 4x4 matrix of `--align FILE`."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.linear_algebra import composed, dot

_RIGID = 1e-6
"""How far a rotation's own product with itself may be from the identity: rounded decimals."""


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
    except OSError as fault:
        raise InputError(f"{path}: {fault.strerror or fault}") from fault
    except ValueError as fault:
        raise InputError(f"{path}: not a 4×4 matrix of numbers") from fault
    if matrix.shape != (4, 4) or not np.isfinite(matrix).all():
        raise InputError(f"{path}: not a 4×4 matrix of numbers")
    if not np.array_equal(matrix[3], [0, 0, 0, 1]):
        raise InputError(f"{path}: the last row of the matrix is not 0 0 0 1")
    turn = matrix[:3, :3]
    handed = dot(turn[0], np.cross(turn[1], turn[2]))
    if np.abs(composed(turn, turn.T) - np.eye(3)).max() > _RIGID or handed < 0:
        raise InputError(f"{path}: not a rigid motion: the matrix scales, shears or mirrors")
    return matrix
