"""A triangulation of a mesh's nodes that holds the mesh's own faces."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.compiled.stack import enlarged
from surfcmp_core.predicates import orientation
from surfcmp_core.triangulation.half_edges import following, leaving_edges, preceding
from surfcmp_core.triangulation.triangulation import Triangulation

NO_FACE = -1
WHOLE = -2
"""A triangle that is a face itself."""


class _Held(NamedTuple):
    """A triangulation whose edges are turned in place.

    Attributes
    ----------
    nodes, start, twin
        See `Triangulation`.
    leaving : (n,) int32
        A half-edge that leaves each node.
    fixed : (3 (m + h),) bool
        Half-edges that may no longer be turned.
    """

    nodes: NDArray[np.float64]
    start: NDArray[np.int32]
    twin: NDArray[np.int32]
    leaving: NDArray[np.int32]
    fixed: NDArray[np.bool_]


@kernel
def _edge_between(held: _Held, a: int, b: int) -> int:
    """Half-edge from a to b, -1 where there is none."""
    _, start, twin, leaving, _ = held
    begin = int(leaving[a])
    h = begin
    while True:
        if start[following(h)] == b:
            return h
        h = int(twin[preceding(h)])
        if h == begin:
            return -1


@kernel
def _turn(nodes: NDArray[np.float64], a: int, b: int, c: int) -> float:
    return orientation(nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1], nodes[c, 0], nodes[c, 1])


@kernel
def _same_way(nodes: NDArray[np.float64], v: int, w: int, q: int) -> bool:
    """Whether w lies on the same side of v as q does, of three nodes on one line."""
    if nodes[q, 0] != nodes[v, 0]:
        return bool((nodes[w, 0] > nodes[v, 0]) == (nodes[q, 0] > nodes[v, 0]))
    return bool((nodes[w, 1] > nodes[v, 1]) == (nodes[q, 1] > nodes[v, 1]))


@kernel
def _first_step(
    held: _Held,
    v: int,
    q: int,
) -> tuple[int, bool]:
    """From v towards q: the edge that runs there, or (False) the edge of v's triangle to cross."""
    nodes, start, twin, leaving, _ = held
    begin = int(leaving[v])
    h = begin
    while True:
        w, x = start[following(h)], start[preceding(h)]
        if w >= 0:
            turn = _turn(nodes, v, w, q)
            if w == q or (turn == 0.0 and _same_way(nodes, v, w, q)):
                return h, True
            if x >= 0 and turn > 0.0 and _turn(nodes, v, q, x) > 0.0:
                return following(h), False
        h = int(twin[preceding(h)])
        if h == begin:
            return -1, False


@kernel
def _flip(
    held: _Held,
    h: int,
) -> None:
    """Put the other diagonal of its quadrangle in the place of an edge."""
    _, start, twin, leaving, fixed = held
    k = int(twin[h])
    h_next, h_last, k_next, k_last = following(h), preceding(h), following(k), preceding(k)
    a, b, c, d = start[h], start[k], start[h_last], start[k_last]
    leaving[a], leaving[b] = k_next, h_next
    start[h], start[k] = d, c
    over = twin[k_last]
    twin[h], twin[over] = over, h
    over = twin[h_last]
    twin[k], twin[over] = over, k
    twin[h_last], twin[k_last] = k_last, h_last
    fixed[h], fixed[k] = fixed[k_last], fixed[h_last]
    fixed[h_last] = fixed[k_last] = False


@kernel
def _crossed(
    held: _Held,
    g: int,
    v: int,
    q: int,
    pairs: NDArray[np.int32],
) -> tuple[int, int, NDArray[np.int32]]:
    """List the edges that vq crosses, from edge g on, until it meets a node.

    Returns
    -------
    target, count : int
        The node, -1 where an edge in the way is fixed; how many edges.
    pairs : int32
        Both nodes of each; perhaps with more room.
    """
    nodes, start, twin, _, fixed = held
    count = 0
    while True:
        if fixed[g]:
            return -1, count, pairs
        if 2 * count + 2 > pairs.size:
            pairs = enlarged(pairs)
        pairs[2 * count], pairs[2 * count + 1] = start[g], start[following(g)]
        count += 1
        k = int(twin[g])
        y = int(start[preceding(k)])
        if y < 0:
            return -1, count, pairs
        turn = _turn(nodes, v, q, y)
        if turn == 0.0:
            return y, count, pairs
        g = following(k) if turn > 0.0 else preceding(k)


@kernel
def _clear(
    held: _Held,
    v: int,
    target: int,
    pairs: NDArray[np.int32],
    count: int,
) -> bool:
    """Flip edges out of the way from v to the target [Sloan1993]; exact, so it ends."""
    nodes, start, twin, _, _ = held
    left = count
    at = 0
    patience = 64 + 4 * count * count
    while left > 0:
        patience -= 1
        if patience < 0:
            return False
        i = at % count
        at += 1
        a, b = int(pairs[2 * i]), int(pairs[2 * i + 1])
        if a < 0:
            continue
        h = _edge_between(held, a, b)
        c, d = int(start[preceding(h)]), int(start[preceding(twin[h])])
        if _turn(nodes, d, b, c) <= 0.0 or _turn(nodes, c, a, d) <= 0.0:
            continue
        _flip(held, h)
        over, under = _turn(nodes, v, target, c), _turn(nodes, v, target, d)
        if (over > 0.0 and under < 0.0) or (over < 0.0 and under > 0.0):
            pairs[2 * i], pairs[2 * i + 1] = c, d
        else:
            pairs[2 * i] = -1
            left -= 1
    return True


