"""The viewing direction of scans that lie as they came."""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from itertools import product

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.linear_algebra import (
    dot,
    dots,
    eigen,
    length,
    lengths,
    moments,
    weighed_sum,
)
from surfcmp_core.errors import InputError
from surfcmp_core.projection.flat_bits import Samples, samples_of
from surfcmp_core.projection.frame import frame
from surfcmp_core.projection.view import seen
from surfcmp_core.surface import Surface

_CLOSED = 0.25
"""Below this openness a mesh counts as closed."""
_SHEET = 0.5
"""Above this openness a mesh is a sheet, and its mean normal tells its sides apart; with a cosine
below the negative of this, two such normals point to opposite sides."""
_RANK = 1e-5
"""Weight of what decides among views that show the same area."""
_FILLED = 4.0
"""In that, weight of the filled share of the outline beside the shadow's."""
_RANK_CLOSED = 0.03
"""Weight of the shadow for closed meshes: convex ones show half of themselves in every view."""
_ALIKE = 10
"""Decimals to which two views are told apart."""
_ALIKE_CLOSED = 3
"""The same for front and back of closed meshes, which show different bits."""
_LATTICE = 3
"""The first views go through the points of a cube's surface, this many steps from its centre."""
_STARTS = 2
"""The best of the first views, from which the search goes on."""
_STEPS = (8.0, 4.0)
"""Degrees, nearly: see `_ring`."""
_LAST_STEPS = (4.0, 2.0, 2.0, 1.0, 1.0, 0.5, 0.5, 0.25, 0.125)
"""Every other one with its neighbours between those of the step before."""
_NOTHING = 1e-12
"""Parts of a direction below this are rounding: it lies along one of the file's axes or planes."""
_FIRST_LOOK = 5000
"""Bits that are enough but for the last steps."""


def viewing_direction(*surfaces: Surface) -> NDArray[np.float64]:
    """Find one direction from which to look at one surface, or at both of a pair.

    For meshes it is the direction from which the largest area is seen at once: facing the viewer
    and with nothing in front. Of views that show the same, one is taken that leaves few gaps in
    its convex outline (seen from where it was taken a scan has none: what is missing was hidden)
    and casts a large shadow (for gently sloping meshes this is the area-weighted normal). Of a
    closed mesh each view shows half or less, and convex ones half in each: there the shadow counts
    for more, and where front and back show the same, the first triangles decide. A head may show
    more of itself from the side than from the front: what is seen tells no face. Small loose parts
    have no say.
    Each surface of a pair counts as much as the other. The search runs in axes that the shape
    itself gives, so that a turned scan has the turned direction; meshes go by their outward sides
    (right-hand rule), but for two sheets wound against each other, which are seen from the side of
    the files' +z axis.

    Clouds have no sides. Beside a mesh they have no say; else the direction is the normal of their
    plane of least squares, on the side of the files' +z axis (+y, +x where it lies at right angles
    to that).

    Parameters
    ----------
    *surfaces : Surface
        One or two, in common coordinates.

    Returns
    -------
    (3,) float64
        Unit vector towards the viewer.

    Raises
    ------
    InputError
        Nodes all near one line or one place.
    """
    meshes = [samples for s in surfaces if (samples := samples_of(s)) is not None]
    if not meshes:
        return _normal_of_clouds(surfaces)
    meshes = _wound_together(meshes)
    axes = _own_axes(meshes)
    return _straight(weighed_sum(_best_view([mesh.turned(axes) for mesh in meshes]), axes))


def _normal_of_clouds(surfaces: tuple[Surface, ...]) -> NDArray[np.float64]:
    spread = np.zeros((3, 3))
    for surface in surfaces:
        places = surface.points - surface.points.mean(axis=0)
        scale = np.abs(places).max(initial=0.0)
        if scale > 0.0:
            places = places / scale
            spread += moments(places, np.full(len(places), scale * scale / len(places)))
    values, vectors = eigen(spread)
    if not values[1] > 1e-12 * values[2]:
        fault = "no viewing direction, the nodes lie on one line"
        raise InputError(fault, where=[surface.name for surface in surfaces])
    normal = vectors[:, 0]
    return _straight(normal if _is_upward(normal) else -normal)


def _is_upward(unit: NDArray[np.float64]) -> bool:
    """Tell the side of +z; of +y and then of +x at right angles to that."""
    return bool(next(value for value in unit[::-1].tolist() if abs(value) > 1e-9) > 0.0)


def _wound_together(meshes: list[Samples]) -> list[Samples]:
    """Turn over the lower one of two sheets that wind against each other.

    Which of them tells the outer side nobody knows: it is taken to be the upper one.
    """
    if len(meshes) < 2 or min(mesh.openness for mesh in meshes) < _SHEET:
        return meshes
    sums = [weighed_sum(mesh.areas, mesh.normals) for mesh in meshes]
    one, other = (total / length(total) for total in sums)
    if dot(one, other) > -_SHEET:
        return meshes
    lower = 1 if _is_upward(one) else 0
    meshes[lower] = replace(meshes[lower], normals=-meshes[lower].normals)
    return meshes


def _straight(direction: NDArray[np.float64]) -> NDArray[np.float64]:
    found = np.where(np.abs(direction) < _NOTHING, 0.0, direction)
    return np.asarray(found / length(found))


