"""Missing values of a surface at the other grid's nodes (the paper's stage 4)."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates import scalar_product, twice_area
from surfcmp_core.triangulation import Triangulation


@kernel
def _between(value: float, one: float, other: float) -> float:
    """Keep rounding from leading out of what lies between two values."""
    return min(max(value, min(one, other)), max(one, other))


@kernel
def _in_triangle(
    source: Triangulation, z: NDArray[np.float64], h: int, px: float, py: float
) -> float:
    """Return the value at p in the triangle of half-edge h, its first, borders included.

    Weights are the areas of p's three triangles. On a triangle so thin that its area is below the
    rounding of its coordinates plain areas would be noise, these are right but for their last bits:
    the value is a mean of the nodes' values, and a plane is met.
    """
    nodes, start, _, _ = source
    a, b, c = start[h], start[h + 1], start[h + 2]
    ax, ay, bx, by, cx, cy = (
        nodes[a, 0],
        nodes[a, 1],
        nodes[b, 0],
        nodes[b, 1],
        nodes[c, 0],
        nodes[c, 1],
    )
    at_a = twice_area(bx, by, cx, cy, px, py)
    at_b = twice_area(cx, cy, ax, ay, px, py)
    at_c = twice_area(ax, ay, bx, by, px, py)
    if at_a < at_b or at_a < at_c:  # the heaviest node first, so that a constant stays constant
        if at_b >= at_c:
            a, at_a, b, at_b = b, at_b, a, at_a
        else:
            a, at_a, c, at_c = c, at_c, a, at_a
    total = at_a + at_b + at_c
    value = z[a] + (at_b / total * (z[b] - z[a]) + at_c / total * (z[c] - z[a]))
    return _between(value, min(min(z[a], z[b]), z[c]), max(max(z[a], z[b]), z[c]))


@kernel
def _on_hull(
    source: Triangulation,
    z: NDArray[np.float64],
    ghost: int,
    px: float,
    py: float,
) -> float:
    """Return the value at the place of the hull nearest to p, outside of ghost's edge."""
    nodes, start, twin, _ = source
    h = 3 * ghost
    came = 0
    while True:
        a, b = start[h], start[h + 1]
        ax, ay, bx, by = nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1]
        from_a = scalar_product(ax, ay, bx, by, ax, ay, px, py)
        from_b = scalar_product(bx, by, ax, ay, bx, by, px, py)
        if from_a < 0.0:
            if came > 0:
                return float(z[a])
            came = -1
            h = twin[h + 2] - 1
        elif from_b < 0.0:
            if came < 0:
                return float(z[b])
            came = 1
            h = twin[h + 1] - 2
        else:
            if from_a < from_b:
                value = z[a] + from_a / (from_a + from_b) * (z[b] - z[a])
            else:
                value = z[b] + from_b / (from_a + from_b) * (z[a] - z[b])
            return _between(value, z[a], z[b])


@kernel
def _interpolate(
    source: Triangulation,
    z: NDArray[np.float64],
    queries: NDArray[np.float64],
    found: NDArray[np.int32],
    continued: bool,
    values: NDArray[np.float64],
) -> None:
    start = source.start
    for k in range(queries.shape[0]):
        h = 3 * found[k]
        px, py = queries[k, 0], queries[k, 1]
        if start[h + 2] >= 0:
            values[k] = _in_triangle(source, z, h, px, py)
        elif continued:
            values[k] = _on_hull(source, z, found[k], px, py)
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
    _interpolate(source, z, queries, found, continued, values)
    return values
