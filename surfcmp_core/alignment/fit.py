"""The motion that moves surface 2 onto surface 1, and how well it does."""

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

Method = Literal["landmarks", "icp", "icp overlap", "icp region"]
FitRecord = dict[str, Any]
"""Of an alignment: what stands under "alignment" in the .json result."""


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
    pairs : int
        Pairs there were, of which the inliers are those near enough to count.
    residual_all : float
        Root mean square over all of them, in the input's unit: of the region, where there is one.
    overlaps : (float, float)
        Share of the nodes of surface 1 that have a partner on surface 2, and of 2 on 1.
    agreement : float
        How alike partners are directed: 1 the same, 0 no more than nodes paired by chance. For
        landmarks, which have no direction, 1.
    turned, shifted : float
        How far surface 2 was moved from where it started: degrees, and the way of its middle.
    free : tuple of str
        Motions that the form of the surfaces does not hold, such as "turn about x".
    landmarks : tuple of float
        Distance of each pair of landmarks after the motion, in their order.
    doubts : tuple of str
        Why the pose may be wrong, in words; none where nothing speaks against it.
    """

    matrix: NDArray[np.float64]
    method: Method
    residual: float
    inliers: int
    overlap: float
    iterations: int
    converged: bool
    pairs: int
    residual_all: float
    overlaps: tuple[float, float]
    agreement: float
    turned: float
    shifted: float
    free: tuple[str, ...] = ()
    landmarks: tuple[float, ...] = ()
    doubts: tuple[str, ...] = ()

    def record(self) -> FitRecord:
        """Return the account as it stands in every result, under the keys of the .json result."""
        return {
            "method": self.method,
            "matrix": self.matrix.tolist(),
            "landmarks": [
                {"name": str(number), "residual": residual, "held_out": False}
                for number, residual in enumerate(self.landmarks, 1)
            ],
            "pairs_kept": self.inliers,
            "pairs": self.pairs,
            "rms_kept": self.residual,
            "rms_region": self.residual_all,
            "overlap": self.overlap,
            "overlap_1": self.overlaps[0],
            "overlap_2": self.overlaps[1],
            "agreement": self.agreement,
            "turned": self.turned,
            "shifted": self.shifted,
            "free": list(self.free),
            "rounds": self.iterations,
            "converged": self.converged,
            "doubts": list(self.doubts),
        }


def record_of_motion(method: str, matrix: NDArray[np.float64]) -> FitRecord:
    """Return the record of a motion of which nothing else is known, under the same keys."""
    bare = Alignment(matrix, "landmarks", 0.0, 0, 0.0, 0, True, 0, 0.0, (0.0, 0.0), 0.0, 0.0, 0.0)
    known = {"method": method, "matrix": matrix.tolist(), "landmarks": [], "free": [], "doubts": []}
    return {**dict.fromkeys(bare.record()), **known}


FIT_KEYS = frozenset(record_of_motion("none", np.eye(4))) - {"method", "matrix"}
"""What a fit says of itself."""
