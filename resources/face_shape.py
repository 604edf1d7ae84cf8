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


def step(t: Array) -> Array:
    """0 below t = 0, 1 above t = 1, smooth between."""
    t = np.clip(t, 0, 1)
    return t * t * t * (10 + t * (6 * t - 15))


def hill(x: Array, y: Array, cx: float, cy: float, rx: float, ry: float, tilt: float = 0) -> Array:
    """Gaussian of height 1, `rx` by `ry` wide, turned counter-clockwise by `tilt` degrees."""
    c, s = np.cos(np.radians(tilt)), np.sin(np.radians(tilt))
    u, v = (x - cx) * c + (y - cy) * s, (y - cy) * c - (x - cx) * s
    return np.asarray(np.exp(-((u / rx) ** 2) - (v / ry) ** 2))


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
    (-118, 58), (-106, 76), (-96, 88), (-86, 94.5), (-76, 95.5), (-62, 94.5), (-48, 95.5),
    (-30, 95), (-12, 92.5), (5, 90.5), (20, 91), (36, 95), (54, 96), (72, 93), (90, 85),
    (104, 74.5), (118, 61),
)  # fmt: skip
WIDTH = spline(
    (-118, 50), (-104, 55), (-90, 61), (-75, 66), (-58, 70.5), (-35, 75), (-10, 78.5), (15, 79.5),
    (40, 78.5), (65, 75), (85, 70), (118, 58),
)  # fmt: skip
RIDGE = spline(
    (-26, 110), (-20, 113), (-14, 112.3), (-5, 108), (6, 102), (16, 96), (23, 93.2), (30, 92),
    (40, 90),
)  # fmt: skip
"""Along y: height of the bare midline, half width of the head, height of the bridge of the nose."""


def pair(x: Array, y: Array, cx: float, cy: float, rx: float, ry: float, tilt: float = 0) -> Array:
    """Two hills, one on each side, mirrored at x = 0."""
    return hill(x, y, cx, cy, rx, ry, tilt) + hill(-x, y, cx, cy, rx, ry, tilt)


def head(x: Array, y: Array) -> Array:
    """Skull and cheeks without features."""
    u2 = np.minimum((x / WIDTH(y)) ** 2, 1)
    z = np.asarray(MIDLINE(y) - 88 * (1 - (1 - u2) ** 0.62))
    z += 5.0 * pair(x, y, 47, -2, 17, 12, -18)  # cheek bone
    z -= 2.2 * pair(x, y, 50, -38, 16, 20, 15)  # hollow of the cheek
    z -= 3.0 * pair(x, y, 70, 42, 13, 20)  # temple
    z += 1.4 * pair(x, y, 26, 62, 22, 18)  # bosses of the forehead
    return z + 3.0 * pair(x, y, 55, -62, 14, 15, -40)  # angle of the jaw


def brows_and_sockets(x: Array, y: Array, z: Array) -> Array:
    """Brow ridge, eye sockets and eyebrows."""
    ax = np.abs(x)
    z = z + 1.6 * pair(x, y, 11, 33, 12, 7, 10) + 3.2 * pair(x, y, 38, 36, 20, 7, -6)
    z -= 7.0 * pair(x, y, 24.5, 21, 10.5, 9) + 3.6 * pair(x, y, 38, 19, 9, 9)
    z -= 1.2 * pair(x, y, 21, 8, 9, 5, -35)  # trough of the tear
    arch = 34.5 + 4.6 * np.sin(np.clip((ax - 12) / 42, 0, 1) * np.pi * 0.80)
    along = step((ax - 9) / 6) * step((58 - ax) / 22)
    return z + 1.3 * along * np.exp(-(((y - arch) / 3.0) ** 2))


def eyes(x: Array, y: Array, z: Array) -> Array:
    """Eyeballs, corneas and lids."""
    ax = np.abs(x)
    cx, cy, cz, r = 32.0, 17.0, 71.0, 12.0
    q2 = ((ax - cx - 1) / 21) ** 2 + ((y - cy - 0.3) / 17) ** 2
    lids = 67 + 17.3 * (1 - q2) - 0.012 * np.maximum(ax - cx, 0) ** 2 - 40 * np.maximum(q2 - 1, 0)
    z = smooth_max(z, lids, 9.0)
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
    return z + inside * np.minimum(np.maximum(ball, z - 0.8 - 2.2 * (1 - t**2)) - z, 0)


