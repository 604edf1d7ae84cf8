"""Grids: distinct nodes, their order, and the range in which predicates are exact."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core.comparing.request import compare
from surfcmp_core.errors import InputError
from surfcmp_core.grid import Grid, box_of, grid_of, safe_scale
from surfcmp_core.surface import Duplicates, Surface
from tests.pairs import distinct

pytestmark = pytest.mark.plain


def _surface(points: object, faces: object = None, name: str = "scan") -> Surface:
    return Surface(
        np.asarray(points, np.float64).reshape(-1, 3),
        None if faces is None else np.asarray(faces, np.int32),
        name,
    )


def _check(grid: Grid, surface: Surface) -> None:
    """Nodes are the surface's, each place once, along the curve."""
    points = surface.points
    assert np.array_equal(grid.nodes, points[grid.source, :2])
    assert len(distinct(grid.nodes)) == len(grid.nodes) == len(distinct(points[:, :2]))
    assert grid.merged == len(points) - len(grid.nodes)
    assert (np.diff(grid.keys.astype(object)) >= 0).all()
    same_key = np.diff(grid.keys.astype(object)) == 0
    steps = np.diff(grid.nodes, axis=0)[same_key]
    assert ((steps[:, 0] > 0.0) | ((steps[:, 0] == 0.0) & (steps[:, 1] > 0.0))).all()


cell = st.integers(-4, 4)


@given(st.lists(st.tuples(cell, cell), min_size=3, max_size=40))
def test_a_grid_has_each_place_once(cells: list[tuple[int, int]]) -> None:
    nodes = np.array(cells, np.float64)
    surface = _surface(np.column_stack((nodes, nodes @ [2.0, -1.0])))
    if len(set(cells)) < 3:
        with pytest.raises(InputError, match=f"^scan: {len(set(cells))} distinct nodes; at least"):
            grid_of(surface)
        return
    grid = grid_of(surface)
    _check(grid, surface)
    assert np.array_equal(grid.z, grid.nodes @ [2.0, -1.0])


def test_order_of_nodes_does_not_matter() -> None:
    rng = np.random.default_rng(1)
    for scale in (1.0, 1e-3, 1e9):
        points = rng.normal(size=(500, 3)) * scale
        points[:50, :2] = points[50:100, :2] + 1e-12 * scale  # several nodes of one key
        one, other = grid_of(_surface(points)), grid_of(_surface(rng.permutation(points)))
        _check(one, _surface(points))
        assert np.array_equal(one.nodes, other.nodes)
        assert np.array_equal(one.z, other.z)
        assert np.array_equal(one.keys, other.keys)


def test_neighbours_along_the_curve_are_neighbours_in_the_plane() -> None:
    side = 64
    x, y = np.meshgrid(np.arange(side), np.arange(side))
    points = np.column_stack((x.ravel(), y.ravel(), x.ravel())).astype(np.float64)
    grid = grid_of(_surface(points), box=(0.0, 0.0, side - 0.001, side - 0.001))
    assert np.abs(np.diff(grid.nodes, axis=0)).sum(axis=1).max() == 1.0


def test_negative_zero_equals_zero() -> None:
    surface = _surface([[-0.0, 0.0, 1.0], [0.0, -0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]])
    grid = grid_of(surface)
    assert (len(grid.nodes), grid.merged) == (3, 1)


TORN = [[0.0, 0.0, 1.0], [1.0, 0.0, 5.0], [0.0, 1.0, 2.0], [0.0, 0.0, 4.0], [0.0, 0.0, 4.0]]


def test_two_values_at_one_place_are_refused_unless_told_otherwise() -> None:
    with pytest.raises(InputError, match=r"^scan: not one-valued: 1 places .*--duplicates"):
        grid_of(_surface(TORN))
    values: list[tuple[Duplicates, float]] = [("mean", 3.0), ("max", 4.0), ("min", 1.0)]
    for how, value in values:
        grid = grid_of(_surface(TORN), duplicates=how)
        _check(grid, _surface(TORN))
        at = (grid.nodes == 0.0).all(axis=1)
        assert grid.z[at] == value
        assert sorted(grid.z[~at]) == [2.0, 5.0]
        assert grid.source[at] == 0


def test_equal_nodes_are_merged_without_asking_and_without_rounding() -> None:
    points = [[0.0, 0.0, 0.1], [1.0, 0.0, 0.7], [0.0, 1.0, 0.3], *[[1.0, 0.0, 0.7]] * 3]
    choices: list[Duplicates] = ["refuse", "mean", "max", "min"]
    for how in choices:
        grid = grid_of(_surface(points), duplicates=how)
        assert grid.merged == 3
        assert sorted(grid.z) == [0.1, 0.3, 0.7]


