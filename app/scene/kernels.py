"""Compiled loops over triangles; they trust their input and release Python's lock."""

import math

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel


@kernel
def node_normals(points: NDArray[np.float64], triangles: NDArray[np.int32]) -> NDArray[np.float32]:
    """Return (n, 3) unit normals, the area-weighted mean of the triangles around each node.

    Parameters
    ----------
    points : (n, 3) float64
    triangles : (m, 3) int32
        Counter-clockwise seen from above.
    """
    sums = np.zeros((len(points), 3))
    for t in range(len(triangles)):
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        ux, uy = points[b, 0] - points[a, 0], points[b, 1] - points[a, 1]
        vx, vy = points[c, 0] - points[a, 0], points[c, 1] - points[a, 1]
        uz, vz = points[b, 2] - points[a, 2], points[c, 2] - points[a, 2]
        x, y, z = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
        for k in range(3):
            node = triangles[t, k]
            sums[node, 0] += x
            sums[node, 1] += y
            sums[node, 2] += z
    normals = np.empty((len(points), 3), dtype=np.float32)
    for node in range(len(points)):
        x, y, z = sums[node, 0], sums[node, 1], sums[node, 2]
        length = math.sqrt(x * x + y * y + z * z)
        if length == 0.0:
            x, y, z, length = 0.0, 0.0, 1.0, 1.0
        normals[node, 0] = x / length
        normals[node, 1] = y / length
        normals[node, 2] = z / length
    return normals


@kernel
def boxes_of(
    points: NDArray[np.float32], triangles: NDArray[np.int32], run: int
) -> NDArray[np.float32]:
    """Return (k, 2, 3) the lowest and highest corner of each `run` triangles."""
    count = -(-len(triangles) // run)
    boxes = np.empty((count, 2, 3), dtype=np.float32)
    boxes[:, 0], boxes[:, 1] = np.inf, -np.inf
    for t in range(len(triangles)):
        box = boxes[t // run]
        for k in range(3):
            node = triangles[t, k]
            for axis in range(3):
                value = points[node, axis]
                box[0, axis] = min(box[0, axis], value)
                box[1, axis] = max(box[1, axis], value)
    return boxes
