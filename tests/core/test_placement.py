"""Pairs and single surfaces as they lie, placed for comparison."""

import numpy as np
import pytest

from surfcmp_core import compare
from surfcmp_core.projection import moved
from surfcmp_core.projection.placement import look_at, place
from tests.core.sheets import sheet
from tests.core.turning import any_motion, mirrored_back

PAIRS = [
    ("face_demo_10k", "face_demo_1k"),
    ("face_ict_neutral", "face_ict_smile"),
    ("ct_skin", "ct_skull"),
    ("made_face_fine", "made_face_coarse"),
    ("made_skin", "made_bone"),
]
RELATIVE = ["mean_abs", "rms", "max_abs", "p95", "rho_V", "rho_delta_V", "area_compared"]


@pytest.mark.parametrize("names", PAIRS, ids=" ".join)
def test_turned_pairs_have_the_same_measures(scan, names):
    surfaces = [scan(name) for name in names]
    measures = compare(*place(*surfaces, "auto").surfaces).measures
    motion = any_motion(np.random.default_rng(4), 130.0, 300.0, np.zeros(3))
    placed = place(*[moved(surface, motion) for surface in surfaces], "auto")
    turned = compare(*placed.surfaces).measures
    for name in RELATIVE:
        assert getattr(turned, name) == pytest.approx(getattr(measures, name), rel=0.01), name
    assert turned.mean_signed == pytest.approx(measures.mean_signed, abs=0.01 * measures.mean_abs)


@pytest.mark.parametrize("view", ["auto", (0.3, -0.2, 1.0)])
def test_one_surface_is_looked_at_as_one_of_a_pair(view):
    closed = mirrored_back(sheet(lambda x, y: 0.3 * np.cos(x) * np.cos(y), wide=1.3), 0.2)
    sight = look_at(closed, view)
    placed = place(closed, closed, view)
    np.testing.assert_allclose(sight.motion, placed.motions[0], atol=1e-12)
    np.testing.assert_array_equal(sight.part.faces, placed.surfaces[1].faces)
    assert sight.removed.nodes == placed.removed[0].nodes
    assert sight.part.dropped == placed.surfaces[0].dropped
    assert len(closed.points) == len(sight.part.points) + sum(sight.part.dropped.values())