def test_faces_keep_their_corners() -> None:
    rng = np.random.default_rng(2)
    points = rng.integers(0, 6, (40, 3)).astype(np.float64)
    points[:, 2] = points[:, 0] - points[:, 1]
    faces = rng.integers(0, 40, (30, 3)).astype(np.int32)
    grid = grid_of(_surface(points, faces))
    assert grid.faces is not None
    assert grid.faces.dtype == np.int32
    corners = points[faces][:, :, :2]
    lines = [(a == b).all() or (b == c).all() or (c == a).all() for a, b, c in corners]
    assert 0 < sum(lines) < 30
    kept: dict[tuple[tuple[float, ...], ...], NDArray[np.float64]] = {}
    for triangle in corners[~np.array(lines)]:  # of equal ones the first stays
        kept.setdefault(tuple(sorted(map(tuple, triangle.tolist()))), triangle)
    assert 0 < len(kept) < 30 - sum(lines)
    assert np.array_equal(grid.nodes[grid.faces], list(kept.values()))
    assert grid_of(_surface(points)).faces is None


@pytest.mark.parametrize("count", [0, 1, 2])
def test_fewer_than_three_nodes(count: int) -> None:
    with pytest.raises(InputError, match=f"^scan: {count} nodes; at least 3 are needed$"):
        grid_of(_surface(np.eye(3)[:count]))


def test_box_of_all_nodes() -> None:
    a, b = _surface([[0.0, 5.0, 9.0], [1.0, 2.0, 9.0]]), _surface([[-3.0, 3.0, 9.0]])
    assert box_of(a, b) == (-3.0, 2.0, 1.0, 5.0)


# the range of the predicates


def _is_safe(nodes: NDArray[np.float64]) -> bool:
    """Whether all is below 2^250 and a multiple of 2^-240."""
    unit = 2.0**-240
    return bool((np.abs(nodes) < 2.0**250).all() and (np.fmod(nodes, unit) == 0.0).all())


@pytest.mark.parametrize(
    "nodes",
    [
        [[0.0, 0.0]],
        [[1.0, -3.0], [1e9, 0.1]],
        [[2.0**249 * 1.9, 2.0**-187]],
        [[np.nextafter(2.0**250, 0.0), 1.0]],
    ],
)
def test_what_is_in_range_is_left_alone(nodes: list[list[float]]) -> None:
    assert safe_scale(np.array(nodes)) == 1.0
    assert _is_safe(np.array(nodes))


@pytest.mark.parametrize(
    "nodes",
    [
        [[1e100, -3e99]],
        [[1e-100, 3e-101]],
        [[1e300, 1e290]],
        [[1e-220, 5e-222]],
        [[2.0**250, 1.0]],
        [[2.0**200, 2.0**-200]],
        [[1.0, 2.0**-189 * 1.7]],
        [[1.7e308, 1e200]],
        [[2.0**-700, 2.0**-749]],
    ],
)
def test_what_is_out_of_range_is_brought_in_exactly(nodes: list[list[float]]) -> None:
    array = np.array(nodes)
    scale = safe_scale(array)
    assert np.frexp(scale)[0] == 0.5
    assert scale != 1.0
    assert _is_safe(array * scale)
    assert np.array_equal(array * scale / scale, array)
    # both grids together
    assert safe_scale(array[:, :1], array[:, 1:]) == scale


@pytest.mark.parametrize("small", [1e-100, 5e-324, 2.0**-200])
def test_what_spans_too_much_is_refused(small: float) -> None:
    with pytest.raises(InputError, match=r"span too many magnitudes .*: 2\^-\d+ to 2\^\d+$"):
        safe_scale(np.array([[1e100, 0.0]]), np.array([[0.0, small]]))


def _check_any(x: float, y: float) -> None:
    nodes = np.array([[x, y]])
    try:
        scale = safe_scale(nodes)
    except InputError:
        powers = np.frexp(nodes[nodes != 0.0])[1]
        assert powers.max() - powers.min() > 430 or powers.max() < -700
        return
    assert np.isfinite(scale)
    assert _is_safe(nodes * scale)


@given(st.floats(-1e307, 1e307), st.floats(-1e307, 1e307))
def test_any_input_is_made_safe_or_refused(x: float, y: float) -> None:
    assume(max(abs(x), abs(y)) > 1e-220)
    _check_any(x, y)


@given(st.floats(-1e-230, 1e-230), st.floats(-1e-230, 1e-230))
def test_tiny_input_is_made_safe_or_refused(x: float, y: float) -> None:
    _check_any(x, y)


def test_upright_faces_are_left_out() -> None:
    corners = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0], [4, 0, 2]]
    faces = np.array([[0, 1, 2], [0, 2, 3], [1, 4, 2]], np.int32)
    box = Surface(np.array(corners, np.float64), faces, name="box", unit="mm")
    found = grid_of(box, duplicates="max").faces
    assert found is not None
    assert len(found) == 2
    assert compare(box, box, duplicates="max", threads=1).measures.mean_abs == 0.0


def test_one_node_far_away_does_not_cost_the_square_of_the_others() -> None:
    nodes = np.random.default_rng(4).random((200_000, 2))
    nodes[7] = [1e12, 1e12]
    nodes[11] = nodes[9]
    grid = grid_of(_surface(np.column_stack((nodes, np.zeros(len(nodes))))))
    assert (len(grid.nodes), grid.merged) == (199_999, 1)
    tied = np.flatnonzero(np.diff(grid.keys) == 0)
    assert len(tied) > 100_000
    x, y = grid.nodes.T
    assert ((x[tied] < x[tied + 1]) | ((x[tied] == x[tied + 1]) & (y[tied] < y[tied + 1]))).all()
