"""Meshes of any faces over noisy lattices measure the same, to the last bit, either way round."""

import math
from dataclasses import asdict

import numpy as np
import pytest
from triangular import delaunay

from surfcmp_core.comparing.request import compare
from surfcmp_core.surface import Surface

BESIDE_A_BORDER = (529, 1016, 1177, 1851, 2651, 2838, 3166, 3396, 3713, 4185)
"""Centroids on borders of the data, which rounding put on either side of them."""


def _mesh(rng: np.random.Generator, name: str) -> Surface:
    side = int(rng.integers(4, 9))
    x, y = np.meshgrid(np.arange(side), np.arange(side))
    nodes = np.column_stack((x.ravel(), y.ravel())).astype(float)
    nodes += rng.choice([0, 1e-3, 0.1, 0.3]) * rng.random(nodes.shape)
    nodes = nodes * rng.choice([1, 0.1, 1 / 3, 0.7]) + rng.choice([0, 0.5, 0.1])
    nodes = nodes[rng.random(len(nodes)) < 0.9]
    faces = delaunay(np.ascontiguousarray(nodes))
    if rng.random() < 0.7:
        faces = delaunay(np.ascontiguousarray(nodes + 0.2 * rng.random(nodes.shape)))
    faces = faces[rng.random(len(faces)) < 0.8]
    points = np.column_stack((nodes, rng.random(len(nodes))))
    return Surface(points, faces=np.asarray(faces, np.int32), name=name, unit="mm")


@pytest.mark.parametrize("seed", BESIDE_A_BORDER)
def test_measures_are_the_same_either_way_round(seed: int) -> None:
    rng = np.random.default_rng(seed)
    first, second = _mesh(rng, "first"), _mesh(rng, "second")
    found, other = (asdict(compare(*pair).measures) for pair in ((first, second), (second, first)))
    for one, two in (
        ("mean_signed", None),
        ("volume_above", "volume_below"),
        ("coverage_1", "coverage_2"),
        ("hausdorff_1_2", "hausdorff_2_1"),
    ):
        if two is None:
            assert found.pop(one) == -other.pop(one)
        else:
            assert (found.pop(one), found.pop(two)) == (other.pop(two), other.pop(one))
    within, other_within = found.pop("within_tolerance"), other.pop("within_tolerance")
    assert within == other_within
    for name, value in found.items():
        assert value == other[name] or (math.isnan(value) and math.isnan(other[name])), name
