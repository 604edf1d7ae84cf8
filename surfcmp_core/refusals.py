"""What cannot be compared or computed with, told before any kernel sees it."""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.linear_algebra import composed, dot
from surfcmp_core.surface import Surface

LARGEST = 2.0**250
"""Up to here squares of areas are told without overflow, and no place in a table of cells or along
a curve leaves its integers."""
SMALLEST = 1.0 / LARGEST
"""Coordinates all below this have areas whose squares are told as 0."""
_RIGID = 1e-6
"""How far a rotation's own product with itself may be from the identity: rounded decimals."""


def refuse_surface(surface: Surface) -> None:
    """Refuse nodes and faces that nothing can be computed with.

    Parameters
    ----------
    surface : Surface

    Raises
    ------
    InputError
        Points that are not (n, 3) finite numbers below `LARGEST`; faces that name no node.
    """
    points, faces, name = surface.points, surface.faces, surface.name
    if not isinstance(points, np.ndarray) or points.dtype != np.float64:
        raise InputError(f"{name}: points are not an array of float64")
    if points.ndim != 2 or points.shape[1] != 3:
        raise InputError(f"{name}: points of shape {points.shape}; (n, 3) is needed: x, y, z")
    if not points.size:
        return
    # a NaN or an infinity shows in the extremes, so that no mask is made where all is well
    extremes = points.min(axis=0), points.max(axis=0)
    if not all(np.abs(extreme).max() < LARGEST for extreme in extremes):
        bad = ~(np.abs(points) < LARGEST)
        axis = "xyz"[int(np.argmax(bad.any(axis=0)))]
        first = points[:, "xyz".index(axis)][bad[:, "xyz".index(axis)]][0]
        raise InputError(
            f"{name}: {int(bad.any(axis=1).sum())} of {len(points)} nodes have coordinates that "
            f"are no numbers below {LARGEST:.3g} and give no distances or areas, "
            f"the first {axis} = {first:.6g}; if it stands for no data, leave those nodes out"
        )
    if faces is not None:
        if faces.ndim != 2 or faces.shape[1] != 3 or faces.dtype.kind not in "iu":
            raise InputError(f"{name}: faces are not (m, 3) whole numbers")
        if len(faces) and not (faces.min() >= 0 and faces.max() < len(points)):
            raise InputError(f"{name}: a face names a node that does not exist")


def refuse_tiny(*surfaces: Surface) -> None:
    """Refuse surfaces all of whose x and y are too small to give areas.

    Raises
    ------
    InputError
    """
    largest = max(float(np.abs(surface.points[:, :2]).max()) for surface in surfaces)
    if not largest > SMALLEST:
        names = " and ".join(surface.name for surface in surfaces)
        raise InputError(f"{names}: x and y up to {largest:.3g} are too small to give areas")


def fault_of_motion(matrix: NDArray[np.float64]) -> str:
    """Say why a matrix is no rigid motion.

    Parameters
    ----------
    matrix : float64

    Returns
    -------
    str
        Empty where it is one.
    """
    if matrix.shape != (4, 4) or not np.isfinite(matrix).all():
        return "not a 4×4 matrix of numbers"
    if not np.array_equal(matrix[3], [0, 0, 0, 1]):
        return "the last row of the matrix is not 0 0 0 1"
    turn = matrix[:3, :3]
    far = np.abs(turn).max() > 2.0 or np.abs(composed(turn, turn.T) - np.eye(3)).max() > _RIGID
    if far or dot(turn[0], np.cross(turn[1], turn[2])) < 0:
        return "not a rigid motion: the matrix scales, shears or mirrors"
    return ""


def motion_of(matrix: ArrayLike, name: str) -> NDArray[np.float64]:
    """Give a rigid motion.

    Parameters
    ----------
    matrix : (4, 4) float64
    name : str
        How messages call it.

    Returns
    -------
    (4, 4) float64

    Raises
    ------
    ValueError
        It is no rigid motion.
    """
    motion = np.asarray(matrix, np.float64)
    fault = fault_of_motion(motion)
    if fault:
        raise ValueError(f"{name}: {fault}")
    return motion


def weight_at(weight: Callable[..., object], nodes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Ask for a weight at the nodes of T.

    Parameters
    ----------
    weight : callable
        µ(x, y).
    nodes : (N, 2) float64

    Returns
    -------
    (N,) float64

    Raises
    ------
    InputError
        What it returns is not one number for each node, finite and zero or above.
    """
    found = np.asarray(weight(nodes[:, 0].copy(), nodes[:, 1].copy()))
    if found.shape != (len(nodes),):
        raise InputError(f"weight: shape {found.shape} for {len(nodes)} places (x, y)")
    if found.dtype.kind not in "buif":
        raise InputError(f"weight: gives {found.dtype}, not real numbers")
    found = np.ascontiguousarray(found, np.float64)
    if not (found.min() >= 0.0 and found.max() < LARGEST):
        bad = ~((found >= 0.0) & (found < LARGEST))
        place, first = nodes[bad][0].tolist(), found[bad][0]
        raise InputError(
            f"weight: {int(bad.sum())} of {len(found)} values are not numbers from 0 to "
            f"{LARGEST:.3g}, the first {first:.6g} at ({place[0]:.6g}, {place[1]:.6g})"
        )
    return found
