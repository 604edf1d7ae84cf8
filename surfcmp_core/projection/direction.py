"""The viewing direction of scans that lie as they came."""

from collections.abc import Callable
from functools import partial
from itertools import product

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.projection.frame import frame
from surfcmp_core.projection.samples import Samples, samples_of
from surfcmp_core.projection.view import seen
from surfcmp_core.surface import Surface

_CLOSED = 0.25
"""Below this openness a mesh counts as closed."""
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
_STEPS = np.radians([8.0, 4.0])
_LAST_STEPS = np.radians([4.0, 2.0, 2.0, 1.0, 1.0, 0.5, 0.5, 0.25, 0.125])
"""Every other one with its neighbours between those of the step before."""
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
    (right-hand rule).

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
    axes = _own_axes(meshes)
    turned = [mesh.turned(axes) for mesh in meshes]
    found = _best_view(turned) @ axes
    return np.asarray(found / np.linalg.norm(found))


def _normal_of_clouds(surfaces: tuple[Surface, ...]) -> NDArray[np.float64]:
    spread = np.zeros((3, 3))
    for surface in surfaces:
        places = surface.points - surface.points.mean(axis=0)
        scale = np.abs(places).max(initial=0.0)
        if scale > 0.0:
            places = places / scale
            spread += places.T @ places / len(places) * scale**2
    values, vectors = np.linalg.eigh(spread)
    if not values[1] > 1e-12 * values[2]:
        names = " and ".join(s.name for s in surfaces)
        raise InputError(f"{names}: no viewing direction, the nodes lie on one line")
    normal = vectors[:, 0]
    side = next(value for value in normal[::-1].tolist() if abs(value) > 1e-9)
    return np.asarray(normal if side > 0.0 else -normal)


def _order_moment(meshes: list[Samples]) -> NDArray[np.float64]:
    """Give a vector that turns with the mesh, even with one that is its own mirror image."""
    moment = np.zeros(3)
    for mesh in meshes:
        early = np.linspace(1.0, -1.0, len(mesh.areas))
        moment += (early * mesh.areas) @ mesh.normals
    return moment


def _own_axes(meshes: list[Samples]) -> NDArray[np.float64]:
    """Give the principal axes as rows, right-handed, the last one the plane's normal."""
    spread = np.zeros((3, 3))
    for mesh in meshes:
        own = (mesh.areas[:, None] * mesh.places).T @ mesh.places
        spread += own / np.trace(own)
    axes = np.linalg.eigh(spread)[1].T[::-1].copy()
    moment = _order_moment(meshes)
    for k in (1, 2):
        if axes[k] @ moment < 0.0:
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
            outline = 0.5 * float(np.abs(hull @ direction).sum())
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
    order = np.lexsort((-first @ moment, -values.round(_ALIKE)))
    starts = [*first[order[:_STARTS]], -first[order[0]]]
    ends = []
    for start in starts:
        reached = rough(start)
        for step in _STEPS:
            start, reached = _climb(rough, start, reached, float(step))
        ends.append((start, whole(start)))
    decimals = _ALIKE_CLOSED if closed else _ALIKE
    best, reached = max(ends, key=lambda end: (round(end[1], decimals), end[0] @ moment))
    for k, step in enumerate(_LAST_STEPS):
        best, reached = _climb(whole, best, reached, float(step), between=k % 2 == 1)
    return np.asarray(best)


def _views_all_round(meshes: list[Samples]) -> NDArray[np.float64]:
    steps = range(-_LATTICE, _LATTICE + 1)
    views = np.array(
        [p for p in product(steps, repeat=3) if max(map(abs, p)) == _LATTICE], np.float64
    )
    normal = np.sum([m.areas @ m.normals for m in meshes], axis=0)
    if normal.any():
        views = np.vstack((views, normal))
    return np.asarray(views / np.linalg.norm(views, axis=1)[:, None])


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
        across = frame(direction)[:2, :3]
        angles = (np.arange(8) + between / 2.0) * (np.pi / 4.0)
        ring = np.cos(step) * direction + np.sin(step) * (
            np.column_stack((np.cos(angles), np.sin(angles))) @ across
        )
        values = [value(d) for d in ring]
        top = int(np.argmax(np.round(values, _ALIKE)))
        if not values[top] > reached + 10.0**-_ALIKE:
            return direction, reached
        direction, reached = np.asarray(ring[top]), values[top]
