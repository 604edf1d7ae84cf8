"""A human face as a height field z = F(x, y) in millimetres, z toward the viewer.

y = 0 lies between the eyes and the tip of the nose; +x is the subject's left. Lengths follow common
adult anthropometry (eyes 64 mm apart, nose 50 mm high and 35 mm wide, mouth 51 mm wide).
"""

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

Array = NDArray[np.float64]


def smooth_max(a: Array, b: Array, width: float) -> Array:
    """Larger of two heights, rounded off where they are within `width` of each other."""
    return np.maximum(a, b) + np.maximum(width - np.abs(a - b), 0) ** 2 / (4 * width)


def smooth_min(a: Array, b: Array, width: float) -> Array:
    """Smaller of two heights, rounded off where they are within `width` of each other."""
    return -smooth_max(-a, -b, width)


def step(t: Array) -> Array:
    """0 below t = 0, 1 above t = 1, smooth between."""
    t = np.clip(t, 0, 1)
    return t * t * t * (10 + t * (6 * t - 15))


def hill(x: Array, y: Array, cx: float, cy: float, rx: float, ry: float, tilt: float = 0) -> Array:
    """Gaussian of height 1, `rx` by `ry` wide, turned counter-clockwise by `tilt` degrees."""
    c, s = np.cos(np.radians(tilt)), np.sin(np.radians(tilt))
    u, v = (x - cx) * c + (y - cy) * s, (y - cy) * c - (x - cx) * s
    return np.exp(-((u / rx) ** 2) - (v / ry) ** 2)


def ellipsoid(x: Array, y: Array, centre: tuple[float, ...], radii: tuple[float, ...]) -> Array:
    """Front of an ellipsoid; outside its outline, far behind."""
    inside = 1 - ((x - centre[0]) / radii[0]) ** 2 - ((y - centre[1]) / radii[1]) ** 2
    return np.where(
        inside > 0, centre[2] + radii[2] * np.sqrt(np.maximum(inside, 0)), centre[2] + 60 * inside
    )


def spline(*knots: tuple[float, float]) -> CubicSpline:
    """Smooth curve through (position, value) knots in rising order."""
    return CubicSpline(*zip(*knots, strict=True), bc_type="natural")


MIDLINE = spline(
    (-118, 58), (-106, 76), (-96, 88), (-86, 94.5), (-76, 95.5), (-62, 94.5), (-48, 95.5), (-30, 95),
    (-12, 92.5), (5, 90.5), (20, 91), (36, 95), (54, 96), (72, 93), (90, 85), (104, 74.5), (118, 61),
)  # fmt: skip
WIDTH = spline(
    (-118, 50), (-104, 55), (-90, 61), (-75, 66), (-58, 70.5), (-35, 75), (-10, 78.5), (15, 79.5),
    (40, 79), (65, 77.5), (85, 74), (118, 62),
)  # fmt: skip
RIDGE = spline((-24, 113.0), (-19, 115.5), (-14, 114.5), (-5, 108.6), (6, 102), (16, 96), (23, 93.2),
               (30, 92), (40, 90))  # fmt: skip


def pair(x: Array, y: Array, cx: float, cy: float, rx: float, ry: float, tilt: float = 0) -> Array:
    """Two hills, one on each side, mirrored at x = 0."""
    return hill(x, y, cx, cy, rx, ry, tilt) + hill(-x, y, cx, cy, rx, ry, tilt)


def head(x: Array, y: Array) -> Array:
    """Skull and cheeks without features."""
    u2 = np.minimum((x / WIDTH(y)) ** 2, 1)
    z = MIDLINE(y) - 88 * (1 - (1 - u2) ** 0.62)
    z += 5.0 * pair(x, y, 47, -2, 17, 12, -18)  # cheek bone
    z -= 2.2 * pair(x, y, 50, -38, 16, 20, 15)  # hollow of the cheek
    z -= 3.0 * pair(x, y, 70, 42, 13, 20)  # temple
    z += 1.4 * pair(x, y, 26, 62, 22, 18)  # bosses of the forehead
    return z + 3.0 * pair(x, y, 55, -62, 14, 15, -40)  # angle of the jaw


