"""Iterated closest points with distances to tangent planes."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.alignment.side import FEWEST, Side
from surfcmp_core.errors import InputError

_FAR = 3.0
"""Nodes farther off than this many standard deviations (by the median) do not count, and those
near that limit count little: Tukey's biweight."""
_ROUNDS = 50
_STILL = 1e-5
"""A round that moves no node by more than this share of the extent is the last."""


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """Where the iteration ended: the motion, and the fields of an `Alignment` by their names."""

    motion: NDArray[np.float64]
    residual: float
    inliers: int
    overlap: float
    iterations: int
    converged: bool


def closest_points(
    fixed: Side,
    moving: Side,
    motion: NDArray[np.float64],
    beside: float | None,
    progress: Callable[[float], None],
) -> Found:
    """Move one surface onto another, round by round.

    Parameters
    ----------
    fixed, moving : Side
    motion : (4, 4) float64
        Where to start from.
    beside : float or None
        Partners are rejected on a border, and where the node lies more than this many local
        spacings to the side: it lies beyond the border there. None: all count, however far off.
    progress : callable
        Told the share of the rounds allowed.

    Returns
    -------
    Found

    Raises
    ------
    InputError
        Too few nodes find a partner.
    """
    nodes = moving.moving
    extent = moving.extent
    trusted = fixed.may if beside is None else fixed.inner
    still = False
    rounds = 0
    while True:
        at = nodes @ motion[:3, :3].T + motion[:3, 3]
        partner = fixed.nearest(at)
        normal = fixed.normals[partner]
        away = at - fixed.places[partner]
        off = np.einsum("ij,ij->i", away, normal)
        paired = trusted[partner]
        weight = np.ones(len(at))
        if beside is not None:
            aside = np.sqrt(np.maximum((away**2).sum(axis=1) - off**2, 0.0))
            paired &= aside <= beside * fixed.spacing[partner]
            deviation = 1.4826 * float(np.median(np.abs(off[paired]))) if paired.any() else 0.0
            limit = max(_FAR * deviation, 1e-9 * extent)
            weight = np.maximum(1.0 - (off / limit) ** 2, 0.0) ** 2
        inlier = paired & (weight > 0.0)
        count = int(np.count_nonzero(inlier))
        if count < FEWEST:
            raise InputError(
                f"{moving.name}: only {count} nodes find a partner on {fixed.name}; "
                "bring the surfaces nearer by landmarks first"
            )
        if still or rounds == _ROUNDS:
            residual = float(np.sqrt((off[inlier] ** 2).mean()))
            return Found(motion, residual, count, float(paired.mean()), rounds, still)
        step = _step(at[inlier], normal[inlier], off[inlier], weight[inlier])
        still = float(np.abs(at @ step[:3, :3].T + step[:3, 3] - at).max()) <= _STILL * extent
        motion = step @ motion
        rounds += 1
        progress(rounds / _ROUNDS)


def _step(
    at: NDArray[np.float64],
    normal: NDArray[np.float64],
    off: NDArray[np.float64],
    weight: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Give the small motion that brings nodes nearest to their partners' planes."""
    slopes = np.column_stack((np.cross(at, normal), normal))
    # what no node resists (the turn of a sphere) stays as it is: least squares of least norm
    turn_and_shift = -np.linalg.pinv((slopes.T * weight) @ slopes, 1e-12, hermitian=True) @ (
        slopes.T @ (weight * off)
    )
    x, y, z = turn_and_shift[:3] / 2.0
    half = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    step = np.eye(4)
    step[:3, :3] = np.linalg.solve(np.eye(3) - half, np.eye(3) + half)  # Cayley: a rotation
    step[:3, 3] = turn_and_shift[3:]
    return step
