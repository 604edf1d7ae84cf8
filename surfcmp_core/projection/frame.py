"""From a viewing direction to the comparison's coordinates: z along the view."""

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from surfcmp_core.compiled.linear_algebra import applied, length, lengths
from surfcmp_core.errors import InputError
from surfcmp_core.surface import Surface

_FLAT = 0.01
"""Landmarks nearer to one line than this share of their spread give no plane."""
_ROUNDED = 2.0**-44
"""Share of its coordinates by which a motion may miss: they have 53 bits, a direction that was
found from many of them has fewer that are right."""


def direction_of_landmarks(landmarks: ArrayLike) -> NDArray[np.float64]:
    """Give the normal of the plane through three landmarks.

    Parameters
    ----------
    landmarks : (3, 3) float64
        Counter-clockwise as the viewer sees them.

    Returns
    -------
    (3,) float64
        Unit vector towards the viewer.

    Raises
    ------
    InputError
        Not three finite landmarks, or all near one line.
    """
    p = np.asarray(landmarks, np.float64)
    if p.shape != (3, 3) or not np.isfinite(p).all():
        raise InputError("the viewing direction needs three landmarks of x, y, z each")
    sides = p - np.roll(p, 1, axis=0)
    longest = lengths(sides).max()
    normal = np.cross(p[1] - p[0], p[2] - p[0])
    size = length(normal)
    if not size > _FLAT * longest * longest:
        raise InputError("the three landmarks of the viewing direction lie near one line")
    return np.asarray(normal / size)


def frame(direction: ArrayLike) -> NDArray[np.float64]:
    """Give the rotation that turns a viewing direction into +z by the shortest way.

    Parameters
    ----------
    direction : (3,) float64
        Towards the viewer; of any length but 0.

    Returns
    -------
    (4, 4) float64
        Rigid, determinant +1, no shift; the third row is the unit direction. Exactly the identity
        for +z; a half turn about x for -z.

    Raises
    ------
    InputError
        A direction that is not finite or has no length.
    """
    d = np.asarray(direction, np.float64)
    largest = np.abs(d).max(initial=0.0)
    if d.shape != (3,) or not np.isfinite(largest) or largest == 0.0:
        raise InputError(f"not a viewing direction: {np.asarray(direction).tolist()}")
    d = d / largest
    d = d / length(d)
    x, y, z = d.tolist()
    matrix = np.eye(4)
    across = x * x + y * y
    if across == 0.0:
        return matrix if z > 0.0 else np.diag([1.0, -1.0, -1.0, 1.0])
    # 1 + z loses its digits near -z; there it equals across / (1 - z)
    one_plus_z = 1.0 + z if z > -0.5 else across / (1.0 - z)
    matrix[0, :3] = 1.0 - x * x / one_plus_z, -x * y / one_plus_z, -x
    matrix[1, :3] = -x * y / one_plus_z, 1.0 - y * y / one_plus_z, -y
    matrix[2, :3] = d
    return matrix + 0.0


def rounded_off(surface: Surface, matrix: NDArray[np.float64]) -> float:
    """Tell how far apart a motion may leave nodes that it should lay at one place of the plane.

    Parameters
    ----------
    surface : Surface
        Before the motion.
    matrix : (4, 4) float64

    Returns
    -------
    float
        Some last bits of the largest coordinates on the way: in them even the file's own are
        rounded. 0 for the identity, which leaves all bits.
    """
    if np.array_equal(matrix, np.eye(4)):
        return 0.0
    largest = float(np.abs(surface.points).max(initial=0.0))
    return _ROUNDED * (largest + float(np.abs(matrix[:3, 3]).max()))


def moved(surface: Surface, matrix: NDArray[np.float64]) -> Surface:
    """Give a surface after a rigid motion.

    Parameters
    ----------
    surface : Surface
    matrix : (4, 4) float64
        Rigid; the last row is 0, 0, 0, 1.

    Returns
    -------
    Surface
        The very same for the identity, so that its nodes stay bit for bit.
    """
    if np.array_equal(matrix, np.eye(4)):
        return surface
    return replace(surface, points=applied(matrix, surface.points))
