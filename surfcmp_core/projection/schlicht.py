"""The visible one-valued part of a surface that folds or closes on itself."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.grid.scaling import safe_scale
from surfcmp_core.kernel import kernel
from surfcmp_core.predicates import orientation
from surfcmp_core.projection.border import border_of
from surfcmp_core.projection.cells import cells_over
from surfcmp_core.projection.islands import drop_islands
from surfcmp_core.projection.overlap import hide
from surfcmp_core.projection.places import same_place
from surfcmp_core.projection.removed import UNUSED, Fate, Removed
from surfcmp_core.surface import Surface

_CLOSED = 0.25
"""A mesh whose vector area is below this share of its area counts as closed."""


def schlicht_part(surface: Surface, *, island: float = 0.01) -> tuple[Surface, Removed]:
    """Keep what a viewer at z = +∞ sees, as a function of x and y.

    Of a mesh, whole triangles go, in this order: those without area in the plane and those that
    face away, exactly; pieces of the rest that are small beside the largest (debris hides nothing);
    those that another triangle lies in front of, or that have a node below another one at the same
    (x, y); and small pieces once more. What stays is counter-clockwise, no two triangles overlap in
    the plane, and no two nodes at one (x, y) differ in z. The outer side is the one of the file's
    triangles; but it is taken as reversed where a closed mesh would have its outside inside, and
    where most of an open one would face away: an open sheet may be looked at from either side.

    Of a cloud, only nodes below another one at the same (x, y) go.

    Parameters
    ----------
    surface : Surface
        In the comparison's coordinates, z towards the viewer.
    island : float
        Pieces with less than this share of the largest piece's area are dropped.

    Returns
    -------
    Surface
        The part, its nodes bit for bit and in their order; nodes removed are counted in `dropped`.
    Removed
        What was left out.

    Raises
    ------
    InputError
        Nothing faces the viewer; coordinates beyond the range of exact predicates.
    """
    nodes = np.ascontiguousarray(surface.points[:, :2]) + 0.0
    scale = safe_scale(nodes)
    if scale != 1.0:
        nodes *= scale
    z = np.ascontiguousarray(surface.points[:, 2])
    members, starts = same_place(nodes, z)
    if surface.faces is None:
        return _upper_nodes(surface, members[_below(z, members, starts)])

    side, area, turned = _sides_of(surface, nodes)
    faces = _joined(surface.faces, z, members, starts)
    if turned:
        faces = np.ascontiguousarray(faces[:, ::-1])
        side = -side
    fate = np.array([Fate.DEGENERATE, Fate.KEPT, Fate.BACK_FACING], np.uint8)[side]
    room = np.empty(len(nodes), np.int32)
    drop_islands(faces, area, island, room, fate)
    border = border_of(faces, fate, len(nodes))
    if not len(border):
        raise InputError(f"{surface.name}: no triangle faces the viewer")
    cells = cells_over(nodes, border, int(np.count_nonzero(fate == Fate.KEPT)))
    hide(nodes, z, faces, cells, fate)
    if len(members):
        used = np.zeros(len(nodes), bool)
        used[faces[fate == Fate.KEPT]] = True
        low = np.zeros(len(nodes), bool)
        low[members[_below(np.where(used, z, -np.inf), members, starts)]] = True
        fate[low[faces].any(axis=1) & (fate == Fate.KEPT)] = Fate.HIDDEN
    if (fate == Fate.HIDDEN).any():
        drop_islands(faces, area, island, room, fate)
    return _part(surface, fate, area, turned)


def _below(
    z: NDArray[np.float64], members: NDArray[np.int64], starts: NDArray[np.int64]
) -> NDArray[np.bool_]:
    """Give the members that lie below another one of their group."""
    if not len(members):
        return np.zeros(0, bool)
    top = np.maximum.reduceat(z[members], starts)
    return np.asarray(z[members] < np.repeat(top, np.diff(np.append(starts, len(members)))))


def _joined(
    faces: NDArray[np.int32],
    z: NDArray[np.float64],
    members: NDArray[np.int64],
    starts: NDArray[np.int64],
) -> NDArray[np.int32]:
    """Let triangles that meet in space meet in node numbers too, whatever the file did."""
    if not len(members):
        return faces
    first = np.ones(len(members), bool)
    first[1:] = z[members[1:]] != z[members[:-1]]
    first[starts] = True
    number = np.arange(len(z), dtype=np.int32)
    number[members] = members[first][np.cumsum(first) - 1]
    return number[faces]


@kernel
def _sides(
    points: NDArray[np.float64],
    nodes: NDArray[np.float64],
    faces: NDArray[np.int32],
    middle: NDArray[np.float64],
    side: NDArray[np.int8],
    area: NDArray[np.float64],
) -> tuple[float, float, float, float]:
    """Orient and measure triangles; give their vector area and the volume they enclose."""
    sum_x = sum_y = sum_z = volume = 0.0
    for t in range(faces.shape[0]):
        a, b, c = faces[t, 0], faces[t, 1], faces[t, 2]
        turn = orientation(
            nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1], nodes[c, 0], nodes[c, 1]
        )
        side[t] = (turn > 0.0) - (turn < 0.0)
        ux, uy, uz = (
            points[b, 0] - points[a, 0],
            points[b, 1] - points[a, 1],
            points[b, 2] - points[a, 2],
        )
        vx, vy, vz = (
            points[c, 0] - points[a, 0],
            points[c, 1] - points[a, 1],
            points[c, 2] - points[a, 2],
        )
        nx = 0.5 * (uy * vz - uz * vy)
        ny = 0.5 * (uz * vx - ux * vz)
        nz = 0.5 * (ux * vy - uy * vx)
        area[t] = np.sqrt(nx * nx + ny * ny + nz * nz)
        sum_x += nx
        sum_y += ny
        sum_z += nz
        volume += (
            nx * (points[a, 0] - middle[0])
            + ny * (points[a, 1] - middle[1])
            + nz * (points[a, 2] - middle[2])
        )
    return sum_x, sum_y, sum_z, volume


def _sides_of(
    surface: Surface, nodes: NDArray[np.float64]
) -> tuple[NDArray[np.int8], NDArray[np.float64], bool]:
    """Give each triangle's side (1: towards the viewer) and area, and whether to turn all over."""
    faces = surface.faces
    assert faces is not None
    side = np.empty(len(faces), np.int8)
    area = np.empty(len(faces))
    *vector, volume = _sides(surface.points, nodes, faces, surface.points.mean(axis=0), side, area)
    if np.linalg.norm(vector) < _CLOSED * area.sum():
        return side, area, volume < 0.0
    return side, area, vector[2] < 0.0


