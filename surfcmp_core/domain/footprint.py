"""Where one surface has data."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.cells.buckets import Buckets, buckets_of, covered_by
from surfcmp_core.cells.gaps import NO_GAPS, Gaps, gaps_of
from surfcmp_core.compiled.kernel import kernel, wide
from surfcmp_core.domain.centroids import centroids, mean_of
from surfcmp_core.domain.matching import match_faces
from surfcmp_core.domain.spacing import limits_of_edges
from surfcmp_core.localisation.localisation import walk_to
from surfcmp_core.predicates import orientation
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import following

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
        Longest edge over which a cloud may have data, where its nodes lie farthest apart; inf for
        a mesh.
    """

    triangulation: Triangulation
    state: NDArray[np.uint8]
    at_node: NDArray[np.uint8]
    faces: Buckets | None
    area: float
    max_edge: float

    @property
    def covered(self) -> NDArray[np.bool_]:
        """(m,) bool: triangles with data at their centroid."""
        state = self.state[: self.triangulation.real]
        return np.asarray((state == DATA) | (state == _PARTIAL))

    @property
    def is_hull(self) -> bool:
        """Whether there is data in all of the convex hull."""
        return not self.state[: self.triangulation.real].any()


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
def _keep_short(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    real: int,
    limits: NDArray[np.float64],
    state: NDArray[np.uint8],
) -> float:
    """Mark triangles as DATA, or as holes where an edge is longer than two of their nodes allow.

    Return the data's area.
    """
    area = 0.0
    for t in range(real):
        a, b, c = start[3 * t], start[3 * t + 1], start[3 * t + 2]
        ux, uy = nodes[b, 0] - nodes[a, 0], nodes[b, 1] - nodes[a, 1]
        vx, vy = nodes[c, 0] - nodes[a, 0], nodes[c, 1] - nodes[a, 1]
        wx, wy = vx - ux, vy - uy
        longest = np.sqrt(max(ux * ux + uy * uy, vx * vx + vy * vy, wx * wx + wy * wy))
        one, other = min(limits[a], limits[b]), max(limits[a], limits[b])
        if longest <= max(one, min(other, limits[c])):  # the middle one of three
            state[t] = 0
            area += 0.5 * (ux * vy - uy * vx)
        else:
            state[t] = 2
    return area


@kernel
def _areas(
    nodes: NDArray[np.float64], faces: NDArray[np.int32], areas: NDArray[np.float64]
) -> None:
    for f in range(faces.shape[0]):
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        ux, uy = nodes[b, 0] - nodes[a, 0], nodes[b, 1] - nodes[a, 1]
        vx, vy = nodes[c, 0] - nodes[a, 0], nodes[c, 1] - nodes[a, 1]
        areas[f] = abs(ux * vy - uy * vx) / 2.0


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
    whole, other = match_faces(t, faces)
    state[: t.real][whole] = DATA
    areas = np.empty(len(faces))
    _areas(t.nodes, faces, areas)
    other &= areas > 0.0
    buckets = None
    if other.any():
        buckets = buckets_of(t.nodes, faces[other])
        open_ = np.flatnonzero(state[: t.real] == HOLE)
        middles = centroids(t.nodes, t.triangles[open_])
        state[open_[covered_by(buckets, middles)]] = _PARTIAL
    _flood_outside(t.twin, t.real, state)
    at_node = np.empty(len(t.nodes), np.uint8)
    _at_nodes(t.start, state, at_node)
    at_node[faces.reshape(-1)] = DATA
    area = float(np.sort(areas).sum())  # the same in whichever order the faces come
    return Footprint(t, state, at_node, buckets, area, np.inf)


