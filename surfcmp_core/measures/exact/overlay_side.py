"""One surface as the exact reading wants it: triangles, functions on them, lines along edges."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.measures.exact.linear_on_triangle import set_frame
from surfcmp_core.measures.exact.overlapped import lowest_edges, overlapped, sort_found
from surfcmp_core.predicates import twice_area
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import leaving_edges


@dataclass(frozen=True, slots=True, eq=False)
class LinearSurface:
    """One surface as a linear function on each triangle of its own triangulation.

    Attributes
    ----------
    triangulation : Triangulation
        T1 or T2, or another one of the same n nodes, of m real triangles.
    z : (n,) float64
        F at its nodes.
    planes : (m, 3) int32
        Nodes between which F is linear on each triangle: its own, or those of the face that it
        is a part of.
    valid : (m,) bool
        Triangles over which the surface has data.
    found : (n',) int32
        Its triangle or ghost in which each node of the other grid lies.
    """

    triangulation: Triangulation
    z: NDArray[np.float64]
    planes: NDArray[np.int32]
    valid: NDArray[np.bool_]
    found: NDArray[np.int32]


class OverlaySide(NamedTuple):
    """A `LinearSurface` in the numbers of T, for the kernels.

    Those unpack it once and hand its arrays on: to take one out of a tuple costs an atomic count,
    for each triangle of T several, which made the exact reading take a seventh longer.
    """

    nodes: NDArray[np.float64]
    start: NDArray[np.int32]
    twin: NDArray[np.int32]
    real: int
    leaving: NDArray[np.int32]
    own: NDArray[np.int32]
    found: NDArray[np.int32]
    z: NDArray[np.float64]
    planes: NDArray[np.int32]
    valid: NDArray[np.bool_]


def side_of(
    surface: LinearSurface,
    count: int,
    own_nodes: NDArray[np.int32],
    other_nodes: NDArray[np.int32],
) -> OverlaySide:
    """Bring a surface into the numbers of the `count` nodes of T."""
    t = surface.triangulation
    own = np.full(count, -1, np.int32)
    own[own_nodes] = np.arange(len(own_nodes), dtype=np.int32)
    found = np.full(count, -1, np.int32)
    found[other_nodes] = surface.found
    leaving = leaving_edges(t.start, len(t.nodes))
    return OverlaySide(
        t.nodes,
        t.start,
        t.twin,
        t.real,
        leaving,
        own,
        found,
        surface.z,
        surface.planes,
        surface.valid,
    )


def precedes(one: LinearSurface, other: LinearSurface) -> bool:
    """Say which of two surfaces is the first, whichever of them is surface 1.

    Nodes stand along one curve in both, so their order is that of places. Equal surfaces follow
    each other.
    """
    if len(one.z) != len(other.z):
        return len(one.z) < len(other.z)
    points, others = (
        np.column_stack((s.triangulation.nodes, s.z)).reshape(-1) for s in (one, other)
    )
    unlike = np.flatnonzero(points != others)
    if len(unlike):
        return bool(points[unlike[0]] < others[unlike[0]])
    faces, other_faces = (
        np.sort(lowest_edges(s.planes.reshape(-1), np.flatnonzero(s.valid))) for s in (one, other)
    )
    if len(faces) != len(other_faces):
        return len(faces) < len(other_faces)
    unlike = np.flatnonzero(faces != other_faces)
    return bool(len(unlike) and faces[unlike[0]] < other_faces[unlike[0]])


@kernel
def frame_of(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    z: NDArray[np.float64],
    planes: NDArray[np.int32],
    t: int,
    x: float,
    y: float,
    length: float,
    frames: NDArray[np.float64],
    which: int,
) -> None:
    """Describe the function on triangle t of T1 or T2, as seen from (x, y), in a row."""
    p, q, r = planes[t, 0], planes[t, 1], planes[t, 2]
    if q < p and q < r:  # the lowest node first, however the triangle is numbered
        p, q, r = q, r, p
    elif r < p:
        p, q, r = r, p, q
    set_frame(
        (nodes[p, 0] - x) * length,
        (nodes[p, 1] - y) * length,
        z[p],
        (nodes[q, 0] - x) * length,
        (nodes[q, 1] - y) * length,
        z[q],
        (nodes[r, 0] - x) * length,
        (nodes[r, 1] - y) * length,
        z[r],
        frames,
        which,
    )
    a, b, c = start[3 * t], start[3 * t + 1], start[3 * t + 2]
    for axis in range(2):
        origin = y if axis else x
        at_a, at_b, at_c = nodes[a, axis], nodes[b, axis], nodes[c, axis]
        frames[which, 10 + 2 * axis] = (min(min(at_a, at_b), at_c) - origin) * length
        frames[which, 11 + 2 * axis] = (max(max(at_a, at_b), at_c) - origin) * length


@kernel
def lines_of(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    own: NDArray[np.int32],
    t: int,
    edges: int,
    places: NDArray[np.float64],
    corners: NDArray[np.int32],
    lines: NDArray[np.float64],
    which: int,
) -> None:
    """Measure the edges of t that run through a triangle of T against its nodes, in a row."""
    for k in range(3):
        if edges >> k & 1 == 0:
            continue
        p, q = start[3 * t + k], start[3 * t + (k + 1) % 3]
        inward = 1.0
        if q < p:  # the triangle beyond asks about the same two nodes in the same order
            p, q = q, p
            inward = -1.0
        for i in range(3):
            v = corners[i]
            number = own[v]
            lines[which, k, i] = 0.0
            if number != p and number != q:
                lines[which, k, i] = inward * twice_area(
                    nodes[p, 0],
                    nodes[p, 1],
                    nodes[q, 0],
                    nodes[q, 1],
                    places[v, 0],
                    places[v, 1],
                )


@kernel
def overlapped_with_data(
    nodes: NDArray[np.float64],
    start: NDArray[np.int32],
    twin: NDArray[np.int32],
    real: int,
    leaving: NDArray[np.int32],
    own: NDArray[np.int32],
    found: NDArray[np.int32],
    valid: NDArray[np.bool_],
    places: NDArray[np.float64],
    corners: NDArray[np.int32],
    found_triangles: NDArray[np.int32],
    found_edges: NDArray[np.int32],
) -> tuple[int, bool]:
    """List the triangles of T1 or T2 that a triangle of T meets, those with data, in order.

    Returns
    -------
    count : int
    covers : bool
        Whether they cover the triangle of T.
    """
    count, covers = overlapped(
        nodes,
        start,
        twin,
        real,
        leaving,
        own,
        found,
        places,
        corners[0],
        corners[1],
        corners[2],
        found_triangles,
        found_edges,
    )
    kept = 0
    for i in range(count):
        if valid[found_triangles[i]]:
            found_triangles[kept] = found_triangles[i]
            found_edges[kept] = found_edges[i]
            kept += 1
        else:
            covers = False
    sort_found(start, found_triangles, found_edges, kept)
    return kept, covers


@kernel
def from_leftmost(
    nodes: NDArray[np.float64], triangles: NDArray[np.int32], t: int, corners: NDArray[np.int32]
) -> None:
    """Begin a triangle of T with its leftmost node, the lower one of two."""
    first = 0
    for k in range(1, 3):
        v, best = triangles[t, k], triangles[t, first]
        if nodes[v, 0] < nodes[best, 0] or (
            nodes[v, 0] == nodes[best, 0] and nodes[v, 1] < nodes[best, 1]
        ):
            first = k
    for k in range(3):
        corners[k] = triangles[t, (first + k) % 3]
