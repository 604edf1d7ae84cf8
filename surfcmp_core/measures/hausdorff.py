"""The measure of [5] of the paper, for comparison: distances in space between the nodes."""

import numpy as np
from numpy.typing import NDArray


def hausdorff(
    points_1: NDArray[np.float64], points_2: NDArray[np.float64], threads: int = 2
) -> tuple[float, float]:
    """Largest distance from a node of one surface to the nearest node of the other.

    Parameters
    ----------
    points_1, points_2 : (n1, 3), (n2, 3) float64
        x, y, z of the nodes, at least one of each.
    threads : int
        How many may search at once.

    Returns
    -------
    from_1_to_2, from_2_to_1 : float
        Over the nodes of 1, and over the nodes of 2; same unit as the nodes.
    """
    from scipy.spatial import cKDTree

    tree_1 = cKDTree(points_1)
    tree_2 = cKDTree(points_2)
    from_1, _ = tree_2.query(points_1, workers=threads)
    from_2, _ = tree_1.query(points_2, workers=threads)
    return float(from_1.max()), float(from_2.max())