def footprint_of_cloud(
    triangulation: Triangulation, tree: NDArray[np.int32], max_edge: float | None
) -> Footprint:
    """Footprint of a cloud: triangles without an edge too long.

    Parameters
    ----------
    triangulation : Triangulation
        Of the cloud's nodes.
    tree : (n - 1, 2) int32
        Its minimum spanning tree, the measure of the nodes' spacing.
    max_edge : float or None
        Length, the same everywhere; inf for no limit; None for one that follows the spacing around
        each node (:func:`surfcmp_core.domain.spacing.limits_of_edges`), the middle one of a
        triangle's three.

    Returns
    -------
    Footprint
    """
    t = triangulation
    n = len(t.nodes)
    limits = limits_of_edges(t, tree) if max_edge is None else np.full(n, max_edge)
    state = np.empty(len(t.start) // 3, np.uint8)
    area = _keep_short(t.nodes, t.start, t.real, limits, state)
    _flood_outside(t.twin, t.real, state)
    at_node = np.empty(n, np.uint8)
    _at_nodes(t.start, state, at_node)
    return Footprint(t, state, at_node, None, area, float(limits.max()))


@kernel
def _state_at(
    triangulation: Triangulation,
    state: NDArray[np.uint8],
    triangle: int,
    px: float,
    py: float,
) -> int:
    """State at a place that was found in a triangle; data reach to the border of its triangles."""
    nodes, start, twin, _ = triangulation
    if state[triangle] != 0 and start[3 * triangle + 2] >= 0:
        for h in range(3 * triangle, 3 * triangle + 3):
            if state[twin[h] // 3] == 0:
                a, b = start[h], start[following(h)]
                if orientation(nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1], px, py) == 0.0:
                    return 0
    return int(state[triangle])


@kernel
def _states(
    triangulation: Triangulation,
    state: NDArray[np.uint8],
    queries: NDArray[np.float64],
    found: NDArray[np.int32],
    states: NDArray[np.uint8],
) -> None:
    for k in range(found.size):
        x, y = queries[k, 0], queries[k, 1]
        states[k] = _state_at(triangulation, state, wide(found[k]), x, y)


@kernel
def _states_of_triangles(
    triangulation: Triangulation,
    state: NDArray[np.uint8],
    corners: NDArray[np.float64],
    triangles: NDArray[np.int32],
    corner_states: NDArray[np.uint8],
    hints: NDArray[np.int32],
    ask_centroids: bool,
    gaps: Gaps,
    states: NDArray[np.uint8],
) -> None:
    (x0, y0, per_cell, rows, columns), near_gap = gaps
    states[:] = 0
    for t in range(triangles.shape[0]):
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        p, q, r = corner_states[a], corner_states[b], corner_states[c]
        if p == 1 or q == 1 or r == 1:
            states[t] = 1
        elif p == 2 or q == 2 or r == 2:
            states[t] = 2
        elif ask_centroids:
            x = mean_of(corners[a, 0], corners[b, 0], corners[c, 0])
            y = mean_of(corners[a, 1], corners[b, 1], corners[c, 1])
            column = int(min(max((x - x0) * per_cell, 0.0), columns - 1.0))
            row = int(min(max((y - y0) * per_cell, 0.0), rows - 1.0))
            if near_gap[row, column]:
                found = walk_to(triangulation, hints[a], x, y)
                states[t] = _state_at(triangulation, state, found, x, y)


def states_of_triangles(
    footprint: Footprint,
    nodes: NDArray[np.float64],
    triangles: NDArray[np.int32],
    node_states: NDArray[np.uint8],
    hints: NDArray[np.int32],
    *,
    ask_centroids: bool,
) -> NDArray[np.uint8]:
    """Tell which triangles of T lie where one surface has data.

    Parameters
    ----------
    footprint : Footprint
        Of that surface.
    nodes, triangles : (N, 2) float64, (M, 3) int32
        T.
    node_states : (N,) uint8
        DATA, OUTSIDE or HOLE at each node of T.
    hints : (N,) int32
        A triangle of the footprint's triangulation at or near each node of T.
    ask_centroids : bool
        Whether there must be data at the centroid too.

    Returns
    -------
    (M,) uint8
        DATA, OUTSIDE or HOLE.
    """
    t = footprint.triangulation
    states = np.empty(len(triangles), np.uint8)
    asking = ask_centroids and not footprint.is_hull
    gaps = NO_GAPS
    if asking:
        gaps = gaps_of(t.nodes, t.triangles[footprint.state[: t.real] != DATA])
    _states_of_triangles(
        t,
        footprint.state,
        nodes,
        triangles,
        node_states,
        hints,
        asking,
        gaps,
        states,
    )
    if asking and footprint.faces is not None:
        # nodes have been asked already: what is left are centroids beside triangles that are faces
        asked = np.flatnonzero(states != DATA)
        asked = asked[(node_states[triangles[asked]] == DATA).all(axis=1)]
        middles = centroids(nodes, triangles[asked])
        states[asked[covered_by(footprint.faces, middles)]] = DATA
        states[states == _PARTIAL] = HOLE
    return states


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
    _states(t, footprint.state, queries, found, states)
    if footprint.faces is not None:
        asked = np.flatnonzero(states != DATA)
        states[asked[covered_by(footprint.faces, queries[asked])]] = DATA
        states[states == _PARTIAL] = HOLE
    return states
