"""Alignment by pairs of landmarks, in closed form."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from surfcmp_core.alignment.alignment import Alignment
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
    Kabsch 1976; Umeyama, Least-squares estimation of transformation parameters between two point
    patterns, 1991 (without scale).
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
        spread = np.linalg.svd(q, compute_uv=False)
        if not spread[1] > _THIN * spread[0]:
            raise InputError(f"landmarks of surface {number} lie near one line")

    u, _, vt = np.linalg.svd(q1.T @ q2)
    handed = 1.0 if np.linalg.det(u @ vt) > 0.0 else -1.0
    rotation = (u * [1.0, 1.0, handed]) @ vt
    residual = _rms(q1 - q2 @ rotation.T)
    rounding = 1e-9 * _rms(q1)
    if handed < 0.0 and residual > rounding and _rms(q1 - q2 @ (u @ vt).T) < _MIRRORED * residual:
        raise InputError("landmarks of surface 2 are a mirror image of those of surface 1")
    matrix = np.eye(4)
    matrix[:3, :3] = rotation
    matrix[:3, 3] = centre_1 - rotation @ centre_2
    return Alignment(matrix, "landmarks", residual, len(p1), 1.0, 0, True)


def _rms(vectors: NDArray[np.float64]) -> float:
    return float(np.sqrt((vectors**2).sum(axis=1).mean()))
