"""Cells of the plane that no gap of a surface touches: who lies there has data without asking."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.cells.bed import Bed, extent, laid_over
from surfcmp_core.compiled.kernel import kernel


class Gaps(NamedTuple):
    """Cells over a triangulation.

    Attributes
    ----------
    bed : Bed
    near : (rows, columns) bool
        Whether the box of a triangle without data touches the cell.
    """

    bed: Bed
    near: NDArray[np.bool_]


NO_GAPS = Gaps(Bed(0.0, 0.0, 0.0, 1, 1), np.zeros((1, 1), np.bool_))


@kernel
def _count_corners(
    bed: Bed,
    nodes: NDArray[np.float64],
    triangles: NDArray[np.int32],
    steps: NDArray[np.int32],
) -> None:
    """Count the box of each triangle in at its lowest cell and out beyond its highest ones."""
    for t in range(triangles.shape[0]):
        low, high, left, right = extent(bed, nodes, triangles, t)
        steps[low, left] += 1
        steps[low, right + 1] -= 1
        steps[high + 1, left] -= 1
        steps[high + 1, right + 1] += 1


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
    bed = laid_over(low, high, float(np.sqrt(len(nodes)) / max(high - low)))
    steps = np.zeros((bed.rows + 1, bed.columns + 1), np.int32)
    _count_corners(bed, nodes, triangles, steps)
    return Gaps(bed, steps.cumsum(axis=0).cumsum(axis=1)[:-1, :-1] > 0)
