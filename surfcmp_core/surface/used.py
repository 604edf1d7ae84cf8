"""The part of a mesh that is its surface: nodes of some face, and each face once."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.surface import Surface

UNUSED = "unused"
"""Reason of a mesh's nodes that no triangle uses, in `dropped`."""
REPEATED = "repeated triangles left out"
"""How `changed` calls triangles that stand in a mesh more than once."""

_ODD = (0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9)
"""Multipliers that spread the bits of x, y and z over a key."""


def used_part(surface: Surface) -> Surface:
    """Leave out of a mesh the triangles that it holds already, and the nodes that none uses.

    Triangles are the same that have the same three corners in space, turned either way, also where
    the mesh stands in its file twice, on nodes of its own; the first of them stays. A node of no
    triangle is no part of the surface, whatever its coordinates.

    Parameters
    ----------
    surface : Surface
        A cloud stays as it is.

    Returns
    -------
    Surface
        The very same where nothing is left out; else `changed` counts triangles, `dropped` nodes.

    Raises
    ------
    InputError
        A triangle names a node that is not there.
    """
    return without_unused(_without_repeated(surface))


def without_unused(surface: Surface) -> Surface:
    """Leave out the nodes of a mesh that no triangle uses, but no triangle.

    Parameters, result and errors are those of :func:`used_part`.
    """
    used = used_nodes(surface)
    if used is None or used.all():
        return surface
    faces = surface.faces
    assert faces is not None
    number = np.cumsum(used, dtype=np.int32) - np.int32(1)
    points = surface.points[used]
    lost = len(used) - len(points)
    dropped = {**surface.dropped, UNUSED: surface.dropped.get(UNUSED, 0) + lost}
    return replace(surface, points=points, faces=number[faces], dropped=dropped)


def nodes_in_use(surface: Surface) -> NDArray[np.int64]:
    """Give the number that each node of the :func:`used_part` has in the whole surface."""
    used = used_nodes(_without_repeated(surface))
    return np.arange(len(surface.points)) if used is None else np.flatnonzero(used)


def used_nodes(surface: Surface) -> NDArray[np.bool_] | None:
    """Tell which nodes of a mesh some triangle uses.

    Parameters
    ----------
    surface : Surface

    Returns
    -------
    (n,) bool or None
        None for a cloud, and for a mesh without triangles.

    Raises
    ------
    InputError
        A triangle names a node that is not there.
    """
    faces, n = surface.faces, len(surface.points)
    if faces is None or not faces.size:
        return None
    if faces.min() < 0 or faces.max() >= n:
        odd = int(faces.min() if faces.min() < 0 else faces.max())
        raise InputError(
            f"a triangle names node {odd}, but the nodes are 0 to {n - 1}", where=(surface.name,)
        )
    used = np.zeros(n, np.bool_)
    used[faces.ravel()] = True
    return used


def _without_repeated(surface: Surface) -> Surface:
    faces = surface.faces
    if used_nodes(surface) is None:
        return surface
    assert faces is not None
    repeated = repeated_triangles(surface.points, faces)
    if not repeated.size:
        return surface
    changed = {**surface.changed, REPEATED: surface.changed.get(REPEATED, 0) + repeated.size}
    return replace(surface, faces=np.delete(faces, repeated, axis=0), changed=changed)


def repeated_triangles(points: NDArray[np.float64], faces: NDArray[np.int32]) -> NDArray[np.int64]:
    """Find the triangles that an earlier one equals, corner by corner, in any order.

    Parameters
    ----------
    points : (n, d) float64
        In the plane or in space; only equality counts.
    faces : (m, 3) int32

    Returns
    -------
    (k,) int64
        Their numbers, ascending.
    """
    bits = (points + 0.0).view(np.uint64)  # 0.0 makes of -0.0 what it equals
    of_node = np.zeros(len(points), np.uint64)
    for axis, odd in enumerate(_ODD[: points.shape[1]]):
        of_node ^= bits[:, axis] * np.uint64(odd)
        of_node ^= of_node >> np.uint64(29)
        of_node *= np.uint64(_ODD[0])
    keys = of_node[faces[:, 0]] + of_node[faces[:, 1]] + of_node[faces[:, 2]]
    in_order = np.sort(keys)
    twice = in_order[1:][in_order[1:] == in_order[:-1]]
    if not twice.size:
        return np.empty(0, np.int64)
    # equal triangles have equal keys; whether those of equal keys are equal is asked of the corners
    asked = np.flatnonzero(np.isin(keys, twice))
    nodes, corners = np.unique(faces[asked], return_inverse=True)
    place = np.unique(points[nodes] + 0.0, axis=0, return_inverse=True)[1].reshape(-1)
    alike = np.sort(place[corners.reshape(-1, 3)], axis=1)
    first = np.unique(alike, axis=0, return_index=True)[1]
    return np.delete(asked, first)
