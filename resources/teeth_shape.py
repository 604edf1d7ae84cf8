"""The front teeth and gums of the head in face_shape.py, and the face that bares them, in mm."""

import numpy as np
from face_shape import (
    Array,
    brows_and_sockets,
    eyes,
    folds,
    head,
    hill,
    lips,
    nose,
    smooth_max,
    step,
)

Row = tuple[tuple[float, float, float], ...]
"""Of each tooth from the middle outwards: width, y of the gum's margin, y of the biting edge."""

UPPER: Row = (
    (8.6, -44.2, -54.6), (6.6, -45.4, -54.0), (7.2, -43.8, -54.5), (5.6, -45.4, -53.4),
    (5.0, -45.8, -52.8),
)  # fmt: skip
LOWER: Row = (
    (5.4, -63.8, -55.2), (5.8, -63.8, -55.2), (6.6, -64.8, -54.9), (5.6, -63.6, -54.6),
    (5.2, -62.8, -54.2),
)  # fmt: skip


def crowns(x: Array, y: Array, row: Row) -> Array:
    """Front of a row of teeth above its arch; far below 0 between them."""
    ax, left, z = np.abs(x), 0.0, np.full_like(x, -9.0)
    for width, margin, edge in row:
        u = (ax - left - width / 2) / (width / 2 + 0.1)
        v = (y - (margin + edge) / 2) / (abs(margin - edge) / 2 + 1.0)
        v_gum = v * np.sign(margin - edge)  # 1 at the gum, -1 at the biting edge
        u = u * (1 + 0.10 * v_gum)  # narrower at the neck
        q = np.abs(u) ** 3.2 + np.abs(v) ** 4
        crown = 2.6 * np.maximum(1 - q, 0) ** 0.45 - 9 * np.maximum(q - 1, 0) - 0.6
        z = np.maximum(z, crown + 0.5 * v_gum * (1 - v_gum))
        left += width
    return z


def gums(x: Array, y: Array, row: Row) -> Array:
    """Gum above its arch: full over the roots, fading to the dark gap beyond the biting edges."""
    ax, left, roots = np.abs(x), 0.0, np.zeros_like(x)
    side = np.sign(row[0][1] - row[0][2])
    for width, _, _ in row:
        roots = roots + np.exp(-(((ax - left - width / 2) / (0.36 * width)) ** 2))
        left += width
    beyond = (row[0][1] - y) * side  # mm from the margin toward the biting edge
    papillae = step((beyond - 2.2 + 3.2 * (roots - 0.3)) / 4.0)
    return 0.3 + 0.9 * roots * step((1 - beyond) / 5) - 4.6 * papillae


def teeth(x: Array, y: Array) -> Array:
    """Both rows with their gums; the upper front teeth bite in front of the lower."""
    upper = 95.0 - 0.0175 * x**2 - 2e-6 * x**4
    lower = 92.6 - 0.0190 * x**2 - 2e-6 * x**4
    top = upper + smooth_max(crowns(x, y, UPPER), gums(x, y, UPPER), 0.5)
    bottom = lower + smooth_max(crowns(x, y, LOWER), gums(x, y, LOWER), 0.5)
    return smooth_max(top - 6 * step((-55.5 - y) / 3), bottom, 0.3)


def lip_lines(x: Array) -> tuple[Array, Array]:
    """Edges of the lips drawn back."""
    rest = np.clip(1 - (x / 30) ** 2, 0, 1)
    return -50 + 7.5 * rest**0.5, -50 - 16.0 * rest**0.6


def face_with_teeth(x: Array, y: Array) -> Array:
    """Height of the face with its lips drawn back."""
    upper, lower = lip_lines(x)
    z = folds(x, y, brows_and_sockets(x, y, head(x, y)))
    z = z - 2.5 * hill(x, y, 0, -77, 19, 4.5)  # fold above the chin
    z = lips(x, y, z, upper, lower, 30)
    z = eyes(x, y, nose(x, y, z))
    inside = np.minimum(upper - y, y - lower)  # mm from the nearer lip
    return z + step(inside / 1.5) * np.minimum(teeth(x, y) - z, 0)
