"""Coverage is a share, however the faces of a model lie."""

import numpy as np
import pytest
from scipy.spatial import Delaunay

from surfcmp_core.comparing.request import compare
from surfcmp_core.surface import Surface


@pytest.mark.parametrize("seed", range(6))
def test_faces_of_cocircular_nodes_that_are_no_triangles_of_t1(seed: int) -> None:
    rng = np.random.default_rng(seed)
    angle = np.arange(64) * 2.0 * np.pi / 64
    ring = np.column_stack((np.cos(angle), np.sin(angle), rng.random(64)))
    faces = Delaunay(ring[:, :2]).simplices.astype(np.int32)
    faces = faces[rng.random(len(faces)) < 0.85]
    mesh = Surface(ring, faces=faces, name="ring", unit="mm")
    cloud = Surface(2.0 * rng.random((200, 3)) - 1.0, name="cloud", unit="mm")
    found = compare(mesh, cloud, exact=True, max_edge=np.inf).measures
    assert found.exact is not None
    for share in (found.coverage_1, found.coverage_2):
        assert 0.0 < share <= 1.0
    for share in (found.exact.coverage_1, found.exact.coverage_2):
        assert 0.0 < share <= 1.0


def test_order_of_faces_does_not_matter() -> None:
    rng = np.random.default_rng(1)
    points = rng.random((300, 3))
    faces = Delaunay(points[:, :2]).simplices.astype(np.int32)
    faces = faces[rng.random(len(faces)) < 0.9]
    other = Surface(rng.random((200, 3)), name="cloud", unit="mm")
    meshes = (Surface(points, faces=part, name="mesh", unit="mm") for part in (faces, faces[::-1]))
    one, two = (compare(mesh, other).measures for mesh in meshes)
    assert one == two
