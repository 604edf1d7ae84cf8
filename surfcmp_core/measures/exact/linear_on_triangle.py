"""Values of a function that is linear on a triangle, stable however thin the triangle is."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel

FRAME = 14
"""Numbers that stand for a linear function on a triangle."""


@kernel
def set_frame(
    ax: float,
    ay: float,
    az: float,
    bx: float,
    by: float,
    bz: float,
    cx: float,
    cy: float,
    cz: float,
    frames: NDArray[np.float64],
    which: int,
) -> None:
    """Describe the function with these values at the nodes of a counter-clockwise triangle.

    Parameters
    ----------
    ax, ay, az, bx, by, bz, cx, cy, cz : float
        Nodes and values.
    frames : (k, FRAME) float64
        Its row `which` is filled in, but for the box: the last four numbers are the smallest and
        largest x and y of the part of the triangle that is to be asked about.
    """
    ab = (bx - ax) * (bx - ax) + (by - ay) * (by - ay)
    bc = (cx - bx) * (cx - bx) + (cy - by) * (cy - by)
    ca = (ax - cx) * (ax - cx) + (ay - cy) * (ay - cy)
    longest = ab
    if bc > ab and bc >= ca:  # bring the longest edge to ab
        ax, ay, az, bx, by, bz, cx, cy, cz = bx, by, bz, cx, cy, cz, ax, ay, az
        longest = bc
    elif ca > ab:
        ax, ay, az, bx, by, bz, cx, cy, cz = cx, cy, cz, ax, ay, az, bx, by, bz
        longest = ca
    ux, uy, vx, vy = bx - ax, by - ay, cx - ax, cy - ay
    frames[which, 0] = ax
    frames[which, 1] = ay
    frames[which, 2] = ux
    frames[which, 3] = uy
    frames[which, 4] = 1.0 / longest
    twice = ux * vy - uy * vx
    frames[which, 5] = 1.0 / twice if twice > 0.0 else 0.0
    frames[which, 6] = min(max((ux * vx + uy * vy) / longest, 0.0), 1.0)
    frames[which, 7] = az
    frames[which, 8] = bz - az
    frames[which, 9] = cz - az


@kernel
def value_at(x: float, y: float, frames: NDArray[np.float64], which: int) -> tuple[float, float]:
    """Value at a place on a triangle of the function that is linear on it.

    The place is held along the longest edge first, then across. So on a triangle thinner than
    rounding the value is that of a place no farther away than rounding: the weight of the third
    node is noise there, but the two others make up for it along the edge.

    Parameters
    ----------
    x, y : float
        On the triangle, or off it by rounding.
    frames : (k, FRAME) float64
        Whose row `which` is the function's.

    Returns
    -------
    base, rise : float
        Value at one node, and what is to be added: kept apart so that the difference of two
        surfaces far from 0 keeps its digits. The value lies between the nodes'.
    """
    vx, vy = x - frames[which, 0], y - frames[which, 1]
    ux, uy, foot = frames[which, 2], frames[which, 3], frames[which, 6]
    along = min(max((ux * vx + uy * vy) * frames[which, 4], 0.0), 1.0)
    third = max((ux * vy - uy * vx) * frames[which, 5], 0.0)
    if third * foot > along:
        third = along / foot
    if third * (1.0 - foot) > 1.0 - along:
        third = (1.0 - along) / (1.0 - foot)
    second = max(along - third * foot, 0.0)
    return frames[which, 7], second * frames[which, 8] + third * frames[which, 9]
