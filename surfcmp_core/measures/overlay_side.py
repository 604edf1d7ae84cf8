"""One surface as the exact reading wants it: triangles, functions on them, lines along edges."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import kernel
from surfcmp_core.measures.linear_on_triangle import set_frame
from surfcmp_core.measures.overlap import lowest_edge, lowest_edges, overlapped, sort_found
from surfcmp_core.predicates import twice_area
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import leaving_edges


@dataclass(frozen=True, slots=True, eq=False)
class LinearSurface:
    """One surface as a linear function on each triangle of its own triangulation.

    Attributes
    ----------
    triangulation : Triangulation
        T1 or T2, n nodes and m real triangles.
    z : (n,) float64
        F at its nodes.
    valid : (m,) bool
        Triangles over which the surface has data.
    found : (n',) int32
        Its triangle or ghost in which each node of the other grid lies.
    """

    triangulation: Triangulation
    z: NDArray[np.float64]
    valid: NDArray[np.bool_]
    found: NDArray[np.int32]


class OverlaySide(NamedTuple):
    """A `LinearSurface` in the numbers of T, for the kernel."""

    nodes: NDArray[np.float64]
    start: NDArray[np.int32]
    twin: NDArray[np.int32]
    real: int
    leaving: NDArray[np.int32]
    own: NDArray[np.int32]
    found: NDArray[np.int32]
    z: NDArray[np.float64]
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
        np.sort(lowest_edges(s.triangulation.start, np.flatnonzero(s.valid))) for s in (one, other)
    )
    if len(faces) != len(other_faces):
        return len(faces) < len(other_faces)
    unlike = np.flatnonzero(faces != other_faces)
    return bool(len(unlike) and faces[unlike[0]] < other_faces[unlike[0]])


@kernel
def frame_of(
    side: OverlaySide, t: int, x: float, y: float, length: float, frame: NDArray[np.float64]
) -> None:
    """Describe the function on triangle t of T1 or T2, as seen from (x, y)."""
    a, b = lowest_edge(side.start, t)
    c = side.start[3 * t] + side.start[3 * t + 1] + side.start[3 * t + 2] - a - b
    set_frame(
        (side.nodes[a, 0] - x) * length,
        (side.nodes[a, 1] - y) * length,
        side.z[a],
        (side.nodes[b, 0] - x) * length,
        (side.nodes[b, 1] - y) * length,
        side.z[b],
        (side.nodes[c, 0] - x) * length,
        (side.nodes[c, 1] - y) * length,
        side.z[c],
        frame,
    )


@kernel
def lines_of(
    side: OverlaySide,
    t: int,
    edges: int,
    nodes: NDArray[np.float64],
    corners: NDArray[np.int32],
    lines: NDArray[np.float64],
) -> None:
    """Measure the edges of t that run through a triangle of T against its nodes."""
    for k in range(3):
        if edges >> k & 1 == 0:
            continue
        p, q = side.start[3 * t + k], side.start[3 * t + (k + 1) % 3]
        inward = 1.0
        if q < p:  # the triangle beyond asks about the same two nodes in the same order
            p, q = q, p
            inward = -1.0
        for i in range(3):
            v = corners[i]
            own = side.own[v]
            lines[k, i] = 0.0
            if own != p and own != q:
                lines[k, i] = inward * twice_area(
                    side.nodes[p, 0],
                    side.nodes[p, 1],
                    side.nodes[q, 0],
                    side.nodes[q, 1],
                    nodes[v, 0],
                    nodes[v, 1],
                )


@kernel
def overlapped_with_data(
    side: OverlaySide,
    nodes: NDArray[np.float64],
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
        side.nodes,
        side.start,
        side.twin,
        side.real,
        side.leaving,
        side.own,
        side.found,
        nodes,
        corners[0],
        corners[1],
        corners[2],
        found_triangles,
        found_edges,
    )
    kept = 0
    for i in range(count):
        if side.valid[found_triangles[i]]:
            found_triangles[kept] = found_triangles[i]
            found_edges[kept] = found_edges[i]
            kept += 1
        else:
            covers = False
    sort_found(side.start, found_triangles, found_edges, kept)
    return kept, covers
