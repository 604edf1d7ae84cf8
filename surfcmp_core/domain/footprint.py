"""Where one surface has data."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.domain.buckets import Buckets, buckets_of, covered_by
from surfcmp_core.kernel import kernel
from surfcmp_core.predicates import orientation
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import following, leaving_edges, preceding

DATA = np.uint8(0)
OUTSIDE = np.uint8(1)
HOLE = np.uint8(2)
_PARTIAL = np.uint8(3)
"""A triangle of the grid's triangulation that faces of the model cross: ask them."""


@dataclass(frozen=True, slots=True, eq=False)
class Footprint:
    """Where one surface has data.

    Attributes
    ----------
    triangulation : Triangulation
        T1 or T2, n nodes.
    state : (m + h,) uint8
        DATA, OUTSIDE, HOLE for each of its triangles and ghosts (or a mark for asking `faces`).
    at_node : (n,) uint8
        DATA, OUTSIDE or HOLE for each of its own nodes.
    faces : Buckets or None
        Faces of the model that are not triangles of the triangulation.
    area : float
        In the plane.
    max_edge : float
        Longest edge over which a cloud has data; inf for a mesh.
    """

    triangulation: Triangulation
    state: NDArray[np.uint8]
    at_node: NDArray[np.uint8]
    faces: Buckets | None
    area: float
    max_edge: float

    @property
    def is_hull(self) -> bool:
        """Whether there is data in all of the convex hull."""
        return not self.state[: self.triangulation.real].any()


