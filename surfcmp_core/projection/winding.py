"""Triangles of one mesh that wind the same way round."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.compiled.linear_algebra import lengths
from surfcmp_core.projection.border import border_of
from surfcmp_core.surface import Surface

TURNED = "triangles turned to wind like their neighbours"
"""How `changed` calls them."""


@kernel
def _root(parent: NDArray[np.int32], against: NDArray[np.bool_], t: int) -> tuple[int, bool]:
    """Find the first triangle of a piece, and whether this one winds against it."""
    root = t
    odd = False
    while parent[root] != root:
        odd ^= against[root]
        root = parent[root]
    whole = odd
    while parent[t] != root:
        onward = parent[t]
        above = odd ^ against[t]
        parent[t] = root
        against[t] = odd
        t, odd = onward, above
    return root, whole


@kernel
def _wind(
    pairs: NDArray[np.int32],
    alike: NDArray[np.bool_],
    area: NDArray[np.float64],
    against: NDArray[np.bool_],
) -> None:
    """Tell which triangles wind against the larger part of their piece's area."""
    parent = np.arange(area.size).astype(np.int32)
    for k in range(pairs.shape[0]):
        p, p_odd = _root(parent, against, pairs[k, 0])
        q, q_odd = _root(parent, against, pairs[k, 1])
        if p != q:  # else a strip with one side: as it is
            parent[max(p, q)] = min(p, q)
            against[max(p, q)] = p_odd ^ q_odd ^ alike[k]
    balance = np.zeros(area.size)
    for t in range(area.size):
        root, odd = _root(parent, against, t)
        balance[root] += -area[t] if odd else area[t]
    for t in range(area.size):
        root, odd = _root(parent, against, t)
        parent[t] = root
        against[t] = odd
    for t in range(area.size):
        against[t] ^= balance[parent[t]] < 0.0


def wound_alike(surface: Surface) -> Surface:
    """Turn triangles of a mesh so that neighbours wind the same way round.

    Of each piece that hangs together by edges of two triangles, the larger part by area stays as it
    is. Pieces are not told which side is their outer one: no more than a file that winds alike.

    Parameters
    ----------
    surface : Surface

    Returns
    -------
    Surface
        The very same where nothing is turned; else `changed` counts the triangles.
    """
    faces = surface.faces
    if faces is None or not len(faces):
        return surface
    n = len(surface.points)
    border = border_of(faces, np.zeros(len(faces), np.uint8), n)
    if not (border[1:] == border[:-1]).all(axis=1).any():
        return surface
    tail = faces.T.ravel().astype(np.int64)
    head = np.roll(faces, -1, axis=1).T.ravel().astype(np.int64)
    keys = np.minimum(tail, head) * n + np.maximum(tail, head)
    order = np.argsort(keys, kind="stable")
    same = np.zeros(len(keys) + 1, bool)
    same[1:-1] = keys[order[1:]] == keys[order[:-1]]
    first = np.flatnonzero(~same[:-2] & same[1:-1] & ~same[2:])  # edges of two triangles exactly
    one, other = order[first], order[first + 1]
    corners = surface.points[faces]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    against = np.zeros(len(faces), bool)
    pairs = (np.stack((one, other), axis=1) % len(faces)).astype(np.int32)
    _wind(pairs, tail[one] == tail[other], lengths(across), against)
    count = int(np.count_nonzero(against))
    if not count:
        return surface
    turned = faces.copy()
    turned[against] = turned[against, ::-1]
    changed = {**surface.changed, TURNED: surface.changed.get(TURNED, 0) + count}
    return replace(surface, faces=turned, changed=changed)
