"""Missing values of a surface at the other grid's nodes (the paper's stage 4)."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import kernel
from surfcmp_core.triangulation import Triangulation


@kernel
def _in_triangle(
    nodes: NDArray[np.float64],
    z: NDArray[np.float64],
    a: int,
    b: int,
    c: int,
    px: float,
    py: float,
) -> float:
    ax, ay = nodes[a, 0] - px, nodes[a, 1] - py
    bx, by = nodes[b, 0] - px, nodes[b, 1] - py
    cx, cy = nodes[c, 0] - px, nodes[c, 1] - py
    at_a = max(bx * cy - by * cx, 0.0)
    at_b = max(cx * ay - cy * ax, 0.0)
    at_c = max(ax * by - ay * bx, 0.0)
    total = at_a + at_b + at_c
    if total == 0.0:  # p on a sliver whose area rounds to nothing
        return float(z[a] + z[b] + z[c]) / 3.0
    # relative to the heaviest node, so that a constant stays that constant
    if at_a >= at_b and at_a >= at_c:
        return float(z[a] + (at_b * (z[b] - z[a]) + at_c * (z[c] - z[a])) / total)
    if at_b >= at_c:
        return float(z[b] + (at_a * (z[a] - z[b]) + at_c * (z[c] - z[b])) / total)
    return float(z[c] + (at_a * (z[a] - z[c]) + at_b * (z[b] - z[c])) / total)


@kernel
def _on_hull(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    z: NDArray[np.float64],
    ghost: int,
    px: float,
    py: float,
) -> float:
    """Return the value at the place of the hull nearest to p, outside of ghost's edge."""
    h = 3 * ghost
    came = 0
    while True:
        a, b = start[h], start[h + 1]
        dx, dy = nodes[b, 0] - nodes[a, 0], nodes[b, 1] - nodes[a, 1]
        along = ((px - nodes[a, 0]) * dx + (py - nodes[a, 1]) * dy) / (dx * dx + dy * dy)
        if along < 0.0:
            if came > 0:
                return float(z[a])
            came = -1
            h = twin[h + 2] - 1
        elif along > 1.0:
            if came < 0:
                return float(z[b])
            came = 1
            h = twin[h + 1] - 2
        else:
            return float(z[a] + along * (z[b] - z[a]))


@kernel
def _interpolate(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    z: NDArray[np.float64],
    queries: NDArray[np.float64],
    found: NDArray[np.int32],
    continued: bool,
    values: NDArray[np.float64],
) -> None:
    for k in range(queries.shape[0]):
        h = 3 * found[k]
        px, py = queries[k, 0], queries[k, 1]
        if start[h + 2] >= 0:
            values[k] = _in_triangle(nodes, z, start[h], start[h + 1], start[h + 2], px, py)
        elif continued:
            values[k] = _on_hull(nodes, start, twin, z, found[k], px, py)
        else:
            values[k] = np.nan


def interpolate(
    source: Triangulation,
    z: NDArray[np.float64],
    queries: NDArray[np.float64],
    found: NDArray[np.int32],
    *,
    continued: bool = False,
) -> NDArray[np.float64]:
    """Fill the values of a surface at the nodes of the other grid.

    Parameters
    ----------
    source : Triangulation
        n nodes.
    z : (n,) float64
        Values at its nodes.
    queries : (k, 2) float64
        Places.
    found : (k,) int32
        Where localisation found them in `source`.
    continued : bool
        Outside the hull: continue by the value at the nearest place of the hull; else NaN.

    Returns
    -------
    (k,) float64
        F̂, linear on each triangle.

    References
    ----------
    Stage 4 of the paper's section 3.2.
    """
    values = np.empty(len(queries))
    _interpolate(source.nodes, source.start, source.twin, z, queries, found, continued, values)
    return values