def brows_and_sockets(x: Array, y: Array, z: Array) -> Array:
    """Brow ridge, eye sockets and eyebrows."""
    ax = np.abs(x)
    z = z + 1.6 * pair(x, y, 11, 33, 12, 7, 10) + 3.2 * pair(x, y, 38, 36, 20, 7, -6)
    z -= 7.8 * pair(x, y, 24.5, 20.5, 10.5, 9) + 6.8 * pair(x, y, 38, 18.5, 13, 9.5)
    z -= 1.2 * pair(x, y, 21, 8, 9, 5, -35)  # trough of the tear
    arch = 34.5 + 4.6 * np.sin(np.clip((ax - 12) / 42, 0, 1) * np.pi * 0.80)
    along = step((ax - 9) / 6) * step((58 - ax) / 22)
    return z + 1.3 * along * np.exp(-(((y - arch) / 3.0) ** 2))


def eyes(x: Array, y: Array, z: Array) -> Array:
    """Eyeballs, corneas and lids."""
    ax = np.abs(x)
    cx, cy, cz, r = 32.0, 17.0, 71.0, 12.0
    lids = ellipsoid(ax, y, (cx + 0.5, cy + 0.3, cz - 3), (r + 7, r + 3.5, r + 4.6))
    z = smooth_max(z, lids, 8.0)
    t = np.clip((ax - cx) / 14.6, -1, 1)  # -1 inner corner, 1 outer corner
    tilt = cy - 0.8 + 1.2 * t
    upper = tilt + 5.4 * (1 - t**2) ** 0.75 * (1 - 0.16 * t)
    lower = tilt - 4.2 * (1 - t**2) ** 0.9 * (1 + 0.20 * t)
    fade = step((1.25 - np.abs((ax - cx) / 15)) / 0.6)
    z = z - 1.3 * fade * np.exp(-(((y - upper - 3.6) / 1.4) ** 2))  # fold of the upper lid
    z = z + 0.7 * fade * np.exp(-(((y - upper - 0.6) / 1.2) ** 2))  # rims of the lids
    z = z + 0.4 * fade * np.exp(-(((y - lower + 0.8) / 1.3) ** 2))
    ball = ellipsoid(ax, y, (cx, cy, cz), (r, r, r))
    ball = smooth_max(ball, ellipsoid(ax, y, (cx, cy + 0.3, cz + 5.4), (7.8, 7.8, 7.8)), 0.5)
    gap = np.minimum(upper - y, y - lower)
    inside = step((gap + 0.3) / 1.2) * (np.abs((ax - cx) / 14.6) < 1)
    return z + inside * np.minimum(np.maximum(ball, z - 3) - z, 0)


def nose(x: Array, y: Array, z: Array) -> Array:
    """Bridge, tip, wings, nostrils and columella."""
    ax = np.abs(x)
    half = 8.5 + 6.5 * step((22 - y) / 44)
    flank = (1 + (x / half) ** 2 * 0.9) ** -2.2
    rise = np.maximum(RIDGE(y) - z_mid(y), 0) * flank * step((y + 28) / 10) * step((40 - y) / 22)
    z = z - 1.3 * hill(ax, y, 18.6, -20, 2.8, 6.0, 10)  # crease about the wing
    body = z + rise
    body = smooth_max(body, ellipsoid(x, y, (0, -18.5, 103), (10.5, 9.5, 12.6)), 7)
    body = body - 0.7 * hill(ax, y, 11.5, -12.5, 4.5, 2.6, 30)
    wing = ellipsoid(ax, y, (10.4, -20.5, 92.5), (7.4, 7.4, 13.0))
    body = smooth_max(body, wing, 5.0)
    body = smooth_max(body, ellipsoid(x, y, (0, -22.5, 97), (4.6, 7.6, 12)), 3.0)  # columella
    return body - 4.0 * pair(x, y, 6.6, -26.4, 2.6, 2.2, -25)  # nostrils


