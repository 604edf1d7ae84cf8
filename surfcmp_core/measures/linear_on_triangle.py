"""Values of a function that is linear on a triangle, stable however thin the triangle is."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import kernel

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
    frame: NDArray[np.float64],
) -> None:
    """Describe the function with these values at the nodes of a counter-clockwise triangle.

    Parameters
    ----------
    ax, ay, az, bx, by, bz, cx, cy, cz : float
        Nodes and values.
    frame : (FRAME,) float64
        Filled in.
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
    frame[0] = ax
    frame[1] = ay
    frame[2] = ux
    frame[3] = uy
    frame[4] = longest
    frame[5] = ux * vy - uy * vx
    frame[6] = min(max((ux * vx + uy * vy) / longest, 0.0), 1.0)
    frame[7] = az
    frame[8] = bz - az
    frame[9] = cz - az
    frame[10] = min(min(ax, bx), cx)
    frame[11] = max(max(ax, bx), cx)
    frame[12] = min(min(ay, by), cy)
    frame[13] = max(max(ay, by), cy)


@kernel
def moved_into(
    x: float, y: float, frame: NDArray[np.float64], other: NDArray[np.float64]
) -> tuple[float, float]:
    """Move a place that rounding put beyond the tip of a thin triangle into the boxes of both."""
    x = min(max(x, frame[10]), frame[11])
    y = min(max(y, frame[12]), frame[13])
    x = min(max(x, other[10]), other[11])
    y = min(max(y, other[12]), other[13])
    return x, y


@kernel
def value_at(x: float, y: float, frame: NDArray[np.float64]) -> tuple[float, float]:
    """Value at a place on a triangle of the function that is linear on it.

    The place is held along the longest edge first, then across. So on a triangle thinner than
    rounding the value is that of a place no farther away than rounding: the weight of the third
    node is noise there, but the two others make up for it along the edge.

    Parameters
    ----------
    x, y : float
        On the triangle, or off it by rounding.
    frame : (FRAME,) float64
        Of the function.

    Returns
    -------
    base, rise : float
        Value at one node, and what is to be added: kept apart so that the difference of two
        surfaces far from 0 keeps its digits. The value lies between the nodes'.
    """
    vx, vy = x - frame[0], y - frame[1]
    ux, uy, foot = frame[2], frame[3], frame[6]
    along = min(max((ux * vx + uy * vy) / frame[4], 0.0), 1.0)
    third = 0.0
    if frame[5] > 0.0:
        third = max((ux * vy - uy * vx) / frame[5], 0.0)
        if third * foot > along:
            third = along / foot
        if third * (1.0 - foot) > 1.0 - along:
            third = (1.0 - along) / (1.0 - foot)
    second = max(along - third * foot, 0.0)
    return frame[7], second * frame[8] + third * frame[9]
