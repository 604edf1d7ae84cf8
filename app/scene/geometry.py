"""Where things are: the arrays of a comparison that no colour or switch changes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:  # the window is on the screen before the core is loaded
    from surfcmp_core.comparison import Comparison


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
    """

    points: Floats
    normals: Floats
    triangles: Ints
    edge: float


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
    t1, t2 = comparison.triangulations
    return Geometry(
        patches=(
            _patch(spaces[0] - origin, t1.triangles),
            _patch(spaces[1] - origin, t2.triangles),
            _patch(middle - origin, comparison.united.triangles),
        ),
        origin=origin,
        low=low - origin,
        high=high - origin,
    )


def middle_height(comparison: Comparison) -> NDArray[np.float64]:
    """Return (N,) heights for T: the mean of both surfaces, or the one there is."""
    united, (grid_1, grid_2) = comparison.united, comparison.grids
    z1, z2 = comparison.z1.copy(), comparison.z2.copy()
    z1[united.node_1] = grid_1.z
    z2[united.node_2] = grid_2.z
    z1 = np.where(np.isnan(z1), z2, z1)
    z2 = np.where(np.isnan(z2), z1, z2)
    return np.asarray((z1 + z2) / 2)


def _patch(points: NDArray[np.float64], triangles: Ints) -> Patch:
    return Patch(
        points=points.astype(np.float32),
        normals=node_normals(points, triangles),
        triangles=np.ascontiguousarray(triangles, dtype=np.int32),
        edge=_typical_edge(points, triangles),
    )


def node_normals(points: NDArray[np.float64], triangles: Ints) -> Floats:
    """Return (n, 3) unit normals, the area-weighted mean of the triangles around each node."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    normals = np.empty_like(points)
    for axis in range(3):
        weights = np.repeat(across[:, axis], 3)
        normals[:, axis] = np.bincount(triangles.ravel(), weights, minlength=len(points))
    length = np.linalg.norm(normals, axis=1)
    normals[length == 0] = (0.0, 0.0, 1.0)
    length[length == 0] = 1.0
    return (normals / length[:, None]).astype(np.float32)


def _typical_edge(points: NDArray[np.float64], triangles: Ints) -> float:
    sides = triangles[:, [0, 1]]
    lengths = np.hypot(*(points[sides[:, 1], :2] - points[sides[:, 0], :2]).T)
    return float(np.median(lengths)) if len(lengths) else 1.0
