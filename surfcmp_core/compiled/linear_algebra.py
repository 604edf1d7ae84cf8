"""Vectors, motions and small matrices in strict arithmetic.

BLAS and LAPACK round as the processor at hand likes (fused multiply-add, wider registers), and so
do the libraries' sines and powers: a comparison would depend on the machine. Here every product and
every sum is rounded on its own, in one order, and a square root is the one of IEEE 754: the same
numbers to the last bit everywhere.
"""

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from surfcmp_core.compiled.kernel import kernel

_SWEEPS = 60
"""Sweeps allowed to the Jacobi method, which needs five to ten."""


def dots(one: NDArray[np.float64], other: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give scalar products along the last axis.

    Parameters
    ----------
    one, other : (..., k) float64
        Broadcast against each other; k is small.

    Returns
    -------
    (...) float64
    """
    total = one[..., 0] * other[..., 0]
    for k in range(1, one.shape[-1]):
        total = total + one[..., k] * other[..., k]
    return np.asarray(total)


def lengths(vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give the lengths of (..., k) vectors."""
    return np.asarray(np.sqrt(dots(vectors, vectors)))


def length(vector: ArrayLike) -> float:
    """Give the length of one vector."""
    return math.sqrt(dot(vector, vector))


def dot(one: ArrayLike, other: ArrayLike) -> float:
    """Give the scalar product of two vectors."""
    return float(dots(np.asarray(one, np.float64), np.asarray(other, np.float64)))


def weighed_sum(weights: NDArray[np.float64], rows: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give the (d,) sum of (k, d) rows, each times its weight, (k,)."""
    return np.asarray((weights[:, None] * rows).sum(axis=0))


def turned(vectors: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give (n, 3) vectors after a (3, 3) matrix."""
    return np.stack([dots(vectors, row) for row in turn], axis=-1)


def applied(motion: NDArray[np.float64], points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give points after a motion.

    Parameters
    ----------
    motion : (4, 4) float64
        The last row is 0, 0, 0, 1.
    points : (n, 3) float64

    Returns
    -------
    (n, 3) float64
    """
    to = np.empty((len(points), 3))
    _apply(points, np.ascontiguousarray(motion, np.float64), to)
    return to


@kernel
def _apply(
    points: NDArray[np.float64], matrix: NDArray[np.float64], to: NDArray[np.float64]
) -> None:
    for i in range(points.shape[0]):
        x, y, z = points[i, 0], points[i, 1], points[i, 2]
        for k in range(3):
            to[i, k] = matrix[k, 0] * x + matrix[k, 1] * y + matrix[k, 2] * z + matrix[k, 3]


def composed(*motions: ArrayLike) -> NDArray[np.float64]:
    """Give the product of square matrices: the last one acts first."""
    whole, *others = (np.asarray(motion, np.float64) for motion in motions)
    for other in others:
        whole = dots(whole[:, None, :], other.T[None, :, :])
    return whole


def inverse(motion: ArrayLike) -> NDArray[np.float64]:
    """Give the inverse of a (4, 4) motion, be it rigid to some decimals only."""
    matrix = np.asarray(motion, np.float64)
    x, y, z = matrix[:3, :3].T
    back = np.eye(4)
    back[:3, :3] = np.cross(y, z), np.cross(z, x), np.cross(x, y)
    back[:3, :3] /= dot(x, back[0, :3])
    back[:3, 3] = -dots(back[:3, :3], matrix[:3, 3])
    return back


def rotation(quaternion: ArrayLike) -> NDArray[np.float64]:
    """Give the (3, 3) rotation of a quaternion w, x, y, z of any length but 0."""
    q = np.asarray(quaternion, np.float64)
    q = q / np.abs(q).max()
    w, x, y, z = q.tolist()
    size = w * w + x * x + y * y + z * z
    ww, xx, yy, zz = w * w, x * x, y * y, z * z
    wx, wy, wz, xy, xz, yz = w * x, w * y, w * z, x * y, x * z, y * z
    rows = [
        [ww + xx - yy - zz, 2.0 * (xy - wz), 2.0 * (xz + wy)],
        [2.0 * (xy + wz), ww - xx + yy - zz, 2.0 * (yz - wx)],
        [2.0 * (xz - wy), 2.0 * (yz + wx), ww - xx - yy + zz],
    ]
    return np.asarray(np.array(rows) / size)


def moments(rows: NDArray[np.float64], weights: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give the sum of the products of rows with themselves, each times its weight.

    Parameters
    ----------
    rows : (n, k) float64
    weights : (n,) float64

    Returns
    -------
    (k, k) float64
        Symmetric.
    """
    total = np.zeros((rows.shape[1], rows.shape[1]))
    _add_moments(np.ascontiguousarray(rows), np.ascontiguousarray(weights), total)
    return total


@kernel
def _add_moments(
    rows: NDArray[np.float64], weights: NDArray[np.float64], total: NDArray[np.float64]
) -> None:
    k = rows.shape[1]
    for n in range(rows.shape[0]):
        for i in range(k):
            share = weights[n] * rows[n, i]
            for j in range(i + 1):
                total[i, j] += share * rows[n, j]
    for i in range(k):
        for j in range(i):
            total[j, i] = total[i, j]


def eigen(symmetric: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Give eigenvalues and eigenvectors of a small symmetric matrix.

    Parameters
    ----------
    symmetric : (k, k) float64
        Finite.

    Returns
    -------
    values : (k,) float64
        From the least up.
    vectors : (k, k) float64
        A unit vector in each column, in the order of the values.

    References
    ----------
    [Jacobi1846]; [Rutishauser1966].
    """
    matrix = np.array(symmetric, np.float64)
    vectors = np.eye(len(matrix))
    _rotate_to_diagonal(matrix, vectors)
    values = matrix.diagonal()
    order = np.argsort(values, kind="stable")
    return values[order], vectors[:, order]


@kernel
def _rotate_to_diagonal(a: NDArray[np.float64], vectors: NDArray[np.float64]) -> None:
    """Turn one pair of axes after the other until nothing stands beside the diagonal."""
    k = a.shape[0]
    for _ in range(_SWEEPS):
        done = True
        for p in range(k):
            for q in range(p + 1, k):
                beside = a[p, q]
                # as small as not to change the diagonal: not there
                if beside == 0.0 or (
                    abs(a[p, p]) + abs(beside) == abs(a[p, p])
                    and abs(a[q, q]) + abs(beside) == abs(a[q, q])
                ):
                    a[p, q] = 0.0
                    a[q, p] = 0.0
                    continue
                done = False
                ratio = 0.5 * (a[q, q] - a[p, p]) / beside
                tangent = 1.0 / (abs(ratio) + np.sqrt(ratio * ratio + 1.0))
                if ratio < 0.0:
                    tangent = -tangent
                cosine = 1.0 / np.sqrt(tangent * tangent + 1.0)
                sine = tangent * cosine
                a[p, p] -= tangent * beside
                a[q, q] += tangent * beside
                a[p, q] = 0.0
                a[q, p] = 0.0
                for i in range(k):
                    if i not in (p, q):
                        one, other = a[i, p], a[i, q]
                        a[i, p] = cosine * one - sine * other
                        a[i, q] = sine * one + cosine * other
                        a[p, i] = a[i, p]
                        a[q, i] = a[i, q]
                    one, other = vectors[i, p], vectors[i, q]
                    vectors[i, p] = cosine * one - sine * other
                    vectors[i, q] = sine * one + cosine * other
        if done:
            return


def least_solution(
    symmetric: NDArray[np.float64], right: NDArray[np.float64], nothing: float
) -> NDArray[np.float64]:
    """Solve a symmetric system; where it leaves a choice, take the shortest solution.

    Parameters
    ----------
    symmetric : (k, k) float64
    right : (k,) float64
    nothing : float
        Eigenvalues up to this share of the largest count as zero.

    Returns
    -------
    (k,) float64
    """
    values, vectors = eigen(symmetric)
    some = np.abs(values) > nothing * np.abs(values).max(initial=0.0)
    solution = np.zeros(len(values))
    for value, vector in zip(values[some], vectors.T[some], strict=True):
        solution += vector * (dot(vector, right) / value)
    return solution
