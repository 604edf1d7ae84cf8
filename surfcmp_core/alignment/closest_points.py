"""Iterated closest points with distances to tangent planes."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.alignment.prepared import FEWEST, Prepared
from surfcmp_core.compiled.linear_algebra import (
    applied,
    composed,
    dot,
    dots,
    least_solution,
    length,
    moments,
    rotation,
    weighed_sum,
)
from surfcmp_core.errors import InputError

_FAR = 3.0
"""Nodes farther off than this many standard deviations (by the median) do not count, and those
near that limit count little: Tukey's biweight."""
_ROUNDS = 100
_ALONG = 0.9
"""Cosine between the steps of two rounds from which on they lead along one way."""
_LEAP = 5.0
"""So many times its length a step along the same way as the one before may be made at most."""


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """Where the iteration ended: the motion, and the fields of an `Alignment` by their names."""

    motion: NDArray[np.float64]
    residual: float
    inliers: int
    overlap: float
    iterations: int
    converged: bool
    pairs: int
    residual_all: float


def closest_points(
    fixed: Prepared,
    moving: Prepared,
    motion: NDArray[np.float64],
    beside: float | None,
    near: float,
    progress: Callable[[float], None],
) -> Found:
    """Move one surface onto another, round by round.

    Where rounds go on slowly along one way, every other one goes as far as the steps, shrinking as
    they did, would lead in the end.

    Parameters
    ----------
    fixed, moving : Prepared
    motion : (4, 4) float64
        Where to start from.
    beside : float or None
        Partners are rejected on a border, and where the node lies more than this many local
        spacings to the side: it lies beyond the border there. None: all count, however far off.
    near : float
        A round that moves no node by more than this share of the extent is the last.
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
    way_scale = np.repeat([extent / 2.0, 1.0], 3)  # turns become ways of the outer nodes
    before: NDArray[np.float64] | None = None
    still = False
    rounds = 0
    while True:
        at = applied(motion, nodes)
        partner = fixed.nearest(at)
        normal = fixed.normals[partner]
        away = at - fixed.places[partner]
        off = dots(away, normal)
        paired = trusted[partner]
        weight = np.ones(len(at))
        if beside is not None:
            aside = np.sqrt(np.maximum(dots(away, away) - off * off, 0.0))
            paired &= aside <= beside * fixed.spacing[partner]
            deviation = 1.4826 * float(np.median(np.abs(off[paired]))) if paired.any() else 0.0
            limit = max(_FAR * deviation, 1e-9 * extent)
            weight = np.square(np.maximum(1.0 - np.square(off / limit), 0.0))
        inlier = paired & (weight > 0.0)
        count = int(np.count_nonzero(inlier))
        if count < FEWEST:
            raise InputError(
                f"only {count} nodes find a partner on {fixed.name}",
                where=(moving.name,),
                hints=("bring the surfaces nearer by landmarks first",),
            )
        if still or rounds == _ROUNDS:
            return Found(
                motion,
                math.sqrt(np.square(off[inlier]).mean()),
                count,
                float(paired.mean()),
                rounds,
                still,
                int(np.count_nonzero(paired)),
                math.sqrt(np.square(off[paired]).mean()),
            )
        turn_and_shift = _step(at[inlier], normal[inlier], off[inlier], weight[inlier])
        step = _motion(turn_and_shift)
        still = float(np.abs(applied(step, at) - at).max()) <= near * extent
        leap = 1.0 if still else _leap(turn_and_shift * way_scale, before)
        before = turn_and_shift * way_scale if leap == 1.0 else None
        motion = composed(step if leap == 1.0 else _motion(leap * turn_and_shift), motion)
        rounds += 1
        progress(rounds / _ROUNDS)


def _step(
    at: NDArray[np.float64],
    normal: NDArray[np.float64],
    off: NDArray[np.float64],
    weight: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Give the small turn and shift that bring nodes nearest to their partners' planes."""
    slopes = np.column_stack((np.cross(at, normal), normal))
    # what no node resists (the turn of a sphere) stays as it is: least squares of least norm
    return -least_solution(moments(slopes, weight), weighed_sum(weight * off, slopes), 1e-12)


def _leap(way: NDArray[np.float64], before: NDArray[np.float64] | None) -> float:
    """Tell how many times its length a step may be made, after the step before."""
    if before is None:
        return 1.0
    now, last = length(way), length(before)
    if not dot(way, before) > _ALONG * now * last:
        return 1.0
    return _LEAP if now >= last else min(1.0 / (1.0 - now / last), _LEAP)


def _motion(turn_and_shift: NDArray[np.float64]) -> NDArray[np.float64]:
    step = np.eye(4)
    step[:3, :3] = rotation((1.0, *turn_and_shift[:3] / 2.0))  # Cayley's, for small turns
    step[:3, 3] = turn_and_shift[3:]
    return step