def nose(x: Array, y: Array, z: Array) -> Array:
    """Bridge, tip, wings, nostrils and columella."""
    ax = np.abs(x)
    half = 8.5 + 6.5 * step((18 - y) / 40)
    flank = (1 + (x / half) ** 2 * 0.9) ** -2.2
    rise = np.maximum(RIDGE(y) - MIDLINE(y), 0) * flank * step((y + 28) / 10) * step((40 - y) / 22)
    z = z - 1.3 * hill(ax, y, 18.6, -20, 2.8, 6.0, 10)  # crease about the wing
    body = z + rise
    q2 = (x / 11.0) ** 2 + ((y + 18.2) / 9.8) ** 2
    tip = 97.5 + 17.5 * np.maximum(1 - q2, 0) ** 0.6 - 60 * np.maximum(q2 - 1, 0)
    body = smooth_max(body, tip, 7.0)
    wing = ellipsoid(ax, y, (9.0, -20.3, 89.5), (8.6, 7.6, 14.5))
    body = smooth_max(body, wing, 5.0)
    body = smooth_max(body, ellipsoid(x, y, (0, -23.0, 96), (4.4, 6.6, 11)), 4.0)  # columella
    return body - 4.0 * pair(x, y, 6.6, -26.4, 2.6, 2.2, -25)  # nostrils


def folds(x: Array, y: Array, z: Array) -> Array:
    """Philtrum, chin, the folds beside the mouth and the rounding over the teeth."""
    ax = np.abs(x)
    z = z + 3.4 * hill(x, y, 0, -48, 24, 19)  # the teeth behind
    z -= 1.1 * hill(x, y, 0, -36, 3.0, 6.5)  # philtrum
    z += 0.7 * pair(x, y, 4.8, -37, 2.4, 6.0, 4)
    z += 0.9 * pair(x, y, 33, -50, 5, 8)
    z += 4.6 * hill(x, y, 0, -82, 17, 10.5)  # chin
    fold = 15 + (-18 - y) * 0.50 + 6 * step((-18 - y) / 40)
    along = step((-14 - y) / 12) * step((y + 56) / 26)
    z += along * 1.2 * np.exp(-(((ax - fold - 7) / 7) ** 2))
    return z - along * 0.8 * np.exp(-(((ax - fold) / 3.4) ** 2))


def lips(x: Array, y: Array, z: Array, upper: Array, lower: Array, half: float) -> Array:
    """Lips that end at the curves `upper` and `lower`, `half` mm from the middle to a corner."""
    ax = np.abs(x)
    t2 = np.clip((x / half) ** 2, 0, 1)
    bow = np.exp(-(((x - 5.2) / 3.6) ** 2)) + np.exp(-(((x + 5.2) / 3.6) ** 2))
    up = np.clip((y - upper) / (7.0 * (1 - t2) ** 0.8 + 1.3 * bow + 0.3), 0, 2)
    down = np.clip((lower - y) / (9.6 * (1 - t2) ** 0.62 + 0.3), 0, 2)
    ends = step((half + 1.5 - ax) / 11)
    z = z + ends * 2.8 * np.where(y >= upper, np.exp(-(((up - 0.46) / 0.46) ** 4)), 0)
    z = z + ends * 3.6 * np.where(y < lower, np.exp(-(((down - 0.44) / 0.46) ** 4)), 0)
    edge = np.maximum(np.maximum(y - upper, lower - y), 0)
    z -= 1.6 * step((half + 3.5 - ax) / 6) * np.exp(-((edge / 1.3) ** 2))
    return z - 1.6 * pair(x, y, half + 1.3, -48.8, 4.0, 3.4)  # corners


def mouth(x: Array, y: Array, z: Array) -> Array:
    """Lips at rest, and the chin."""
    line = -50.4 - 0.9 * np.exp(-((x / 5) ** 2)) + 2.0 * np.clip(np.abs(x) / 25.5, 0, 1) ** 3
    z = folds(x, y, z) - 4.0 * hill(x, y, 0, -66.5, 17, 5.5)  # fold above the chin
    return lips(x, y, z, line, line, 25.5)


def face(x: Array, y: Array) -> Array:
    """Height of the face at rest, in mm."""
    z = head(x, y)
    z = brows_and_sockets(x, y, z)
    z = mouth(x, y, z)
    z = nose(x, y, z)
    return eyes(x, y, z)


_OUTLINE = (
    (0, -106), (20, -103), (38, -92), (52, -74), (62, -48), (68, -20), (71, 8), (71.5, 33),
    (67.5, 58), (58, 78), (43, 91.5), (23, 99), (0, 101.5),
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
