"""From a surface to its grid: distinct nodes in the order of a space-filling curve."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True, eq=False)
class Grid:
    """Distinct nodes of one surface (paper: G1 or G2, definition 1) with their values.

    Attributes
    ----------
    nodes : (n, 2) float64
        x, y, bit for bit the input's; no two rows equal; along a Hilbert curve.
    z : (n,) float64
        The surface's value F at each node.
    source : (n,) int64
        Row of the surface's `points` each node came from (the first of merged ones).
    faces : (m, 3) int32 or None
        The model's own triangles in node numbers, counter-clockwise in the plane, without
        those that merging or projection made flat; None for a cloud.
    merged : int
        Nodes of the surface merged into an equal one.
    name : str
        How messages call the surface.
    """

    nodes: NDArray[np.float64]
    z: NDArray[np.float64]
    source: NDArray[np.int64]
    faces: NDArray[np.int32] | None
    merged: int
    name: str