@kernel
def _insert(
    held: _Held,
    p: int,
    q: int,
    pairs: NDArray[np.int32],
) -> tuple[bool, NDArray[np.int32]]:
    """Make the segment pq an edge, or several where nodes lie on it, and fix it."""
    _, start, twin, _, fixed = held
    v = p
    while v != q:
        h, along = _first_step(held, v, q)
        if h < 0:
            return False, pairs
        if not along:
            target, count, pairs = _crossed(held, h, v, q, pairs)
            if target < 0 or not _clear(held, v, target, pairs, count):
                return False, pairs
            h = _edge_between(held, v, target)
        fixed[h] = fixed[twin[h]] = True
        v = int(start[following(h)])
    return True, pairs


@kernel
def _hold(
    held: _Held,
    whole: NDArray[np.bool_],
    faces: NDArray[np.int32],
    lost: NDArray[np.bool_],
) -> None:
    """Bring the edges of all faces into the triangulation; say whose could not be."""
    _, _, twin, _, fixed = held
    for t in range(len(whole)):
        if whole[t]:
            for h in range(3 * t, 3 * t + 3):
                fixed[h] = fixed[twin[h]] = True
    pairs = np.empty(64, np.int32)
    for f in range(len(faces)):
        lost[f] = False
        for k in range(3):
            p, q = faces[f, k], faces[f, (k + 1) % 3]
            done, pairs = _insert(held, min(p, q), max(p, q), pairs)
            if not done:
                lost[f] = True


@kernel
def _on_border(nodes: NDArray[np.float64], face: NDArray[np.int32], u: int, w: int) -> bool:
    for k in range(3):
        p, q = face[k], face[(k + 1) % 3]
        if _turn(nodes, p, q, u) == 0.0 and _turn(nodes, p, q, w) == 0.0:
            return True
    return False


@kernel
def _fill(
    held: _Held,
    faces: NDArray[np.int32],
    lost: NDArray[np.bool_],
    face_of: NDArray[np.int32],
) -> int:
    """Mark the triangles of each face; return how many faces lie over another one."""
    nodes, start, twin, _, _ = held
    overlapping = 0
    stack = np.empty(64, np.int32)
    for f in range(len(faces)):
        if lost[f]:
            continue
        a, b = int(faces[f, 0]), int(faces[f, 1])
        h, _ = _first_step(held, a, b)
        stack[0] = h // 3
        if face_of[h // 3] != NO_FACE:
            overlapping += 1
            continue
        face_of[h // 3] = f
        if start[following(h)] == b and start[preceding(h)] == faces[f, 2]:
            continue
        depth = 1
        clean = True
        while depth > 0:
            depth -= 1
            t = stack[depth]
            for k in range(3 * t, 3 * t + 3):
                beyond = twin[k] // 3
                if face_of[beyond] == f or _on_border(
                    nodes, faces[f], start[k], start[following(k)]
                ):
                    continue
                if face_of[beyond] != NO_FACE:
                    clean = False
                    continue
                face_of[beyond] = f
                if depth == stack.size:
                    stack = enlarged(stack)
                stack[depth] = beyond
                depth += 1
        if not clean:
            overlapping += 1
    return overlapping


def with_faces(
    triangulation: Triangulation, whole: NDArray[np.bool_], faces: NDArray[np.int32]
) -> tuple[Triangulation, NDArray[np.int32], NDArray[np.bool_], int]:
    """Turn edges of a triangulation until it holds the faces of a mesh.

    Where nodes lie on the edge of a face, or inside it, several triangles make it up together. The
    result depends on the order of the faces only where they lie over each other: the first ones
    are held.

    Parameters
    ----------
    triangulation : Triangulation
        Of the mesh's nodes, left as it is.
    whole : (m,) bool
        Its triangles that are faces already.
    faces : (k, 3) int32
        The other faces, counter-clockwise, with an area, no two of the same nodes.

    Returns
    -------
    Triangulation
        Of the same nodes, those faces and the ghosts in their places; in general not Delaunay.
    face_of : (m,) int32
        The face in which each of its triangles lies, WHOLE where it is one, NO_FACE for none.
    lost : (k,) bool
        Faces that are not held because their edges cross those of others.
    overlapping : int
        Other faces that lie over faces held.

    References
    ----------
    [Sloan1993].
    """
    t = triangulation
    start, twin = t.start.copy(), t.twin.copy()
    leaving, fixed = leaving_edges(start, len(t.nodes)), np.zeros(len(start), np.bool_)
    held = _Held(t.nodes, start, twin, leaving, fixed)
    lost = np.empty(len(faces), np.bool_)
    _hold(held, whole, faces, lost)
    face_of = np.full(len(start) // 3, NO_FACE, np.int32)
    face_of[: t.real][whole] = WHOLE
    overlapping = _fill(held, faces, lost, face_of)
    return Triangulation(t.nodes, start, twin, t.real), face_of[: t.real], lost, overlapping
