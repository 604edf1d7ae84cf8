"""Area of a triangle, the same whichever way its nodes are numbered or turned."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel


@kernel
def triangle_area(ax: float, ay: float, bx: float, by: float, cx: float, cy: float) -> float:
    """Area of a counter-clockwise triangle, measured from its leftmost node.

    Parameters
    ----------
    ax, ay, bx, by, cx, cy : float
        Nodes, counter-clockwise; any of them first.

    Returns
    -------
    float
        Negative for a clockwise triangle; may be 0 or less for one thinner than rounding.
    """
    # Where two nodes share the lowest x, either gives the same bits.
    if bx < ax:
        if cx < bx:
            ax, ay, bx, by, cx, cy = cx, cy, ax, ay, bx, by
        else:
            ax, ay, bx, by, cx, cy = bx, by, cx, cy, ax, ay
    elif cx < ax:
        ax, ay, bx, by, cx, cy = cx, cy, ax, ay, bx, by
    return 0.5 * ((bx - ax) * (cy - ay) - (cx - ax) * (by - ay))


@kernel
def _triangle_areas(
    nodes: NDArray[np.float64], triangles: NDArray[np.int32], areas: NDArray[np.float64]
) -> None:
    for t in range(len(triangles)):
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        areas[t] = triangle_area(
            nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1], nodes[c, 0], nodes[c, 1]
        )


def triangle_areas(nodes: NDArray[np.float64], triangles: NDArray[np.int32]) -> NDArray[np.float64]:
    """Areas of triangles in the plane.

    Parameters
    ----------
    nodes : (N, 2) float64
    triangles : (M, 3) int32
        Counter-clockwise.

    Returns
    -------
    (M,) float64
        Negative for clockwise triangles; 0 or less also where the area rounds to nothing.
    """
    areas = np.empty(len(triangles))
    _triangle_areas(nodes, triangles, areas)
    return areas
