"""The measure of [5] of the paper, for comparison: distances in space between the nodes."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import kernel

_BATCH = 4096
"""Nodes whose nearest neighbour is looked up at once."""


@kernel
def _bounds(
    points_1: NDArray[np.float64],
    points_2: NDArray[np.float64],
    triangles: NDArray[np.int32],
    found: NDArray[np.int32],
    bound: NDArray[np.float64],
) -> None:
    for i in range(found.size):
        bound[i] = np.inf
        for k in range(3):
            j = triangles[found[i], k]
            if j >= 0:
                dx = points_1[i, 0] - points_2[j, 0]
                dy = points_1[i, 1] - points_2[j, 1]
                dz = points_1[i, 2] - points_2[j, 2]
                bound[i] = min(bound[i], np.sqrt(dx * dx + dy * dy + dz * dz))


def hausdorff(
    points_1: NDArray[np.float64],
    points_2: NDArray[np.float64],
    triangles: NDArray[np.int32],
    found: NDArray[np.int32],
) -> float:
    """Largest distance from a node of surface 1 to the nearest node of surface 2.

    The corners of the triangle in which a node lies bound its distance from above. The nodes with
    the largest bounds are looked up first; those whose bound is below the largest distance found
    need none.

    Parameters
    ----------
    points_1, points_2 : (n1, 3), (n2, 3) float64
        x, y, z of the nodes, at least one of each.
    triangles : (m, 3) int32
        Triangles between nodes of 2, -1 for none.
    found : (n1,) int32
        For each node of 1 a triangle that is near it.

    Returns
    -------
    float
        In the nodes' unit.
    """
    from scipy.spatial import cKDTree

    bound = np.empty(len(points_1))
    _bounds(points_1, points_2, triangles, found, bound)
    tree = cKDTree(points_2, balanced_tree=False, compact_nodes=False)
    largest = 0.0
    while bound.size:
        batch = np.arange(bound.size)
        if bound.size > _BATCH:
            batch = np.argpartition(bound, -_BATCH)[-_BATCH:]
        distances, _ = tree.query(points_1[batch])
        largest = max(largest, float(distances.max()))
        bound[batch] = 0.0
        left = bound > largest
        bound, points_1 = bound[left], points_1[left]
    return largest
