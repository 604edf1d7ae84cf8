"""Triangles that lie over each other in projection: which of two is behind."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.cells.bed import Bed
from surfcmp_core.cells.doubtful import Cells, crowded
from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.predicates import orientation
from surfcmp_core.projection.backs import doubt_backs
from surfcmp_core.projection.removed import Fate

_KEPT, _HIDDEN, _BACK = int(Fate.KEPT), int(Fate.HIDDEN), int(Fate.BACK_FACING)
_DIRECTIONS = 8
"""Along which triangles are told apart before anything exact is asked: every 22.5 degrees or so."""


@kernel
def _side(nodes: NDArray[np.float64], a: int, b: int, c: int) -> float:
    """Orientation of three nodes, with a short way where two are one."""
    ax, ay = nodes[a, 0], nodes[a, 1]
    bx, by = nodes[b, 0], nodes[b, 1]
    cx, cy = nodes[c, 0], nodes[c, 1]
    if (cx == ax and cy == ay) or (cx == bx and cy == by):
        return 0.0
    return orientation(ax, ay, bx, by, cx, cy)


@kernel
def _apart(
    nodes: NDArray[np.float64], faces: NDArray[np.int32], one: int, other: int, room: float
) -> bool:
    """Whether an edge of one counter-clockwise triangle has all of another on its outer side.

    All of it but a strip as wide as `room`, at the most.
    """
    d, e, f = faces[other, 0], faces[other, 1], faces[other, 2]
    for i in range(3):
        a, b, c = faces[one, i], faces[one, (i + 1) % 3], faces[one, (i + 2) % 3]
        if c in (d, e, f):
            continue  # a node on the inner side
        most = 0.0
        if room > 0.0:
            most = room * max(abs(nodes[b, 0] - nodes[a, 0]), abs(nodes[b, 1] - nodes[a, 1]))
        if (
            _side(nodes, a, b, d) <= most
            and _side(nodes, a, b, e) <= most
            and _side(nodes, a, b, f) <= most
        ):
            return True
    return False


@kernel
def _height(
    nodes: NDArray[np.float64],
    z: NDArray[np.float64],
    faces: NDArray[np.int32],
    t: int,
    x: float,
    y: float,
) -> float:
    """Height of a triangle over a place in it: exact at its nodes, within their range always."""
    for i in range(3):
        if nodes[faces[t, i], 0] == x and nodes[faces[t, i], 1] == y:
            return float(z[faces[t, i]])
    total = 0.0
    height = 0.0
    for i in range(3):
        a, b = faces[t, (i + 1) % 3], faces[t, (i + 2) % 3]
        share = (nodes[a, 0] - x) * (nodes[b, 1] - y) - (nodes[a, 1] - y) * (nodes[b, 0] - x)
        share = max(share, 0.0)
        total += share
        height += share * z[faces[t, i]]
    return height / total if total > 0.0 else z[faces[t, 0]]


@kernel
def _lead(
    nodes: NDArray[np.float64],
    z: NDArray[np.float64],
    faces: NDArray[np.int32],
    one: int,
    other: int,
) -> float:
    """Whether one of two overlapping triangles lies in front (> 0), where they differ most.

    Their overlap is the hull of the nodes of each that lie in the other and of the places where
    edges cross; heights are linear over it, so one of these shows the largest difference.
    """
    z0, z1, z2 = z[faces[one, 0]], z[faces[one, 1]], z[faces[one, 2]]
    w0, w1, w2 = z[faces[other, 0]], z[faces[other, 1]], z[faces[other, 2]]
    if min(z0, z1, z2) >= max(w0, w1, w2):
        return 1.0
    if min(w0, w1, w2) >= max(z0, z1, z2):
        return -1.0
    most = 0.0
    for turn in range(2):
        inner, outer = (one, other) if turn == 0 else (other, one)
        a, b, c = faces[outer, 0], faces[outer, 1], faces[outer, 2]
        for i in range(3):
            v = faces[inner, i]
            if (
                _side(nodes, a, b, v) >= 0.0
                and _side(nodes, b, c, v) >= 0.0
                and _side(nodes, c, a, v) >= 0.0
            ):
                lead = z[v] - _height(nodes, z, faces, outer, nodes[v, 0], nodes[v, 1])
                lead = lead if turn == 0 else -lead
                if abs(lead) > abs(most):
                    most = lead
    for i in range(3):
        a, b = faces[one, i], faces[one, (i + 1) % 3]
        for j in range(3):
            c, d = faces[other, j], faces[other, (j + 1) % 3]
            from_c, from_d = _side(nodes, a, b, c), _side(nodes, a, b, d)
            from_a, from_b = _side(nodes, c, d, a), _side(nodes, c, d, b)
            if from_c * from_d < 0.0 and from_a * from_b < 0.0:
                along = from_a / (from_a - from_b)
                across = from_c / (from_c - from_d)
                lead = (z[a] + along * (z[b] - z[a])) - (z[c] + across * (z[d] - z[c]))
                if abs(lead) > abs(most):
                    most = lead
    return most


@kernel
def _along_an_edge(faces: NDArray[np.int32], one: int, other: int) -> bool:
    """Whether two counter-clockwise triangles lie on either side of a common edge."""
    d, e, f = faces[other, 0], faces[other, 1], faces[other, 2]
    for i in range(3):
        a, b = faces[one, i], faces[one, (i + 1) % 3]
        if (a == e and b == d) or (a == f and b == e) or (a == d and b == f):
            return True
    return False


@kernel
def _reach(
    nodes: NDArray[np.float64],
    z: NDArray[np.float64],
    faces: NDArray[np.int32],
    t: int,
    i: int,
    low: NDArray[np.float64],
    high: NDArray[np.float64],
) -> None:
    """Set in row i the least and the largest value of x, y, six other directions, and z."""
    low[i] = np.inf
    high[i] = -np.inf
    for corner in range(3):
        x, y = nodes[faces[t, corner], 0], nodes[faces[t, corner], 1]
        values = (x, y, x + y, x - y, x + 2.0 * y, x - 2.0 * y, 2.0 * x + y, 2.0 * x - y)
        for k in range(_DIRECTIONS):
            low[i, k] = min(low[i, k], values[k])
            high[i, k] = max(high[i, k], values[k])
        low[i, _DIRECTIONS] = min(low[i, _DIRECTIONS], z[faces[t, corner]])
        high[i, _DIRECTIONS] = max(high[i, _DIRECTIONS], z[faces[t, corner]])


@kernel
def _hide(
    nodes: NDArray[np.float64],
    z: NDArray[np.float64],
    faces: NDArray[np.int32],
    bed: Bed,
    start: NDArray[np.int64],
    members: NDArray[np.int32],
    fate: NDArray[np.uint8],
    room: float,
    above: float,
) -> None:
    most = int(np.max(np.diff(start)))
    low = np.empty((most, _DIRECTIONS + 1))
    high = np.empty((most, _DIRECTIONS + 1))
    hides = np.empty(most, np.bool_)  # a back: it hides and is not hidden, it is left out already
    for cell in range(start.size - 1):
        first = start[cell]
        for i in range(start[cell + 1] - first):
            p = members[first + i]
            _reach(nodes, z, faces, p, i, low, high)
            hides[i] = fate[p] == _BACK
            for j in range(i):
                if hides[i] and hides[j]:
                    continue
                # rounded sums that differ stand for sums that differ; those that agree may not
                if (
                    low[j, 0] >= high[i, 0]
                    or high[j, 0] <= low[i, 0]
                    or low[j, 1] >= high[i, 1]
                    or high[j, 1] <= low[i, 1]
                ):
                    continue
                if (hides[i] and high[i, _DIRECTIONS] <= low[j, _DIRECTIONS]) or (
                    hides[j] and high[j, _DIRECTIONS] <= low[i, _DIRECTIONS]
                ):
                    continue
                apart = False
                for k in range(2, _DIRECTIONS):
                    apart = apart or low[j, k] > high[i, k] or high[j, k] < low[i, k]
                if apart:
                    continue
                q = members[first + j]
                if fate[p] != _KEPT and fate[q] != _KEPT:
                    continue
                # once a pair: in the cell of their boxes' first common place
                column = int((max(low[i, 0], low[j, 0]) - bed.x0) * bed.per_cell)
                row = int((max(low[i, 1], low[j, 1]) - bed.y0) * bed.per_cell)
                if row * bed.columns + column != cell or _along_an_edge(faces, q, p):
                    continue
                if _apart(nodes, faces, q, p, room) or _apart(nodes, faces, p, q, room):
                    continue
                lead = _lead(nodes, z, faces, q, p)
                if hides[j]:
                    if lead > above:
                        fate[p] = _HIDDEN
                elif hides[i]:
                    if lead < -above:
                        fate[q] = _HIDDEN
                elif lead >= 0.0:
                    fate[p] = _HIDDEN
                else:
                    fate[q] = _HIDDEN


def hide(
    nodes: NDArray[np.float64],
    z: NDArray[np.float64],
    faces: NDArray[np.int32],
    cells: Cells,
    fate: NDArray[np.uint8],
    backs: NDArray[np.bool_] | None,
    room: float,
    above: float,
) -> None:
    """Mark each triangle that another one lies in front of.

    Parameters
    ----------
    nodes : (n, 2) float64
        In the range of the exact predicates.
    z : (n,) float64
        Nearer to the viewer where larger.
    faces : (m, 3) int32
        Counter-clockwise those that count.
    cells : Cells
        Laid over those that count.
    fate : (m,) uint8
        KEPT ones may be set to HIDDEN. Of two alike in height, the later one.
    backs : (m,) bool, optional
        BACK_FACING ones that hide as well.
    room : float
        Overlaps no wider than this are none.
    above : float
        By more than this a back must lie in front, in the unit of z.
    """
    counts = fate == Fate.KEPT
    if backs is not None:
        counts |= doubt_backs(nodes, z, faces, fate, backs, cells)
    start, members = crowded(nodes, faces, counts, cells)
    _hide(nodes, z, faces, cells.bed, start, members, fate, room, above)
