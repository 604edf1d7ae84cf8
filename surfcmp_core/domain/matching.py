"""Which triangles of a triangulation are faces of a mesh."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import following, leaving_edges, preceding


@kernel
def _match_faces(
    triangulation: Triangulation,
    leaving: NDArray[np.int32],
    faces: NDArray[np.int32],
    whole: NDArray[np.bool_],
    other: NDArray[np.bool_],
) -> None:
    """Mark triangles that are faces of the model, and faces that are no triangles."""
    _, start, twin, _ = triangulation
    for f in range(faces.shape[0]):
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        other[f] = a != b and b != c and c != a
        if not other[f]:
            continue
        begin = leaving[a]
        h = begin
        while True:
            d, e = start[following(h)], start[preceding(h)]
            if (d == b and e == c) or (d == c and e == b):
                whole[h // 3] = True
                other[f] = False
                break
            h = twin[preceding(h)]
            if h == begin:
                break


def match_faces(
    triangulation: Triangulation, faces: NDArray[np.int32]
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Tell which triangles are faces of a mesh, and which faces are not triangles.

    Parameters
    ----------
    triangulation : Triangulation
    faces : (k, 3) int32
        Turned either way.

    Returns
    -------
    whole : (m,) bool
        Triangles that are faces.
    other : (k,) bool
        Faces of three different nodes that are no triangles.
    """
    t = triangulation
    whole = np.zeros(len(t.start) // 3, np.bool_)
    leaving = leaving_edges(t.start, len(t.nodes))
    other = np.empty(len(faces), np.bool_)
    _match_faces(t, leaving, faces, whole, other)
    return whole[: t.real], other
