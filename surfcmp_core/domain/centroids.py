"""Centroids of triangles, the same to the last bit whichever node comes first."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel


@kernel
def mean_of(a: float, b: float, c: float) -> float:
    """Mean, the same to the last bit in whichever order."""
    low, high = min(min(a, b), c), max(max(a, b), c)
    middle = max(min(a, b), min(max(a, b), c))
    return (low + middle + high) / 3.0


@kernel
def _fill_centroids(
    nodes: NDArray[np.float64], triangles: NDArray[np.int32], middles: NDArray[np.float64]
) -> None:
    for t in range(triangles.shape[0]):
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        for i in range(2):
            middles[t, i] = mean_of(nodes[a, i], nodes[b, i], nodes[c, i])


def centroids(nodes: NDArray[np.float64], triangles: NDArray[np.int32]) -> NDArray[np.float64]:
    """Give the means of triangles' nodes, the same in whichever order those come."""
    middles = np.empty((len(triangles), 2))
    _fill_centroids(nodes, triangles, middles)
    return middles
