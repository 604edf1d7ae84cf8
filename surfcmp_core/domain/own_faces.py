"""A mesh's own faces, where they are not the triangles of T1."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.cells.buckets import buckets_of, covered_by
from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.domain.centroids import centroids
from surfcmp_core.domain.matching import match_faces
from surfcmp_core.predicates import orientation
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.with_faces import NO_FACE, with_faces


@dataclass(frozen=True, slots=True, eq=False)
class OwnFaces:
    """A surface's own triangles: what the exact reading integrates on.

    Attributes
    ----------
    triangulation : Triangulation
        Of the mesh's nodes; it holds the mesh's faces, and is T1 where those are its triangles.
    valid : (m,) bool
        Its triangles under a face.
    planes : (m, 3) int32
        Nodes between which the surface is linear on each of them: the face's.
    replaced : int
        Faces with an area that are not triangles of T1.
    overlapping : int
        Faces that lie over others in the plane. Where they do not fit in, the surface is linear
        between the nodes of the triangulation.
    """

    triangulation: Triangulation
    valid: NDArray[np.bool_]
    planes: NDArray[np.int32]
    replaced: int
    overlapping: int


@kernel
def _turn_all(nodes: NDArray[np.float64], faces: NDArray[np.int32]) -> int:
    """Make faces counter-clockwise, their lowest node first, in place; drop those without area."""
    kept = 0
    for f in range(len(faces)):
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        turn = orientation(
            nodes[a, 0], nodes[a, 1], nodes[b, 0], nodes[b, 1], nodes[c, 0], nodes[c, 1]
        )
        if turn == 0.0:
            continue
        if turn < 0.0:
            b, c = c, b
        if b < a and b < c:
            a, b, c = b, c, a
        elif c < a:
            a, b, c = c, a, b
        faces[kept, 0], faces[kept, 1], faces[kept, 2] = a, b, c
        kept += 1
    return kept


def own_faces(triangulation: Triangulation, faces: NDArray[np.int32]) -> OwnFaces:
    """Find the triangulation that holds a mesh's faces.

    Parameters
    ----------
    triangulation : Triangulation
        T1, of the mesh's nodes.
    faces : (k, 3) int32
        The mesh's faces, turned either way, in any order, perhaps repeated.

    Returns
    -------
    OwnFaces
        The same in whichever order the faces come.
    """
    t = triangulation
    whole, other = match_faces(t, faces)
    others = faces[other]
    others = np.unique(others[: _turn_all(t.nodes, others)], axis=0)
    if len(others) == 0:
        return OwnFaces(t, whole, t.triangles, 0, 0)
    own, face_of, lost, overlapping = with_faces(t, whole, others)
    valid = face_of != NO_FACE
    planes = own.triangles.copy()
    planes[face_of >= 0] = others[face_of[face_of >= 0]]
    if lost.any():
        open_ = np.flatnonzero(~valid)
        middles = centroids(t.nodes, own.triangles[open_])
        valid[open_] = covered_by(buckets_of(t.nodes, others[lost]), middles)
    return OwnFaces(own, valid, planes, len(others), overlapping + int(lost.sum()))