def _order_moment(meshes: list[Samples]) -> NDArray[np.float64]:
    """Give a vector that turns with the mesh, even with one that is its own mirror image."""
    moment = np.zeros(3)
    for mesh in meshes:
        early = np.linspace(1.0, -1.0, len(mesh.areas))
        moment += weighed_sum(early * mesh.areas, mesh.normals)
    return moment


def _own_axes(meshes: list[Samples]) -> NDArray[np.float64]:
    """Give the principal axes as rows, right-handed, the last one the plane's normal."""
    spread = np.zeros((3, 3))
    for mesh in meshes:
        own = moments(mesh.places, mesh.areas)
        spread += own / np.trace(own)
    axes = eigen(spread)[1].T[::-1].copy()
    moment = _order_moment(meshes)
    for k in (1, 2):
        if dot(axes[k], moment) < 0.0:
            axes[k] = -axes[k]
    axes[0] = np.cross(axes[1], axes[2])
    return np.asarray(axes)


def _best_view(meshes: list[Samples]) -> NDArray[np.float64]:
    closed = bool(np.mean([m.openness for m in meshes]) < _CLOSED)
    hulls = [np.zeros((0, 3)) if closed else m.hull() for m in meshes]

    def value(meshes: list[Samples], direction: NDArray[np.float64]) -> float:
        total = 0.0
        for mesh, hull in zip(meshes, hulls, strict=True):
            area, shadow = seen(mesh, direction, whole=not closed)
            outline = 0.5 * float(np.abs(dots(hull, direction)).sum())
            filled = shadow / outline if outline > 0.0 else 1.0
            if closed:
                total += area + _RANK_CLOSED * shadow
            else:
                total += area + _RANK * (_FILLED * filled + shadow)
        return total

    rough = partial(value, [m.thinned(len(m.areas) // _FIRST_LOOK) for m in meshes])
    whole = partial(value, meshes)
    first = _views_all_round(meshes)
    values = np.array([rough(d) for d in first])
    # where two sheets mirror each other, their views tie: the first triangles then decide
    moment = _order_moment(meshes)
    order = np.lexsort((-dots(first, moment), -values.round(_ALIKE)))
    starts = [*first[order[:_STARTS]], -first[order[0]]]
    ends = []
    for start in starts:
        reached = rough(start)
        for step in _STEPS:
            start, reached = _climb(rough, start, reached, step)
        ends.append((start, whole(start)))
    decimals = _ALIKE_CLOSED if closed else _ALIKE
    best, reached = max(ends, key=lambda end: (round(end[1], decimals), dot(end[0], moment)))
    for k, step in enumerate(_LAST_STEPS):
        best, reached = _climb(whole, best, reached, step, between=k % 2 == 1)
    return np.asarray(best)


def _corners(one: tuple[float, float], other: tuple[float, float]) -> NDArray[np.float64]:
    """Give (2, 8): two vectors of the plane after none, one, two and three quarter turns."""
    found = [np.array(one), np.array(other)]
    for _ in range(6):
        x, y = found[-2]
        found.append(np.array([-y, x]))
    return np.array(found).T


_HALF = math.sqrt(0.5)
_QUARTER = math.sqrt(0.5 + _HALF / 2.0), math.sqrt(0.5 - _HALF / 2.0)
"""Cosine and sine of 22.5 degrees."""
_AROUND = _corners((1.0, 0.0), (_HALF, _HALF))
_BETWEEN = _corners(_QUARTER, (_QUARTER[1], _QUARTER[0]))


def _views_all_round(meshes: list[Samples]) -> NDArray[np.float64]:
    steps = range(-_LATTICE, _LATTICE + 1)
    views = np.array(
        [p for p in product(steps, repeat=3) if max(map(abs, p)) == _LATTICE], np.float64
    )
    normal = np.sum([weighed_sum(m.areas, m.normals) for m in meshes], axis=0)
    if normal.any():
        views = np.vstack((views, normal))
    return np.asarray(views / lengths(views)[:, None])


def _climb(
    value: Callable[[NDArray[np.float64]], float],
    direction: NDArray[np.float64],
    reached: float,
    step: float,
    *,
    between: bool = False,
) -> tuple[NDArray[np.float64], float]:
    """Go to the best of eight neighbours a step away, as long as that is better."""
    while True:
        ring = _ring(direction, step, between=between)
        values = [value(d) for d in ring]
        top = int(np.argmax(np.round(values, _ALIKE)))
        if not values[top] > reached + 10.0**-_ALIKE:
            return direction, reached
        direction, reached = np.asarray(ring[top]), values[top]


def _ring(direction: NDArray[np.float64], step: float, *, between: bool) -> NDArray[np.float64]:
    """Give eight unit vectors around one, all by the same small angle (in degrees) from it.

    Turned by half a quarter's quarter where they are to lie `between`. Without a library's sine.
    """
    half = step * (math.pi / 360.0)  # for its tangent
    cosine = (1.0 - half * half) / (1.0 + half * half)
    sine = 2.0 * half / (1.0 + half * half)
    across = frame(direction)[:2, :3]
    u, v = (_BETWEEN if between else _AROUND) * sine
    return np.asarray(cosine * direction + u[:, None] * across[0] + v[:, None] * across[1])
