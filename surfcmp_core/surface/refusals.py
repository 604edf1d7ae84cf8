"""What cannot be compared or computed with, told before any kernel sees it."""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from surfcmp_core.compiled.linear_algebra import composed, dot
from surfcmp_core.errors import InputError
from surfcmp_core.surface import Surface
from surfcmp_core.surface.used import used_nodes

LARGEST = 2.0**500
"""Up to here distances and areas in the plane are told without overflow."""
LARGEST_IN_SPACE = 2.0**250
"""Up to here those of surfaces that are turned or fitted: they need squares of areas."""
SMALLEST = 2.0**-500
"""Coordinates all below this give areas and volumes that lose digits or are told as 0."""
_MOST_OF_VOLUMES = 1001
"""Up to this power of two they are told, with some room for sums."""
_RIGID = 1e-6
"""How far a rotation's own product with itself may be from the identity: rounded decimals."""


def refuse_surface(surface: Surface, largest: float = LARGEST) -> None:
    """Refuse nodes and faces that nothing can be computed with; unused nodes are not looked at.

    Parameters
    ----------
    surface : Surface
    largest : float
        What all coordinates must stay below.

    Raises
    ------
    InputError
        Points that are not (n, 3) such numbers; faces that name no node.
    """
    points, faces, where = surface.points, surface.faces, (surface.name,)
    if not isinstance(points, np.ndarray) or points.dtype != np.float64:
        raise InputError("points are not an array of float64", where=where)
    if points.ndim != 2 or points.shape[1] != 3:
        raise InputError(f"points of shape {points.shape}; (n, 3) is needed: x, y, z", where=where)
    if faces is not None and (
        faces.ndim != 2 or faces.shape[1] != 3 or faces.dtype.kind not in "iu"
    ):
        raise InputError("faces are not (m, 3) whole numbers", where=where)
    used = used_nodes(surface)
    if not points.size:
        return
    # a NaN or an infinity shows in the extremes, so that no mask is made where all is well
    extremes = points.min(axis=0), points.max(axis=0)
    if all(np.abs(extreme).max() < largest for extreme in extremes):
        return
    bad = ~(np.abs(points) < largest)
    if used is not None:
        bad &= used[:, None]
    if bad.any():
        axis = int(np.argmax(bad.any(axis=0)))
        first = points[:, axis][bad[:, axis]][0]
        raise InputError(
            f"{int(bad.any(axis=1).sum())} of {len(points)} nodes have coordinates that "
            f"are no numbers below {largest:.3g} and give no distances or areas, "
            f"the first {'xyz'[axis]} = {first:.6g}",
            where=where,
            hints=("if it stands for no data, leave those nodes out",),
        )


def refuse_pair(first: Surface, second: Surface) -> None:
    """Refuse surfaces with areas or volumes between them that no double can tell.

    Parameters
    ----------
    first, second : Surface
        Each of which passes :func:`refuse_surface`.

    Raises
    ------
    InputError
    """
    names = first.name, second.name
    low, high = (
        pick([pick(surface.points, axis=0) for surface in (first, second)], axis=0)
        for pick in (np.min, np.max)
    )
    largest = float(np.abs([low, high])[:, :2].max())
    if not largest > SMALLEST:
        raise InputError(
            f"coordinates x, y up to {largest:.3g} are too small to give areas", where=names
        )
    if np.frexp(np.maximum(high - low, SMALLEST))[1].sum() > _MOST_OF_VOLUMES:
        extents = " by ".join(map("{:.3g}".format, high - low))
        raise InputError(f"extents of {extents} are too large to give volumes", where=names)


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
        raise InputError(f"shape {found.shape} for {len(nodes)} places (x, y)", where=("weight",))
    if found.dtype.kind not in "buif":
        raise InputError(f"gives {found.dtype}, not real numbers", where=("weight",))
    found = np.ascontiguousarray(found, np.float64)
    if not (found.min() >= 0.0 and found.max() < LARGEST):
        bad = ~((found >= 0.0) & (found < LARGEST))
        place, first = nodes[bad][0].tolist(), found[bad][0]
        raise InputError(
            f"{int(bad.sum())} of {len(found)} values are not numbers from 0 to "
            f"{LARGEST:.3g}, the first {first:.6g} at ({place[0]:.6g}, {place[1]:.6g})",
            where=("weight",),
        )
    return found
