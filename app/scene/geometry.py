"""Where things are: the arrays of a comparison that no colour or switch changes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.scene.coarse import Coarse, coarse_of

if TYPE_CHECKING:  # the window is on the screen before the core is loaded
    from surfcmp_core.comparing.comparison import Comparison
    from surfcmp_core.triangulation import Triangulation


RUN = 128
"""So many triangles share a box, by which they are found."""
SAMPLE = 50_000
"""From about so many triangles the typical length of a side is told."""

Floats = NDArray[np.float32]
Ints = NDArray[np.int32]


@dataclass(frozen=True, slots=True, eq=False)
class Patch:
    """One triangulated surface, moved so that the comparison's centre is the origin.

    Attributes
    ----------
    points : (n, 3) float32
    normals : (n, 3) float32
        Of the relief, unit length, pointing up.
    triangles : (m, 3) int32
    edge : float
        Median length of an edge in the plane.
    data : (m,) bool or None
        Triangles where the surface has data; None for all.
    coarse : Coarse or None
        What is drawn in its place while the camera moves.
    boxes : (k, 2, 3) float32 or None
        Lowest and highest corner of each `RUN` triangles; neighbours in number lie close together.
    """

    points: Floats
    normals: Floats
    triangles: Ints
    edge: float
    data: NDArray[np.bool_] | None = None
    coarse: Coarse | None = None
    boxes: Floats | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Geometry:
    """The patches of T1, T2 and T, and the box they fill.

    Attributes
    ----------
    origin : (3,) float64
        The comparison's coordinates of the scene's (0, 0, 0).
    low, high : (3,) float64
        Corners of the box around everything, in the scene's coordinates.
    """

    patches: tuple[Patch, Patch, Patch]
    origin: NDArray[np.float64]
    low: NDArray[np.float64]
    high: NDArray[np.float64]


def geometry_of(comparison: Comparison) -> Geometry:
    """Return the scene's geometry; T lies half way between the surfaces."""
    spaces = [np.column_stack([grid.nodes, grid.z]) for grid in comparison.grids]
    low = np.minimum(spaces[0].min(axis=0), spaces[1].min(axis=0))
    high = np.maximum(spaces[0].max(axis=0), spaces[1].max(axis=0))
    origin = (low + high) / 2
    middle = np.column_stack([comparison.united.nodes, middle_height(comparison)])
    one, two = comparison.triangulations
    hulls = [_hull(triangulation) for triangulation in comparison.triangulations]
    united = comparison.united
    hull = np.concatenate([united.node_1[hulls[0]], united.node_2[hulls[1]]])
    return Geometry(
        patches=(
            _patch(spaces[0] - origin, one.triangles, hulls[0], data_of(comparison, 0)),
            _patch(spaces[1] - origin, two.triangles, hulls[1], data_of(comparison, 1)),
            _patch(middle - origin, united.triangles, hull, None),
        ),
        origin=origin,
        low=low - origin,
        high=high - origin,
    )


def data_of(comparison: Comparison, which: int) -> NDArray[np.bool_] | None:
    """Return (m,) where T1 (`which` = 0) or T2 has data, as far as its own triangles tell."""
    from surfcmp_core.comparing.side import triangles_with_data

    data = triangles_with_data(comparison, which)
    return None if data.all() else data


def _hull(triangulation: Triangulation) -> Ints:
    """Return the nodes on the convex hull: those of the ghosts."""
    nodes = np.unique(triangulation.start[3 * triangulation.real :])
    return np.asarray(nodes[nodes >= 0])


def middle_height(comparison: Comparison) -> NDArray[np.float64]:
    """Return (N,) heights for T: the mean of both surfaces, or the one there is."""
    united, (grid_1, grid_2) = comparison.united, comparison.grids
    z1, z2 = comparison.z1.copy(), comparison.z2.copy()
    z1[united.node_1] = grid_1.z
    z2[united.node_2] = grid_2.z
    z1 = np.where(np.isnan(z1), z2, z1)
    z2 = np.where(np.isnan(z2), z1, z2)
    return np.asarray((z1 + z2) / 2)


def _patch(
    points: NDArray[np.float64],
    triangles: Ints,
    hull: Ints,
    data: NDArray[np.bool_] | None,
) -> Patch:
    from app.scene.kernels import boxes_of, node_normals

    triangles = np.ascontiguousarray(triangles, dtype=np.int32)
    single = points.astype(np.float32)
    return Patch(
        points=single,
        normals=node_normals(points, triangles),
        triangles=triangles,
        edge=_typical_edge(points, triangles),
        data=data,
        coarse=coarse_of(points, triangles, hull),
        boxes=boxes_of(single, triangles, RUN),
    )


def _typical_edge(points: NDArray[np.float64], triangles: Ints) -> float:
    sides = triangles[:: len(triangles) // SAMPLE + 1, :2]
    lengths = np.hypot(*(points[sides[:, 1], :2] - points[sides[:, 0], :2]).T)
    return float(np.median(lengths)) if len(lengths) else 1.0
