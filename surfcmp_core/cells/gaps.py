"""Cells of the plane that no gap of a surface touches: who lies there has data without asking."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel


@dataclass(frozen=True, slots=True, eq=False)
class Gaps:
    """Square cells over a triangulation.

    Attributes
    ----------
    x0, y0, per_cell : float
        Corner of the cells and cells for each unit of length.
    near : (rows, columns) bool
        Whether the box of a triangle without data touches the cell.
    """

    x0: float
    y0: float
    per_cell: float
    near: NDArray[np.bool_]


NO_GAPS = Gaps(0.0, 0.0, 0.0, np.zeros((1, 1), np.bool_))


@kernel
def _count_corners(
    nodes: NDArray[np.float64],
    triangles: NDArray[np.int32],
    x0: float,
    y0: float,
    per_cell: float,
    steps: NDArray[np.int32],
) -> None:
    """Count the box of each triangle in at its lowest cell and out beyond its highest ones."""
    for t in range(triangles.shape[0]):
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        left = int((min(nodes[a, 0], nodes[b, 0], nodes[c, 0]) - x0) * per_cell)
        right = int((max(nodes[a, 0], nodes[b, 0], nodes[c, 0]) - x0) * per_cell) + 1
        low = int((min(nodes[a, 1], nodes[b, 1], nodes[c, 1]) - y0) * per_cell)
        high = int((max(nodes[a, 1], nodes[b, 1], nodes[c, 1]) - y0) * per_cell) + 1
        steps[low, left] += 1
        steps[low, right] -= 1
        steps[high, left] -= 1
        steps[high, right] += 1


def gaps_of(nodes: NDArray[np.float64], triangles: NDArray[np.int32]) -> Gaps:
    """Mark the cells that triangles without data may touch, in linear time.

    Parameters
    ----------
    nodes : (n, 2) float64
        Not all in one place.
    triangles : (m, 3) int32
        Those without data.

    Returns
    -------
    Gaps
        About as many cells as nodes, none smaller than the nodes' mean spacing.
    """
    low, high = nodes.min(axis=0), nodes.max(axis=0)
    width, height = high - low
    per_cell = float(np.sqrt(len(nodes)) / max(width, height))
    shape = int(height * per_cell) + 1, int(width * per_cell) + 1
    steps = np.zeros((shape[0] + 1, shape[1] + 1), np.int32)
    _count_corners(nodes, triangles, float(low[0]), float(low[1]), per_cell, steps)
    near = steps.cumsum(axis=0).cumsum(axis=1)[:-1, :-1] > 0
    return Gaps(float(low[0]), float(low[1]), per_cell, near)