def z_mid(y: Array) -> Array:
    """Height of the bare midline."""
    return np.asarray(MIDLINE(y), dtype=np.float64)


def mouth(x: Array, y: Array, z: Array) -> Array:
    """Philtrum, lips, chin and the folds about them."""
    ax = np.abs(x)
    z = z + 3.4 * hill(x, y, 0, -48, 24, 19)  # the teeth behind
    z -= 1.1 * hill(x, y, 0, -36, 3.0, 6.5)  # philtrum
    z += 0.7 * pair(x, y, 4.8, -37, 2.4, 6.0, 4)
    t2 = np.clip((x / 26.5) ** 2, 0, 1)
    line = -50.4 - 0.9 * np.exp(-((x / 5) ** 2)) + 1.6 * t2**2
    bow = np.exp(-(((x - 5.2) / 3.6) ** 2)) + np.exp(-(((x + 5.2) / 3.6) ** 2))
    top = 7.0 * (1 - t2) ** 0.8 + 1.3 * bow + 0.3
    low = 9.6 * (1 - t2) ** 0.62 + 0.3
    up = np.clip((y - line) / top, 0, 2)
    down = np.clip((line - y) / low, 0, 2)
    ends = step((28 - ax) / 11)
    z = z + ends * 2.8 * np.where(y >= line, np.exp(-(((up - 0.46) / 0.46) ** 4)), 0)
    z = z + ends * 3.6 * np.where(y < line, np.exp(-(((down - 0.44) / 0.46) ** 4)), 0)
    z -= 1.6 * step((30 - ax) / 5) * np.exp(-(((y - line) / 1.3) ** 2))
    z -= 2.0 * pair(x, y, 27.5, -49.5, 4.0, 3.6)  # corners
    z += 0.9 * pair(x, y, 33, -50, 5, 8)
    z -= 4.0 * hill(x, y, 0, -66.5, 17, 5.5)  # fold above the chin
    z += 4.6 * hill(x, y, 0, -82, 17, 10.5)  # chin
    fold = 15 + (-18 - y) * 0.50 + 6 * step((-18 - y) / 40)
    along = step((-14 - y) / 12) * step((y + 56) / 26)
    z += along * 1.2 * np.exp(-(((ax - fold - 7) / 7) ** 2))
    return z - along * 0.8 * np.exp(-(((ax - fold) / 3.4) ** 2))


def face(x: Array, y: Array) -> Array:
    """Height of the face at rest, in mm."""
    z = head(x, y)
    z = brows_and_sockets(x, y, z)
    z = mouth(x, y, z)
    z = nose(x, y, z)
    return eyes(x, y, z)


EYEBROW_HOLE = (-45.0, 40.5, 8.5, 3.8)
"""Place and half axes of the patch of hair that the second scan lost."""

_OUTLINE = (
    (0, -106), (20, -103), (38, -92), (52, -74), (62, -48), (68, -20), (71, 8), (72, 35), (70, 60),
    (63, 80), (48, 95), (26, 102), (0, 104),
)  # fmt: skip


def outline(x: Array, y: Array, phases: Array) -> Array:
    """Distance to the border of the scan along the ray from (0, 0); positive inside.

    `phases` (k,) makes each scan's border wave differently.
    """
    right = np.array(_OUTLINE, dtype=float)
    around = np.concatenate([right, right[-2::-1] * (-1, 1)])
    angle = np.unwrap(np.arctan2(around[:, 1], around[:, 0]))
    radius = CubicSpline(angle, np.hypot(*around.T), bc_type="periodic")
    theta = np.arctan2(y, x)
    wave = sum(np.cos((3 + 2 * k) * theta + p) / (2 + k) for k, p in enumerate(phases))
    return np.asarray(radius(theta) + 2.2 * wave - np.hypot(x, y))
