"""The Delaunay triangulation of one grid."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True, eq=False)
class Triangulation:
    """The Delaunay triangulation of a grid under the perturbed predicate (paper: T1 or T2).

    Attributes
    ----------
    nodes : (n, 2) float64
        The grid's nodes.
    start : (3 (m + h),) int32
        Half-edges, three a triangle, half-edge ``3 t + i``: the node it starts from;
        the first m triangles are real and counter-clockwise, the last h are ghosts, one for
        each hull edge, whose third node is -1.
    twin : (3 (m + h),) int32
        The half-edge of the neighbouring triangle along the same edge; never -1.
    real : int
        m, the number of real triangles.
    """

    nodes: NDArray[np.float64]
    start: NDArray[np.int32]
    twin: NDArray[np.int32]
    real: int

    @property
    def triangles(self) -> NDArray[np.int32]:
        """(m, 3) int32, counter-clockwise."""
        return self.start[: 3 * self.real].reshape(-1, 3)
