"""Clouds of scan lines have data between the lines, and none where lines are missing."""

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from surfcmp_core import Surface, compare
from surfcmp_core.domain import footprint_of_cloud
from surfcmp_core.domain.footprint import Footprint
from surfcmp_core.domain.scan_lines import distance_of_lines
from surfcmp_core.domain.spacing import limits_of_edges, spacing_at
from surfcmp_core.errors import InputError
from surfcmp_core.io import read_surface
from surfcmp_core.spanning_tree import spanning_tree, tree_ends
from surfcmp_core.triangulation import triangulate

REPORTS = Path(__file__).parent / "fixtures" / "reports"
Nodes = NDArray[np.float64]


def _lines(
    ratio: float, seed: int = 0, jitter: float = 0.0, columns: int = 81, rows: int = 21
) -> Nodes:
    """Nodes 1 apart on lines `ratio` apart, each begun anywhere."""
    rng = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(float(columns)), np.arange(rows) * ratio)
    if jitter:
        x = x + rng.uniform(0.0, 1.0, (rows, 1)) + rng.uniform(-0.3, 0.3, x.shape)
        y = y + rng.normal(scale=jitter, size=y.shape)
    return np.column_stack((x.ravel(), y.ravel()))


def _turned(nodes: Nodes, degrees: float) -> Nodes:
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.asarray(nodes @ np.array([[c, s], [-s, c]]))


def _footprint(nodes: Nodes) -> Footprint:
    t = triangulate(nodes)
    return footprint_of_cloud(t, tree_ends(t, spanning_tree(t)), None)


def _distance(nodes: Nodes) -> float:
    t = triangulate(nodes)
    return distance_of_lines(t, spacing_at(t.nodes, tree_ends(t, spanning_tree(t))))


@pytest.mark.parametrize("degrees", [0.0, 33.0, 90.0])
@pytest.mark.parametrize("jitter", [0.0, 0.05])
@pytest.mark.parametrize("ratio", [1.0, 2.0, 3.0, 4.0, 5.0, 7.0, 10.0])
def test_there_are_data_between_the_lines(ratio: float, jitter: float, degrees: float) -> None:
    footprint = _footprint(_turned(_lines(ratio, jitter=jitter), degrees))
    assert footprint.area == pytest.approx(80.0 * 20.0 * ratio, rel=0.02)


@pytest.mark.parametrize("ratio", [4.0, 7.0, 10.0])
def test_there_are_none_where_two_lines_are_missing_or_a_part_of_some(ratio: float) -> None:
    nodes = _lines(ratio, jitter=0.02)
    row = np.rint(nodes[:, 1] / ratio)
    hole = (row >= 6) & (row <= 9) & (np.abs(nodes[:, 0] - 40.0) < 2.5 * ratio)
    t = triangulate(nodes[~(hole | np.isin(row, (14, 15)))])
    footprint = footprint_of_cloud(t, tree_ends(t, spanning_tree(t)), None)
    middle = t.nodes[t.triangles].mean(axis=1)
    inside = (np.abs(middle[:, 0] - 40.0) < 1.5 * ratio) & (
        np.abs(middle[:, 1] - 7.5 * ratio) < 1.4 * ratio
    )
    inside |= np.abs(middle[:, 1] - 14.5 * ratio) < 1.4 * ratio
    assert inside.any()
    assert not footprint.covered[inside].any()


@pytest.mark.parametrize("power", [1, 2, 3])
@pytest.mark.parametrize("seed", range(4))
def test_nodes_strewn_at_random_are_no_lines(seed: int, power: int) -> None:
    assert _distance(np.random.default_rng(seed).random((900, 2)) ** power) == 0.0


def test_lattices_are_no_lines_and_lines_far_apart_no_surface() -> None:
    assert _distance(_lines(1.0)) == 0.0
    assert _distance(_lines(1.5)) == 0.0
    assert _distance(_lines(6.0)) == 6.0
    assert _distance(_lines(20.0)) == 0.0


def test_the_distance_of_lines_depends_on_neither_order_nor_scale() -> None:
    nodes = _lines(4.0)
    order = np.random.default_rng(1).permutation(len(nodes))
    for moved in (nodes[order], np.ldexp(nodes, 40), np.ldexp(nodes, -60), nodes[:, ::-1].copy()):
        assert _distance(moved) == 4.0
    t = triangulate(nodes)
    assert limits_of_edges(t, tree_ends(t, spanning_tree(t))).max() == 8.0


def test_scan_lines_one_to_four() -> None:
    one, two = (read_surface(REPORTS / name) for name in ("scan_lines_1to4.xyz", "zero_scan.xyz"))
    for result in (compare(one, two), compare(two, one)):
        assert result.measures.area_compared == pytest.approx(36.0)
        assert result.measures.mean_abs == pytest.approx(1.0)
        assert sorted(result.max_edges) == [1.0, 2.0]


def test_nothing_common_names_the_limits_and_the_option() -> None:
    far = _lines(40.0, rows=4)
    one = Surface(np.column_stack((far, np.zeros(len(far)))), name="a.xyz", unit="mm")
    beside = far + np.array([0.5, 7.0])
    two = Surface(np.column_stack((beside, np.ones(len(far)))), name="b.xyz", unit="mm")
    with pytest.raises(InputError) as caught:
        compare(one, two)
    assert str(caught.value) == (
        "a.xyz and b.xyz: no common area to compare; over edges longer than 4 mm (a.xyz) and 4 mm "
        "(b.xyz) a cloud has no data, as derived from the spacing of the nodes (--max-edge says "
        "how long they may be)"
    )
    with pytest.raises(InputError, match=r"longer than 7.25 mm \(a.xyz\)") as caught:
        compare(one, two, max_edge=7.25)
    assert "derived" not in str(caught.value)
    apart = Surface(one.points + np.array([1e4, 0.0, 0.0]), name="c.xyz", unit="mm")
    with pytest.raises(InputError, match=r"no common area to compare$"):
        compare(one, apart, domain="hull")
    assert compare(one, two, max_edge=60.0).measures.mean_abs == pytest.approx(1.0)
