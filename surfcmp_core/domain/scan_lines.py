"""Clouds of scan lines: how much farther apart the lines lie than the nodes on them."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import following, leaving_edges, preceding

_FEW = 0.25
_LINES = 2.0
"""Where at most so few nodes have a neighbour across nearer than this many times the nearest one,
they lie on lines. Of nodes strewn at random half have, on steep walls seen from above a third."""
_FARTHEST = 12.0
"""Lines this many times as far apart as the nodes on them are no surface any more."""


@kernel
def _across(
    triangulation: Triangulation,
    leaving: NDArray[np.int32],
    nearest: NDArray[np.float64],
    across: NDArray[np.float64],
) -> None:
    """Measure the way to the nearest neighbour, and to the nearest at 45° or more to that way."""
    nodes, start, twin, _ = triangulation
    for v in range(leaving.size):
        begin = leaving[v]
        least = np.inf
        h = begin
        while True:
            w = start[following(h)]
            if w >= 0:
                dx, dy = nodes[w, 0] - nodes[v, 0], nodes[w, 1] - nodes[v, 1]
                least = min(least, dx * dx + dy * dy)
            h = twin[preceding(h)]
            if h == begin:
                break
        aside = np.inf
        h = begin
        while True:
            w = start[following(h)]
            if w >= 0:
                ux, uy = nodes[w, 0] - nodes[v, 0], nodes[w, 1] - nodes[v, 1]
                if ux * ux + uy * uy == least:  # of several as near the one that finds the least
                    k = begin
                    while True:
                        o = start[following(k)]
                        if o >= 0:
                            dx, dy = nodes[o, 0] - nodes[v, 0], nodes[o, 1] - nodes[v, 1]
                            square, along = dx * dx + dy * dy, dx * ux + dy * uy
                            if 2.0 * along * along <= square * least:
                                aside = min(aside, square)
                        k = twin[preceding(k)]
                        if k == begin:
                            break
            h = twin[preceding(h)]
            if h == begin:
                break
        nearest[v] = np.sqrt(least)
        across[v] = np.sqrt(aside)


def distance_of_lines(triangulation: Triangulation, spacing: NDArray[np.float64]) -> float:
    """Tell how far apart the lines of a cloud of scan lines are.

    Parameters
    ----------
    triangulation : Triangulation
        Of the cloud, n nodes.
    spacing : (n,) float64
        Around each node, along the lines where there are any.

    Returns
    -------
    float
        In `spacing`; the same however the nodes are turned, scaled or numbered. 0 where they do
        not lie on lines, or on lines too far apart to be one surface.
    """
    t = triangulation
    nearest, across = np.empty(len(t.nodes)), np.empty(len(t.nodes))
    _across(t, leaving_edges(t.start, len(t.nodes)), nearest, across)
    inner = np.isfinite(across)
    if not inner.any() or np.quantile((across / nearest)[inner], _FEW) < _LINES:
        return 0.0
    distance = float(np.median((across / spacing)[inner]))
    return distance if distance <= _FARTHEST else 0.0
