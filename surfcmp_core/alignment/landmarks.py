"""Alignment by pairs of landmarks, in closed form."""

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from surfcmp_core.alignment.account import angle_of
from surfcmp_core.alignment.fit import Alignment
from surfcmp_core.compiled.linear_algebra import (
    dots,
    eigen,
    length,
    lengths,
    moments,
    rotation,
    turned,
    weighed_sum,
)
from surfcmp_core.errors import InputError

_THIN = 0.01
"""Landmarks whose second spread is below this share of the first leave the turn about it open."""
_MIRRORED = 0.5
"""A reflection that fits this much better than any motion means that sides were exchanged."""


def fit_landmarks(landmarks_1: ArrayLike, landmarks_2: ArrayLike) -> Alignment:
    """Find the rigid motion that moves landmarks of surface 2 nearest to those of surface 1.

    Parameters
    ----------
    landmarks_1, landmarks_2 : (k, 3) float64
        The same k ≥ 3 places on both surfaces, in the same order.

    Returns
    -------
    Alignment
        Least sum of squared distances.

    Raises
    ------
    InputError
        Fewer than three pairs, unequal numbers, values that are not finite, landmarks near one
        line, or landmarks that are mirror images of each other.

    References
    ----------
    [Horn1987].
    """
    p1 = np.asarray(landmarks_1, np.float64)
    p2 = np.asarray(landmarks_2, np.float64)
    for number, p in ((1, p1), (2, p2)):
        if p.ndim != 2 or p.shape[1] != 3 or not np.isfinite(p).all():
            raise InputError(f"landmarks of surface {number}: not a list of finite x, y, z")
    if len(p1) != len(p2):
        raise InputError(f"{len(p1)} landmarks on surface 1 but {len(p2)} on surface 2")
    if len(p1) < 3:
        raise InputError(f"{len(p1)} pairs of landmarks; at least 3 are needed")
    centre_1, centre_2 = p1.mean(axis=0), p2.mean(axis=0)
    q1, q2 = p1 - centre_1, p2 - centre_2
    for number, q in ((1, q1), (2, q2)):
        spread = eigen(moments(q, np.ones(len(q))))[0]
        if not spread[1] > _THIN * _THIN * spread[2]:
            raise InputError(f"landmarks of surface {number} lie near one line")

    values, vectors = eigen(_alike(q1, q2))
    turn = rotation(vectors[:, -1])
    residual = _rms(q1 - turned(q2, turn))
    rounding = 1e-9 * _rms(q1)
    mirror = -rotation(vectors[:, 0])  # the best one, as that of the landmarks turned inside out
    if (
        -values[0] > values[-1]
        and residual > rounding
        and _rms(q1 - turned(q2, mirror)) < _MIRRORED * residual
    ):
        raise InputError("landmarks of surface 2 are a mirror image of those of surface 1")
    matrix = np.eye(4)
    matrix[:3, :3] = turn
    matrix[:3, 3] = centre_1 - dots(turn, centre_2)
    return Alignment(
        matrix,
        "landmarks",
        residual,
        len(p1),
        1.0,
        0,
        True,
        pairs=len(p1),
        residual_all=residual,
        overlaps=(1.0, 1.0),
        agreement=1.0,
        turned=angle_of(turn),
        shifted=length(centre_1 - centre_2),
        landmarks=tuple(lengths(q1 - turned(q2, turn)).tolist()),
    )


def _alike(q1: NDArray[np.float64], q2: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give the (4, 4) form that tells, for a unit quaternion, how well q2 turned agrees with q1."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = [weighed_sum(axis, q1).tolist() for axis in q2.T]
    return np.array(
        [
            [xx + yy + zz, yz - zy, zx - xz, xy - yx],
            [yz - zy, xx - yy - zz, xy + yx, zx + xz],
            [zx - xz, xy + yx, yy - xx - zz, yz + zy],
            [xy - yx, zx + xz, yz + zy, zz - xx - yy],
        ]
    )


def _rms(vectors: NDArray[np.float64]) -> float:
    return math.sqrt(dots(vectors, vectors).mean())
