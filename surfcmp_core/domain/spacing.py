"""How far apart the nodes of a cloud lie, here and there."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.compiled.linear_algebra import lengths
from surfcmp_core.domain.scan_lines import distance_of_lines
from surfcmp_core.triangulation import Triangulation

_STEPS = 6
"""Edges of the tree so many steps from a node tell the spacing around it: fewer are at the mercy
of chance, more reach beyond where it changes."""
_USUAL = 0.95
"""Share of the tree's edges that are no gaps."""
_GAP = 4.0
"""An edge this many times as long as such an edge leads over a gap."""
_LINES = 2.0
"""Where there are scan lines, so does one this many times as long as they are apart: between two of
them edges are shorter, though nodes do not face each other."""
_WIDEST = 10.0
"""How many times the limit of the whole cloud any local one may be: strays are no surface."""


@kernel
def _neighbours(
    tree: NDArray[np.int32], first: NDArray[np.int32], beside: NDArray[np.int32]
) -> None:
    """List each node's neighbours in the tree, from `first` of it to `first` of the next."""
    for e in range(tree.shape[0]):
        for i in range(2):
            first[tree[e, i] + 1] += 1
    for v in range(first.size - 1):
        first[v + 1] += first[v]
    place = first[:-1].copy()
    for e in range(tree.shape[0]):
        for i in range(2):
            v = tree[e, i]
            beside[place[v]] = tree[e, 1 - i]
            place[v] += 1


@kernel
def _lower_median(values: NDArray[np.float64], count: int) -> float:
    """Find the lower of the two middle ones of a few values, by counting what is below each."""
    middle = (count - 1) // 2
    for i in range(count):
        value = values[i]
        below = 0
        not_above = 0
        for j in range(count):
            below += values[j] < value
            not_above += values[j] <= value
        if below <= middle < not_above:
            return float(value)
    return np.nan


@kernel
def _medians(
    nodes: NDArray[np.float64],
    first: NDArray[np.int32],
    beside: NDArray[np.int32],
    steps: int,
    spacing: NDArray[np.float64],
) -> None:
    n = spacing.size
    reached = np.empty(n, np.int32)
    whence = np.empty(n, np.int32)
    squares = np.empty(n)
    for v in range(n):
        reached[0] = v
        whence[0] = -1
        begin, end = 0, 1
        for _ in range(steps):
            last = end
            for i in range(begin, last):
                u = reached[i]
                for k in range(first[u], first[u + 1]):
                    w = beside[k]
                    if w == whence[i]:
                        continue
                    dx = nodes[u, 0] - nodes[w, 0]
                    dy = nodes[u, 1] - nodes[w, 1]
                    squares[end - 1] = dx * dx + dy * dy
                    reached[end] = w
                    whence[end] = u
                    end += 1
            begin = last
        spacing[v] = np.sqrt(_lower_median(squares, end - 1))


def spacing_at(
    nodes: NDArray[np.float64], tree: NDArray[np.int32], steps: int = _STEPS
) -> NDArray[np.float64]:
    """Tell the spacing around each node: the median length of the tree's edges near it.

    Parameters
    ----------
    nodes : (n, 2) float64
        At least two, distinct.
    tree : (n - 1, 2) int32
        Minimum spanning tree: no node of it has more than six neighbours, so a few steps from it
        lie few edges, whatever n.
    steps : int
        How far along the tree an edge may lie.

    Returns
    -------
    (n,) float64
        The lower of the two middle lengths where their number is even.
    """
    first = np.zeros(len(nodes) + 1, np.int32)
    beside = np.empty(tree.size, np.int32)
    _neighbours(tree, first, beside)
    spacing = np.empty(len(nodes))
    _medians(nodes, first, beside, steps, spacing)
    return spacing


def limits_of_edges(triangulation: Triangulation, tree: NDArray[np.int32]) -> NDArray[np.float64]:
    """Derive how long edges may be at each node before they lead over a gap.

    Four times what 95 % of the tree's edges do not exceed, all lengths measured by the spacing
    around them; but twice the distance of scan lines where that is more; and not above ten times
    what comes out so without regard to place.

    Parameters
    ----------
    triangulation : Triangulation
        Of the cloud, n nodes.
    tree : (n - 1, 2) int32
        Their minimum spanning tree.

    Returns
    -------
    (n,) float64
        Turns with the nodes, scales with them, and does not depend on their order.
    """
    nodes = triangulation.nodes
    spacing = spacing_at(nodes, tree)
    steps = nodes[tree[:, 0]] - nodes[tree[:, 1]]
    long = lengths(steps)
    around = np.maximum(spacing[tree[:, 0]], spacing[tree[:, 1]])
    factor = _GAP * float(np.quantile(long / around, _USUAL))
    factor = max(factor, _LINES * distance_of_lines(triangulation, spacing))
    most = _WIDEST * _GAP * float(np.quantile(long, _USUAL))
    return np.asarray(np.minimum(factor * spacing, most))
