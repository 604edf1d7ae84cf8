"""A coarse likeness of a patch, drawn while the camera moves."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

NODES = 12_000
"""About as many nodes a coarse patch has; smaller patches need none."""


@dataclass(frozen=True, slots=True, eq=False)
class Coarse:
    """A triangulation of some of a patch's nodes.

    Attributes
    ----------
    nodes : (k,) int64
        Which nodes of the patch.
    triangles : (t, 3) int32
        Numbers into `nodes`.
    source : (t,) int64
        A triangle of the patch at each coarse one, for its colour.
    """

    nodes: NDArray[np.int64]
    triangles: NDArray[np.int32]
    source: NDArray[np.int64]


def coarse_of(
    points: NDArray[np.float64], triangles: NDArray[np.int32], hull: NDArray[np.int32]
) -> Coarse | None:
    """Return a likeness of a large patch, or None where the patch is small enough.

    Nodes follow a space-filling curve, so that every k-th of them thins all places alike.

    Parameters
    ----------
    points : (n, 3) float64
    triangles : (m, 3) int32
    hull : (h,) int32
        Nodes that are kept, so that the outline stays.
    """
    if len(points) <= 4 * NODES:
        return None
    from surfcmp_core.triangulation import triangulate

    stride = len(points) // NODES
    nodes = np.union1d(np.arange(0, len(points), stride), hull).astype(np.int64)
    thin = triangulate(np.ascontiguousarray(points[nodes, :2])).triangles
    at_node = np.zeros(len(points), dtype=np.int64)
    numbers = np.arange(len(triangles))
    for corner in range(3):  # np.repeat would hold Python's lock
        at_node[triangles[:, corner]] = numbers
    return Coarse(nodes, np.ascontiguousarray(thin), at_node[nodes[thin[:, 0]]])
