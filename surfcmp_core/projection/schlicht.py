"""The visible one-valued part of a surface that folds or closes on itself."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.cells.doubtful import cells_over
from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.errors import InputError
from surfcmp_core.grid.safe_range import safe_scale
from surfcmp_core.predicates import orientation
from surfcmp_core.projection.backs import backs_that_hide
from surfcmp_core.projection.behind import hide
from surfcmp_core.projection.border import border_of
from surfcmp_core.projection.islands import drop_islands
from surfcmp_core.projection.outer_side import seen_from_behind
from surfcmp_core.projection.places import same_place
from surfcmp_core.projection.removed import Fate, Removed
from surfcmp_core.surface import Surface
from surfcmp_core.surface.used import UNUSED

_KEPT, _HIDDEN = int(Fate.KEPT), int(Fate.HIDDEN)
_DEGENERATE, _BACK_FACING = int(Fate.DEGENERATE), int(Fate.BACK_FACING)
_ROUNDED = 2.0**-48
"""Share of the heights by which that of a place in a triangle may be rounded."""


def schlicht_part(
    surface: Surface, *, island: float = 0.01, behind: bool | None = None, room: float = 0.0
) -> tuple[Surface, Removed]:
    """Keep what a viewer at z = +∞ sees of one side, as a function of x and y.

    Of a mesh, whole triangles go, in this order: those without area in the plane and those that
    show the other side, exactly; pieces of the rest that are small beside the largest (debris hides
    nothing); those that another triangle lies in front of, whichever side that one shows, or that
    have a node below another one at the same (x, y); and small pieces once more. What stays is
    counter-clockwise, no two triangles overlap in the plane, and no two nodes at one (x, y) differ
    in z.

    Of a cloud, only nodes below another one at the same (x, y) go.

    Parameters
    ----------
    surface : Surface
        In the comparison's coordinates, z towards the viewer.
    island : float
        Pieces with less than this share of the largest piece's area are dropped.
    behind : bool, optional
        Whether the surface is looked at from its back; see :func:`seen_from_behind`, which tells it
        where it is not given.
    room : float
        What a motion has rounded off: up to this far apart in the plane, nodes are at one place,
        and triangles no wider than this are without area. 0 where nothing was moved.

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
    nodes = surface.points[:, :2] + 0.0
    scale = safe_scale(nodes)
    if scale != 1.0:
        nodes *= scale
    z = np.ascontiguousarray(surface.points[:, 2])
    members, starts = same_place(nodes, z, room * scale)
    if surface.faces is None:
        return _upper_nodes(surface, members[_below(z, members, starts, room)])

    turned = seen_from_behind(surface)[0] if behind is None else behind
    fate, area = np.empty(len(surface.faces), np.uint8), np.empty(len(surface.faces))
    _sides(surface.points, scale, room, turned, surface.faces, fate, area)
    faces = _joined(surface.faces, z, members, starts, room)
    backs = backs_that_hide(faces, area, fate, island, len(nodes))
    faces = _upward(faces, fate, turned, backs)
    own = np.empty(len(nodes), np.int32)
    drop_islands(faces, area, island, own, fate)
    border = border_of(faces, fate, len(nodes))
    if not len(border):
        raise InputError("no triangle faces the viewer", where=(surface.name,))
    cells = cells_over(nodes, border, int(np.count_nonzero(fate == Fate.KEPT)))
    above = room + _ROUNDED * float(np.abs(z).max())
    hide(nodes, z, faces, cells, fate, backs, room * scale, above)
    if len(members):
        height = np.full(len(nodes), -np.inf)
        _heights(faces, fate, z, height)
        below = members[_below(height, members, starts, room)]
        if len(below):
            low = np.zeros(len(nodes), bool)
            low[below] = True
            _hide_low(faces, low, fate)
    if (fate == Fate.HIDDEN).any():
        drop_islands(faces, area, island, own, fate)
    return _part(surface, fate, area, turned)


def _below(
    z: NDArray[np.float64], members: NDArray[np.int64], starts: NDArray[np.int64], room: float
) -> NDArray[np.bool_]:
    """Give the members that lie below another one of their group, by more than `room`."""
    if not len(members):
        return np.zeros(0, bool)
    top = np.maximum.reduceat(z[members], starts)
    top = np.repeat(top - room, np.diff(np.append(starts, len(members))))
    return np.asarray(z[members] < top)


def _joined(
    faces: NDArray[np.int32],
    z: NDArray[np.float64],
    members: NDArray[np.int64],
    starts: NDArray[np.int64],
    room: float,
) -> NDArray[np.int32]:
    """Let triangles that meet in space meet in node numbers too, whatever the file did."""
    if not len(members):
        return faces
    first = np.ones(len(members), bool)
    first[1:] = np.diff(z[members]) > room
    first[starts] = True
    if first.all():
        return faces
    number = np.arange(len(z), dtype=np.int32)
    number[members] = members[first][np.cumsum(first) - 1]
    return number[faces]


