"""One pass of Lawson flips: verifies any triangulation and makes it the unique Delaunay one."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import inlined, kernel, wide
from surfcmp_core.compiled.stack import enlarged
from surfcmp_core.predicates import LENGTHS_FILTER, in_disc, orientation
from surfcmp_core.triangulation.half_edges import following, preceding


@kernel
def is_triangulation(
    nodes: NDArray[np.float64], start: NDArray[np.int32], twin: NDArray[np.int32], real: int
) -> bool:
    """Whether real triangles cover the convex hull of all nodes once, each node a corner.

    Exact: all triangles turn counter-clockwise, the numbers satisfy Euler's formula, every node is
    used, and the border is one convex loop that goes round once.
    """
    count = nodes.shape[0]
    hull = start.size // 3 - real
    if real != 2 * count - 2 - hull:
        return False
    used = np.zeros(count, np.bool_)
    for h in range(0, 3 * real, 3):
        a, b, c = start[h], start[h + 1], start[h + 2]
        if (
            orientation(
                nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1], nodes[c, 0], nodes[c, 1]
            )
            <= 0.0
        ):
            return False
        used[a] = True
        used[b] = True
        used[c] = True
    if not used.all():
        return False
    # a convex loop that goes round once changes its lexicographic direction twice
    g = 3 * real
    steps = 0
    changes = 0
    a = start[g + 1]
    b = start[g]
    while True:
        g = twin[g + 2] - 1
        c = start[g]
        if (
            orientation(
                nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1], nodes[c, 0], nodes[c, 1]
            )
            < 0.0
        ):
            return False
        forth = nodes[b, 0] > nodes[a, 0] or (
            nodes[b, 0] == nodes[a, 0] and nodes[b, 1] > nodes[a, 1]
        )
        onward = nodes[c, 0] > nodes[b, 0] or (
            nodes[c, 0] == nodes[b, 0] and nodes[c, 1] > nodes[b, 1]
        )
        if forth != onward:
            changes += 1
        a = b
        b = c
        steps += 1
        if g == 3 * real:
            break
    return steps == hull and changes == 2


_BATCH = 1024
"""Half-edges of which those that stand for an edge are picked out at once."""


@inlined
def _is_surely_delaunay(nodes: NDArray[np.float64], a: int, b: int, c: int, d: int) -> bool:
    """Whether d is out of the circle through a, b, c by more than rounding can feign."""
    dx, dy = nodes[d, 0], nodes[d, 1]
    ax, ay = nodes[a, 0] - dx, nodes[a, 1] - dy
    bx, by = nodes[b, 0] - dx, nodes[b, 1] - dy
    cx, cy = nodes[c, 0] - dx, nodes[c, 1] - dy
    a_square, b_square, c_square = ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy
    determinant = (
        a_square * (bx * cy - cx * by)
        + b_square * (cx * ay - ax * cy)
        + c_square * (ax * by - bx * ay)
    )
    bound = LENGTHS_FILTER * (a_square * b_square + c_square * (a_square + b_square))
    return bool(determinant < -bound)


@kernel
def _flip_around(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    end: int,
    stack: NDArray[np.int32],
) -> tuple[NDArray[np.int32], int]:
    """Flip the edge on the stack and then those around it that are no longer Delaunay.

    Returns
    -------
    stack : (k,) int32
        Perhaps with more room.
    flips : int
    """
    flips = 0
    depth = 1
    while depth > 0:
        depth -= 1
        h = wide(stack[depth])
        k = wide(twin[h])
        if k >= end:
            continue
        # h: a -> b in triangle (a, b, c); its twin k: b -> a in triangle (b, a, d)
        h_next = following(h)
        h_last = preceding(h)
        k_next = following(k)
        k_last = preceding(k)
        a, b, c, d = start[h], start[h_next], start[h_last], start[k_last]
        if not in_disc(
            nodes[a, 0],
            nodes[a, 1],
            nodes[b, 0],
            nodes[b, 1],
            nodes[c, 0],
            nodes[c, 1],
            nodes[d, 0],
            nodes[d, 1],
        ):
            continue
        flips += 1
        start[h] = d
        start[k] = c
        over = twin[k_last]
        twin[h] = over
        twin[over] = h
        over = twin[h_last]
        twin[k] = over
        twin[over] = k
        twin[h_last] = k_last
        twin[k_last] = h_last
        if depth + 4 > stack.size:
            stack = enlarged(stack)
        stack[depth] = h
        stack[depth + 1] = h_next
        stack[depth + 2] = k
        stack[depth + 3] = k_next
        depth += 4
    return stack, flips


@kernel
def make_delaunay(
    nodes: NDArray[np.float64], start: NDArray[np.int32], twin: NDArray[np.int32], real: int
) -> int:
    """Flip, in place, every edge that is not Delaunay under the perturbed predicate.

    Parameters
    ----------
    nodes : (n, 2) float64
    start, twin : int32
        Half-edges of a triangulation of the nodes' convex hull.
    real : int
        Number of real triangles.

    Returns
    -------
    int
        Number of flips; 0 proves that the triangulation was the unique one.

    References
    ----------
    [Lawson1977]. Linear where all but a bounded share of the edges is Delaunay already.
    """
    flips = 0
    stack = np.empty(64, np.int32)
    queue = np.empty(_BATCH, np.int32)
    end = 3 * real
    for begin in range(0, end, _BATCH):
        count = 0
        for h in range(begin, min(begin + _BATCH, end)):  # without a branch nothing could foretell
            queue[count] = h
            count += (h < twin[h]) & (twin[h] < end)
        for place in range(count):
            h = wide(queue[place])
            k = wide(twin[h])
            if k < end and _is_surely_delaunay(
                nodes, start[h], start[following(h)], start[preceding(h)], start[preceding(k)]
            ):
                continue
            stack[0] = h
            stack, flipped = _flip_around(nodes, start, twin, end, stack)
            flips += flipped
    return flips