def _upper_nodes(surface: Surface, low: NDArray[np.int64]) -> tuple[Surface, Removed]:
    kept = np.delete(np.arange(len(surface.points)), low)
    counts = {Fate.HIDDEN.label: len(low)} if len(low) else {}
    removed = Removed(
        np.empty((0, 3), np.int32), np.empty(0, np.uint8), kept, counts, {}, 0.0, False
    )
    return _without(surface, kept, None, counts), removed


_IN_USE = np.uint8(255)


@kernel
def _last_fates(
    faces: NDArray[np.int32], fate: NDArray[np.uint8], of_node: NDArray[np.uint8]
) -> None:
    """Give each node the last of its triangles' fates, and _IN_USE where one is kept."""
    for t in range(faces.shape[0]):
        mark = fate[t] if fate[t] != 0 else 255
        for i in range(3):
            of_node[faces[t, i]] = max(of_node[faces[t, i]], mark)


@kernel
def _renumber(
    faces: NDArray[np.int32],
    fate: NDArray[np.uint8],
    number: NDArray[np.int32],
    turned: bool,
    new_faces: NDArray[np.int32],
) -> None:
    k = 0
    for t in range(faces.shape[0]):
        if fate[t] == 0:
            for i in range(3):
                new_faces[k, 2 - i if turned else i] = number[faces[t, i]]
            k += 1


def _part(
    surface: Surface, fate: NDArray[np.uint8], area: NDArray[np.float64], turned: bool
) -> tuple[Surface, Removed]:
    faces = surface.faces
    assert faces is not None
    triangles = np.bincount(fate, minlength=len(Fate))
    if not triangles[Fate.KEPT]:
        raise InputError(f"{surface.name}: no triangle faces the viewer")
    of_node = np.zeros(len(surface.points), np.uint8)
    _last_fates(faces, fate, of_node)
    kept = np.flatnonzero(of_node == _IN_USE)
    number = np.empty(len(of_node), np.int32)
    number[kept] = np.arange(len(kept), dtype=np.int32)
    new_faces = np.empty((int(triangles[Fate.KEPT]), 3), np.int32)
    _renumber(faces, fate, number, turned, new_faces)

    reasons = [UNUSED, *(fate.label for fate in Fate if fate != Fate.KEPT)]
    nodes = np.bincount(of_node, minlength=256)
    counts = {reason: int(n) for reason, n in zip(reasons, nodes, strict=False) if n}
    areas = np.bincount(fate, area, len(Fate))
    gone = np.flatnonzero(fate)
    removed = Removed(
        faces[gone],
        fate[gone],
        kept,
        counts,
        {f.label: float(areas[f]) for f in Fate if f != Fate.KEPT and triangles[f]},
        float(areas[Fate.KEPT]),
        turned,
    )
    return _without(surface, kept, new_faces, counts), removed


def _without(
    surface: Surface,
    kept: NDArray[np.int64],
    faces: NDArray[np.int32] | None,
    counts: dict[str, int],
) -> Surface:
    dropped = dict(surface.dropped)
    for reason, count in counts.items():
        dropped[reason] = dropped.get(reason, 0) + count
    return replace(surface, points=surface.points[kept], faces=faces, dropped=dropped)