@kernel
def _sides(
    points: NDArray[np.float64],
    scale: float,
    room: float,
    turned: bool,
    faces: NDArray[np.int32],
    fate: NDArray[np.uint8],
    area: NDArray[np.float64],
) -> None:
    """Tell by their orientation which triangles show the side that is looked at; measure all."""
    for t in range(faces.shape[0]):
        a, b, c = faces[t, 0], faces[t, 1], faces[t, 2]
        ax, ay, az = points[a, 0], points[a, 1], points[a, 2]
        bx, by, bz = points[b, 0], points[b, 1], points[b, 2]
        cx, cy, cz = points[c, 0], points[c, 1], points[c, 2]
        turn = orientation(scale * ax, scale * ay, scale * bx, scale * by, scale * cx, scale * cy)
        ux, uy, uz = bx - ax, by - ay, bz - az
        vx, vy, vz = cx - ax, cy - ay, cz - az
        nothing = 0.0
        if room > 0.0:
            long = max(abs(ux) + abs(uy), abs(vx) + abs(vy), abs(vx - ux) + abs(vy - uy))
            nothing = scale * room * (scale * long)
        if abs(turn) <= nothing:
            fate[t] = _DEGENERATE
        else:
            fate[t] = _KEPT if (turn > 0.0) != turned else _BACK_FACING
        nx = 0.5 * (uy * vz - uz * vy)
        ny = 0.5 * (uz * vx - ux * vz)
        nz = 0.5 * (ux * vy - uy * vx)
        area[t] = np.sqrt(nx * nx + ny * ny + nz * nz)


def _upward(
    faces: NDArray[np.int32],
    fate: NDArray[np.uint8],
    turned: bool,
    backs: NDArray[np.bool_] | None,
) -> NDArray[np.int32]:
    """Let triangles that count run counter-clockwise, also those that show their other side."""
    clockwise = fate == Fate.KEPT if turned else backs
    if clockwise is None:
        return faces
    return np.where(clockwise[:, None], faces[:, ::-1], faces)


@kernel
def _heights(
    faces: NDArray[np.int32],
    fate: NDArray[np.uint8],
    z: NDArray[np.float64],
    height: NDArray[np.float64],
) -> None:
    """Give the nodes of triangles that are kept their z."""
    for t in range(faces.shape[0]):
        if fate[t] == _KEPT:
            for i in range(3):
                height[faces[t, i]] = z[faces[t, i]]


@kernel
def _hide_low(faces: NDArray[np.int32], low: NDArray[np.bool_], fate: NDArray[np.uint8]) -> None:
    """Mark triangles that have a low node."""
    for t in range(faces.shape[0]):
        if fate[t] == _KEPT and (low[faces[t, 0]] or low[faces[t, 1]] or low[faces[t, 2]]):
            fate[t] = _HIDDEN


def _upper_nodes(surface: Surface, low: NDArray[np.int64]) -> tuple[Surface, Removed]:
    kept = np.delete(np.arange(len(surface.points)), low)
    counts = {Fate.HIDDEN.label: len(low)} if len(low) else {}
    removed = Removed(
        np.empty((0, 3), np.int32), np.empty(0, np.uint8), kept, counts, {}, 0.0, False
    )
    return _without(surface, kept, None, counts), removed


_IN_USE = np.uint8(255)


@kernel
def _tally(
    faces: NDArray[np.int32],
    fate: NDArray[np.uint8],
    area: NDArray[np.float64],
    of_node: NDArray[np.uint8],
    triangles: NDArray[np.int64],
    areas: NDArray[np.float64],
) -> None:
    """Count and add up triangles by fate; give each node the last one of its triangles.

    It is _IN_USE where one is kept.
    """
    for t in range(faces.shape[0]):
        triangles[fate[t]] += 1
        areas[fate[t]] += area[t]
        mark = fate[t] if fate[t] != 0 else 255
        for i in range(3):
            of_node[faces[t, i]] = max(of_node[faces[t, i]], mark)


@kernel
def _split(
    faces: NDArray[np.int32],
    fate: NDArray[np.uint8],
    number: NDArray[np.int32],
    turned: bool,
    kept: NDArray[np.int32],
    gone: NDArray[np.int32],
    why: NDArray[np.uint8],
) -> None:
    """Part the triangles that are kept, in new numbers, from those that are not."""
    k = 0
    g = 0
    for t in range(faces.shape[0]):
        if fate[t] == 0:
            for i in range(3):
                kept[k, 2 - i if turned else i] = number[faces[t, i]]
            k += 1
        else:
            for i in range(3):
                gone[g, i] = faces[t, i]
            why[g] = fate[t]
            g += 1


def _part(
    surface: Surface, fate: NDArray[np.uint8], area: NDArray[np.float64], turned: bool
) -> tuple[Surface, Removed]:
    faces = surface.faces
    assert faces is not None
    of_node = np.zeros(len(surface.points), np.uint8)
    triangles = np.zeros(len(Fate), np.int64)
    areas = np.zeros(len(Fate))
    _tally(faces, fate, area, of_node, triangles, areas)
    if not triangles[Fate.KEPT]:
        raise InputError("no triangle faces the viewer", where=(surface.name,))
    kept = np.flatnonzero(of_node == _IN_USE)
    lost = len(faces) - int(triangles[Fate.KEPT])
    new_faces, gone, why = faces, np.empty((lost, 3), np.int32), np.empty(lost, np.uint8)
    if turned or lost or len(kept) < len(of_node):
        number = np.empty(len(of_node), np.int32)
        number[kept] = np.arange(len(kept), dtype=np.int32)
        new_faces = np.empty((len(faces) - lost, 3), np.int32)
        _split(faces, fate, number, turned, new_faces, gone, why)

    reasons = [UNUSED, *(fate.label for fate in Fate if fate != Fate.KEPT)]
    nodes = np.bincount(of_node, minlength=256)
    counts = {reason: int(n) for reason, n in zip(reasons, nodes, strict=False) if n}
    removed = Removed(
        gone,
        why,
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
    points = surface.points if len(kept) == len(surface.points) else surface.points[kept]
    return replace(surface, points=points, faces=faces, dropped=dropped)
