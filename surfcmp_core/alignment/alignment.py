"""The motion that moves surface 2 onto surface 1, and how well it does."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Method = Literal["landmarks", "icp", "icp overlap", "icp region"]


@dataclass(frozen=True, slots=True, eq=False)
class Alignment:
    """A rigid motion and its account.

    Attributes
    ----------
    matrix : (4, 4) float64
        Moves surface 2 onto surface 1; rigid, determinant +1.
    method : str
        "landmarks"; "icp" on all nodes, "icp overlap" where both surfaces are, "icp region".
    residual : float
        Root mean square over the inliers, in the input's unit: of the distance between landmarks;
        of the distance from node to surface (the tangent plane at the nearest node) for ICP.
    inliers : int
        Pairs of landmarks or nodes that the motion was found from.
    overlap : float
        Share of the moving nodes that had a partner on the other surface, near or far from it.
    iterations : int
        Rounds of choosing partners; 0 for a closed form.
    converged : bool
        Whether the last round changed nothing that matters.
    """

    matrix: NDArray[np.float64]
    method: Method
    residual: float
    inliers: int
    overlap: float
    iterations: int
    converged: bool