@kernel
def _match_faces(
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    leaving: NDArray[np.int32],
    faces: NDArray[np.int32],
    state: NDArray[np.uint8],
    other: NDArray[np.bool_],
) -> None:
    """Mark triangles that are faces of the model as DATA, and faces that are no triangles."""
    for f in range(faces.shape[0]):
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        other[f] = True
        if a == b or b == c or c == a:
            continue
        begin = leaving[a]
        h = begin
        while True:
            d, e = start[following(h)], start[preceding(h)]
            if (d == b and e == c) or (d == c and e == b):
                state[h // 3] = 0
                other[f] = False
                break
            h = twin[preceding(h)]
            if h == begin:
                break


@kernel
def _flood_outside(twin: NDArray[np.int32], real: int, state: NDArray[np.uint8]) -> None:
    """Turn holes that are connected to the ghosts into OUTSIDE."""
    stack = np.empty(state.size, np.int32)
    depth = 0
    for g in range(real, state.size):
        state[g] = 1
        stack[depth] = g
        depth += 1
    while depth > 0:
        depth -= 1
        t = stack[depth]
        for h in range(3 * t, 3 * t + 3):
            u = twin[h] // 3
            if state[u] == 2:
                state[u] = 1
                stack[depth] = u
                depth += 1


@kernel
def _at_nodes(
    start: NDArray[np.int32], state: NDArray[np.uint8], at_node: NDArray[np.uint8]
) -> None:
    """Give each node the best of its triangles: DATA, else a hole, else outside."""
    at_node[:] = 1
    for h in range(start.size):
        v = start[h]
        if v >= 0:
            s = state[h // 3]
            if s == 0 or (s == 2 and at_node[v] == 1):
                at_node[v] = s


@kernel
def _longest_edges(
    nodes: NDArray[np.float64], start: NDArray[np.int32], real: int, longest: NDArray[np.float64]
) -> None:
    for t in range(real):
        longest[t] = 0.0
        for h in range(3 * t, 3 * t + 3):
            a, b = start[h], start[following(h)]
            longest[t] = max(
                longest[t], np.hypot(nodes[a, 0] - nodes[b, 0], nodes[a, 1] - nodes[b, 1])
            )


def _areas(nodes: NDArray[np.float64], faces: NDArray[np.int32]) -> NDArray[np.float64]:
    a, b, c = (nodes[faces[:, i]] for i in range(3))
    u, v = b - a, c - a
    return np.asarray(np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2.0)


def footprint_of_mesh(triangulation: Triangulation, faces: NDArray[np.int32]) -> Footprint:
    """Footprint of a mesh: what lies under its own faces.

    Parameters
    ----------
    triangulation : Triangulation
        Of the mesh's nodes.
    faces : (m, 3) int32
        The model's triangles in its numbers, turned either way.

    Returns
    -------
    Footprint
    """
    t = triangulation
    state = np.full(len(t.start) // 3, HOLE, np.uint8)
    leaving = leaving_edges(t.start, len(t.nodes))
    other = np.empty(len(faces), np.bool_)
    _match_faces(t.start, t.twin, leaving, faces, state, other)
    areas = _areas(t.nodes, faces)
    other &= areas > 0.0
    buckets = None
    if other.any():
        buckets = buckets_of(t.nodes, faces[other])
        open_ = np.flatnonzero(state[: t.real] == HOLE)
        centroids = t.nodes[t.triangles[open_]].mean(axis=1)
        state[open_[covered_by(buckets, centroids)]] = _PARTIAL
    _flood_outside(t.twin, t.real, state)
    at_node = np.empty(len(t.nodes), np.uint8)
    _at_nodes(t.start, state, at_node)
    at_node[faces.reshape(-1)] = DATA
    return Footprint(t, state, at_node, buckets, float(areas.sum()), np.inf)


def footprint_of_cloud(
    triangulation: Triangulation, tree: NDArray[np.int32], max_edge: float | None
) -> Footprint:
    """Footprint of a cloud: triangles without an edge longer than `max_edge`.

    Parameters
    ----------
    triangulation : Triangulation
        Of the cloud's nodes.
    tree : (n - 1, 2) int32
        Its minimum spanning tree, the measure of the nodes' spacing.
    max_edge : float or None
        Length; inf for no limit; None for four times the length that 95 % of the tree's edges do
        not exceed.

    Returns
    -------
    Footprint
    """
    t = triangulation
    if max_edge is None:
        steps = t.nodes[tree[:, 0]] - t.nodes[tree[:, 1]]
        max_edge = 4.0 * float(np.quantile(np.hypot(steps[:, 0], steps[:, 1]), 0.95))
    longest = np.empty(t.real)
    _longest_edges(t.nodes, t.start, t.real, longest)
    state = np.full(len(t.start) // 3, HOLE, np.uint8)
    short = longest <= max_edge
    state[: t.real][short] = DATA
    _flood_outside(t.twin, t.real, state)
    at_node = np.empty(len(t.nodes), np.uint8)
    _at_nodes(t.start, state, at_node)
    area = float(_areas(t.nodes, t.triangles[short]).sum())
    return Footprint(t, state, at_node, None, area, max_edge)


@kernel
def _states(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    state: NDArray[np.uint8],
    queries: NDArray[np.float64],
    found: NDArray[np.int32],
    states: NDArray[np.uint8],
) -> None:
    for k in range(found.size):
        t = found[k]
        states[k] = state[t]
        if state[t] == 0 or start[3 * t + 2] < 0:
            continue
        for h in range(3 * t, 3 * t + 3):  # data reaches to the border of its triangles
            if state[twin[h] // 3] == 0:
                a, b = start[h], start[following(h)]
                if (
                    orientation(
                        nodes[a, 0],
                        nodes[a, 1],
                        nodes[b, 0],
                        nodes[b, 1],
                        queries[k, 0],
                        queries[k, 1],
                    )
                    == 0.0
                ):
                    states[k] = 0


def states_at(
    footprint: Footprint, queries: NDArray[np.float64], found: NDArray[np.int32]
) -> NDArray[np.uint8]:
    """Tell where there is data.

    Parameters
    ----------
    footprint : Footprint
    queries : (k, 2) float64
        Places.
    found : (k,) int32
        Where localisation found them in the footprint's triangulation.

    Returns
    -------
    (k,) uint8
        DATA, OUTSIDE or HOLE.
    """
    t = footprint.triangulation
    states = np.empty(len(found), np.uint8)
    _states(t.nodes, t.start, t.twin, footprint.state, queries, found, states)
    if footprint.faces is not None:
        asked = np.flatnonzero(states != DATA)
        states[asked[covered_by(footprint.faces, queries[asked])]] = DATA
        states[states == _PARTIAL] = HOLE
    return states
