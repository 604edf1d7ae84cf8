"""What must hold of nodes before they are believed."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.surface import Surface
from surfcmp_core.surface.used import without_unused

_BLOCK = 4096


def check_nodes(points: NDArray[np.float64]) -> None:
    """Refuse nodes that are not finite, fewer than three, or all on one line in space.

    Parameters
    ----------
    points : (n, 3) float64

    Raises
    ------
    InputError
        It says what is wrong and with how many.
    """
    if not np.isfinite(points).all():
        finite = np.isfinite(points).all(axis=1)
        raise InputError(
            f"{len(points) - int(finite.sum())} of {len(points)} nodes have coordinates that are "
            "not finite (--no-data nan leaves them out)"
        )
    if len(points) < 3:
        raise InputError(f"it holds {len(points)} nodes; three or more are needed")
    second = None
    for first in range(0, len(points), _BLOCK):
        other = (points[first : first + _BLOCK] != points[0]).any(axis=1)
        if other.any():
            second = points[first + np.argmax(other)]
            break
    if second is None:
        raise InputError(f"all {len(points)} nodes are at one place")
    for first in range(0, len(points), _BLOCK):
        if not _on_line(points[0], second, points[first : first + _BLOCK]):
            return
    raise InputError(f"all {len(points)} nodes are on one line")


def check_surface(points: NDArray[np.float64], faces: NDArray[np.int32] | None) -> None:
    """Refuse a surface whose nodes :func:`check_nodes` refuses; of a mesh, those of its triangles.

    Parameters
    ----------
    points : (n, 3) float64
    faces : (m, 3) int32 or None
        Numbers of nodes that are there.

    Raises
    ------
    InputError
        It says what is wrong and with how many.
    """
    if faces is not None:
        a, b, *_ = some = points[faces[:_BLOCK].ravel()]
        if np.isfinite(points).all() and not _on_line(a, b, some):
            return  # the short way, of nearly all
    check_nodes(without_unused(Surface(points, faces)).points)


def _on_line(a: NDArray[np.float64], b: NDArray[np.float64], points: NDArray[np.float64]) -> bool:
    """Whether all points are exactly on the line through a and b."""
    with np.errstate(over="ignore", invalid="ignore", under="ignore"):
        u, v = b - a, points - a
        left, right = u[[1, 2, 0]] * v[:, [2, 0, 1]], u[[2, 0, 1]] * v[:, [1, 2, 0]]
        # each factor is rounded once, each product once, the difference once: 4 eps is generous
        sure = 4 * np.finfo(np.float64).eps * (np.abs(left) + np.abs(right)) + 1e-300
        if (np.abs(left - right) > sure).any():
            return False
    a, b, *rest = _whole(np.vstack((a, b, points)))
    u, v = b - a, np.array(rest) - a
    return not (u[[1, 2, 0]] * v[:, [2, 0, 1]] != u[[2, 0, 1]] * v[:, [1, 2, 0]]).any()


def _whole(values: NDArray[np.float64]) -> NDArray[np.object_]:
    """Multiply all values by one power of two that makes them whole numbers, exactly."""
    mantissa, exponent = np.frexp(values)
    whole = (mantissa * 2.0**53).astype(np.int64).astype(object)
    return np.asarray(whole << (exponent - exponent.min()).astype(object))
