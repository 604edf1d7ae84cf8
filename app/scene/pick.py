"""Which triangle lies under the pointer."""

import numpy as np

from app.scene.camera import Camera
from app.scene.geometry import Patch


def triangle_at(patch: Patch, camera: Camera, relief: bool, right: float, up: float) -> int | None:
    """Return the nearest triangle of `patch` seen at a place of the picture, or None.

    Parameters
    ----------
    right, up : float
        In shares of the picture's height from its middle, as `Camera.project` gives.
    """
    points = patch.points.astype(np.float64)
    if not relief:
        points[:, 2] = 0.0
    seen = camera.project(points)
    x, y = seen[:, 0] - right, seen[:, 1] - up
    a, b, c = patch.triangles.T
    near = (np.minimum(np.minimum(x[a], x[b]), x[c]) <= 0) & (
        np.maximum(np.maximum(x[a], x[b]), x[c]) >= 0
    )
    near &= np.minimum(np.minimum(y[a], y[b]), y[c]) <= 0
    near &= np.maximum(np.maximum(y[a], y[b]), y[c]) >= 0
    found = np.flatnonzero(near)
    a, b, c = patch.triangles[found].T
    weights = np.stack(
        [x[b] * y[c] - x[c] * y[b], x[c] * y[a] - x[a] * y[c], x[a] * y[b] - x[b] * y[a]]
    )
    total = weights.sum(axis=0)
    hit = (total != 0) & ((weights * np.sign(total)) >= 0).all(axis=0)
    if not hit.any():
        return None
    depth = np.stack([seen[a, 2], seen[b, 2], seen[c, 2]])[:, hit]
    nearness = (weights[:, hit] * depth).sum(axis=0) / total[hit]
    return int(found[hit][np.argmax(nearness)])
