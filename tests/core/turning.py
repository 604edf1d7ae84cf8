"""Rigid motions for tests."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.surface import Surface


def turn_about(
    axis: NDArray[np.float64], degrees: float, centre: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Turn about an axis through a centre (Rodrigues)."""
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    angle = np.radians(degrees)
    matrix = np.eye(4)
    matrix[:3, :3] += np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross
    matrix[:3, 3] = centre - matrix[:3, :3] @ centre
    return matrix


def any_motion(
    rng: np.random.Generator, degrees: float, shift: float, centre: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Turn by an angle about any axis through the centre and shift by a length anywhere."""
    matrix = turn_about(rng.normal(size=3), degrees, centre)
    way = rng.normal(size=3)
    matrix[:3, 3] += shift * way / np.linalg.norm(way)
    return matrix


def left_over(
    found: NDArray[np.float64], true: NDArray[np.float64], centre: NDArray[np.float64]
) -> tuple[float, float]:
    """Degrees and distance (at the centre) by which a motion fails to undo another."""
    rest = found @ true
    cosine = (np.trace(rest[:3, :3]) - 1.0) / 2.0
    sine = np.linalg.norm(rest[:3, :3] - rest[:3, :3].T) / np.sqrt(8.0)
    shift = rest[:3, :3] @ centre + rest[:3, 3] - centre
    return float(np.degrees(np.arctan2(sine, cosine))), float(np.linalg.norm(shift))


def mirrored_back(surface: Surface, flatter: float = 0.5) -> Surface:
    """Close a sheet by its own mirror image, sewn to it at the border."""
    n = len(surface.points)
    floor = surface.points[:, 2].min() - 0.01 * np.ptp(surface.points[:, 2])
    back = surface.points.copy()
    back[:, 2] = floor - flatter * (back[:, 2] - floor)
    border = border_edges(surface.faces)
    a, b = border.T
    wall = np.concatenate((np.column_stack((b, a, a + n)), np.column_stack((b, a + n, b + n))))
    faces = np.concatenate((surface.faces, surface.faces[:, ::-1] + n, wall)).astype(np.int32)
    return replace(surface, points=np.concatenate((surface.points, back)), faces=faces)


def border_edges(faces: NDArray[np.int32]) -> NDArray[np.int64]:
    """Directed edges that no triangle has the other way."""
    edges = {(int(t[i]), int(t[(i + 1) % 3])) for t in faces for i in range(3)}
    return np.array(sorted(e for e in edges if e[::-1] not in edges), np.int64)
