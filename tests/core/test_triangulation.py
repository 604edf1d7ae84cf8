"""T1 and T2: the unique Delaunay triangulation, whatever a library or a model says."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core.comparing.verification import check_half_edges
from surfcmp_core.errors import InputError
from surfcmp_core.grid import grid_of, safe_scale
from surfcmp_core.surface import Surface
from surfcmp_core.triangulation import Triangulation, is_flat, triangulate
from tests import pairs
from tests.core import oracles
from tests.core.node_sets import node_sets
from tests.invariants import check_delaunay, codes, ranks, same
from tests.pairs import FAMILIES, Nodes, distinct, pair_of

pytestmark = pytest.mark.plain

Triangles = NDArray[np.int32]


def _names(triangulation: Triangulation) -> NDArray[np.int64]:
    """Triangles by the lexicographic ranks of their nodes."""
    nodes = triangulation.nodes
    return np.sort(codes(triangulation.triangles, ranks(nodes), len(nodes)))


def _check_against_all_triples(nodes: Nodes) -> None:
    triangulation = triangulate(nodes)
    check_half_edges(triangulation)
    count = len(nodes)
    expected = np.array(sorted(oracles.delaunay(nodes)), np.int32)
    name = np.arange(count)
    same(codes(triangulation.triangles, name, count), codes(expected, name, count), "triangles")


@pytest.mark.parametrize("family", FAMILIES)
def test_triangles_are_those_with_empty_discs(family: str) -> None:
    for seed in range(6):
        pair = pair_of(family, seed, most=16)
        nodes = pair.first * safe_scale(pair.first)
        if len(nodes) <= 18:
            _check_against_all_triples(nodes)


@pytest.mark.parametrize("columns", [1, 2, 3, 5])
def test_lattices(columns: int) -> None:
    x, y = np.meshgrid(np.arange(columns), np.arange(3))
    nodes = np.column_stack((x.ravel(), y.ravel())).astype(np.float64)
    if columns == 1:
        nodes = np.concatenate((nodes, [[-5.0, 1.0]]))
    _check_against_all_triples(nodes)


@pytest.mark.parametrize("turn", [0, 1, 2])
def test_one_node_off_a_line(turn: int) -> None:
    run = np.column_stack((np.arange(8), np.zeros(8)))
    nodes = np.concatenate((run, [[3.5, 1e-9]]))
    if turn:
        nodes = nodes[:, ::-1] * [1.0, -1.0]
    if turn == 2:
        nodes = nodes @ np.array([[3.0, 4.0], [-4.0, 3.0]])
    _check_against_all_triples(nodes)


@pytest.mark.parametrize("seed", range(4))
def test_cocircular_ring(seed: int) -> None:
    ring = [(x, y) for x in range(-25, 26) for y in range(-25, 26) if x * x + y * y == 625]
    nodes = np.random.default_rng(seed).permutation(np.array(ring, np.float64))[: 12 + 2 * seed]
    _check_against_all_triples(nodes)
    _check_against_all_triples(np.concatenate((nodes, [[0.0, 0.0]])))


cell = st.tuples(st.integers(0, 4), st.integers(0, 4))


@given(st.lists(cell, min_size=3, max_size=9, unique=True), st.randoms(use_true_random=False))
def test_any_small_set_in_any_order(cells: list[tuple[int, int]], random: object) -> None:
    nodes = np.array(cells, np.float64)
    assume(not pairs.is_flat(nodes))
    _check_against_all_triples(nodes)
    order = list(range(len(nodes)))
    random.shuffle(order)  # type: ignore[attr-defined]
    assert np.array_equal(_names(triangulate(nodes)), _names(triangulate(nodes[order])))


@pytest.mark.parametrize("family", FAMILIES)
def test_larger_sets(family: str) -> None:
    for seed in range(3):
        pair = pair_of(family, seed, most=300)
        nodes = pair.second * safe_scale(pair.second)
        triangulation = triangulate(nodes)
        check_half_edges(triangulation)
        check_delaunay(triangulation, ties=100)
        shuffled = triangulate(np.random.default_rng(seed).permutation(nodes))
        assert np.array_equal(_names(triangulation), _names(shuffled))


@pytest.mark.parametrize("thin", [1e-8, 1e-10, 1e-14])
def test_strips_thinner_than_the_fast_library_stands(thin: float) -> None:
    rng = np.random.default_rng(7)
    for count in (4, 12, 60):
        nodes = rng.random((count, 2)) * [1.0, thin]
        triangulation = triangulate(nodes)
        check_half_edges(triangulation)
        check_delaunay(triangulation)


def test_an_edge_long_beyond_its_neighbours() -> None:
    """A fan: one node joined to all others."""
    nodes = np.concatenate(([[0.0, 1e6]], np.column_stack((np.arange(300), np.zeros(300)))))
    triangulation = triangulate(nodes)
    check_half_edges(triangulation)
    check_delaunay(triangulation)
    assert (triangulation.triangles == 0).any(axis=1).all()


@pytest.mark.parametrize(
    "nodes",
    [
        [[0.0, 0.0]],
        [[0.0, 0.0], [1.0, 1.0]],
        [[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]],
        [[0.0, 5.0], [0.0, 1.0], [0.0, -7.0], [0.0, 2.0]],
    ],
)
def test_nodes_on_one_line(nodes: list[list[float]]) -> None:
    assert is_flat(np.array(nodes))
    with pytest.raises(InputError, match=r"^scan\.ply: all nodes lie on one line in the plane$"):
        triangulate(np.array(nodes), name="scan.ply")


def test_nodes_on_one_line_but_for_the_last_bit() -> None:
    run = np.repeat(np.arange(1.0, 40.0)[:, None], 2, axis=1)
    assert is_flat(run)
    run[17, 0] = np.nextafter(18.0, 19.0)
    assert not is_flat(run)
    triangulation = triangulate(run)
    check_half_edges(triangulation)
    check_delaunay(triangulation)


# what a library or a model gives is never believed


def _flipped(triangulation: Triangulation, rng: np.random.Generator, flips: int) -> Triangles:
    """Flip edges of strictly convex quadrangles, one after another."""
    triangles = [tuple(t) for t in triangulation.triangles.tolist()]
    at = oracles.places(triangulation.nodes)
    for _ in range(flips):
        t = int(rng.integers(len(triangles)))
        a, b, c = triangles[t]
        for u, other in enumerate(triangles):
            if u != t and a in other and b in other:
                (d,) = set(other) - {a, b}
                convex = oracles.orientation(*at[a], *at[d], *at[c]) > 0
                if convex and oracles.orientation(*at[d], *at[b], *at[c]) > 0:
                    triangles[t], triangles[u] = (a, d, c), (d, b, c)
                break
    return np.array(triangles, np.int32)


@pytest.mark.parametrize("family", ["uniform", "lattice", "rings", "strip", "runs_parallel"])
def test_a_model_is_repaired(family: str, monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(5)
    for seed in range(6):
        nodes = pair_of(family, seed).first
        nodes = nodes * safe_scale(nodes)
        right = triangulate(nodes)
        model = _flipped(right, rng, 60)
        with monkeypatch.context() as patch:
            patch.setattr("triangular.delaunay", _never)
            repaired = triangulate(nodes, model=model)
        check_half_edges(repaired)
        assert np.array_equal(_names(repaired), _names(right))


def _never(nodes: Nodes) -> Triangles:
    raise AssertionError("the model covers the hull: nothing is to be triangulated")


def _without_one(model: Triangles) -> Triangles:
    return model[1:]


def _twice(model: Triangles) -> Triangles:
    return np.concatenate((model, model))


def _one_twice(model: Triangles) -> Triangles:
    return np.concatenate((model, model[:1]))


def _clockwise(model: Triangles) -> Triangles:
    return np.ascontiguousarray(model[:, ::-1])


def _one_clockwise(model: Triangles) -> Triangles:
    turned = model.copy()
    turned[0] = turned[0, ::-1]
    return turned


def _degenerate(model: Triangles) -> Triangles:
    flat = model.copy()
    flat[-1, 1] = flat[-1, 0]
    return flat


def _all_the_same(model: Triangles) -> Triangles:
    return np.repeat(model[:1], len(model), axis=0)


def _none(model: Triangles) -> Triangles:
    return model[:0]


def _noise(model: Triangles) -> Triangles:
    return np.random.default_rng(1).integers(0, model.max() + 1, model.shape).astype(np.int32)


SPOILT: list[Callable[[Triangles], Triangles]] = [
    _without_one,
    _twice,
    _one_twice,
    _clockwise,
    _one_clockwise,
    _degenerate,
    _all_the_same,
    _none,
    _noise,
]


@pytest.mark.parametrize("spoil", SPOILT, ids=lambda spoil: spoil.__name__[1:])
def test_a_model_that_does_not_cover_the_hull(spoil: Callable[[Triangles], Triangles]) -> None:
    nodes = np.random.default_rng(6).random((50, 2))
    right = triangulate(nodes)
    found = triangulate(nodes, model=spoil(right.triangles.copy()))
    check_half_edges(found)
    assert np.array_equal(_names(found), _names(right))


def test_a_model_that_leaves_a_node_out() -> None:
    nodes = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [1.0, 2.0]])
    model = np.array([[0, 1, 2], [0, 2, 3], [0, 1, 2]], np.int32)
    for some in (model, model[:2]):
        check_delaunay(triangulate(nodes, model=some))


def test_a_model_that_goes_round_twice() -> None:
    """A star-shaped fan over two turns: right counts and turns, yet it covers the hull twice."""
    angle = np.arange(10) * 4.0 * np.pi / 10.0 + 0.01 * np.arange(10)
    nodes = np.column_stack((np.cos(angle), np.sin(angle))) * np.linspace(1.0, 1.2, 10)[:, None]
    nodes = np.concatenate((nodes, [[0.0, 0.0]]))
    model = np.array([[10, k, (k + 1) % 10] for k in range(10)], np.int32)
    check_delaunay(triangulate(nodes, model=model))


@pytest.mark.parametrize("spoil", SPOILT, ids=lambda spoil: spoil.__name__[1:])
def test_a_library_is_not_believed(
    spoil: Callable[[Triangles], Triangles], monkeypatch: pytest.MonkeyPatch
) -> None:
    nodes = distinct(np.random.default_rng(8).integers(0, 7, (60, 2)).astype(np.float64))
    right = triangulate(nodes)
    monkeypatch.setattr("triangular.delaunay", lambda _: spoil(right.triangles.copy()))
    found = triangulate(nodes)
    check_half_edges(found)
    assert np.array_equal(_names(found), _names(right))


def test_all_libraries_lead_to_the_same_triangles() -> None:
    from pythoncdt import IntersectingConstraintEdges, VertexInsertionOrder
    from pythoncdt import Triangulation as Builder
    from scipy.spatial import Delaunay

    x, y = np.meshgrid(np.arange(9), np.arange(7))
    nodes = np.column_stack((x.ravel(), y.ravel())).astype(np.float64)
    right = triangulate(nodes)
    builder = Builder(VertexInsertionOrder.AUTO, IntersectingConstraintEdges.NOT_ALLOWED, 0.0)
    builder.insert_vertices(nodes)
    builder.erase_super_triangle()
    models = [
        np.array([triangle.vertices for triangle in builder.triangles], np.int32),
        Delaunay(nodes).simplices.astype(np.int32),
    ]
    for model in models:
        assert np.array_equal(_names(triangulate(nodes, model=model)), _names(right))


class _Builder:
    triangles: tuple[object, ...] = ()

    def __init__(self, *options: object) -> None: ...
    def insert_vertices(self, nodes: Nodes) -> None: ...
    def erase_super_triangle(self) -> None: ...


def test_where_no_library_helps(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("triangular.delaunay", lambda nodes: np.empty((0, 3), np.int32))
    monkeypatch.setattr("pythoncdt.Triangulation", _Builder)
    with pytest.raises(InputError, match=r"^scan: no library triangulates these nodes correctly$"):
        triangulate(np.random.default_rng(9).random((20, 2)), name="scan")


# sets that broke other triangulators

FOLDERS = [
    "CDT",
    "delaunator",
    "delaunator-cpp",
    "spade",
    "startin",
    "geos",
    "jts",
    "pcl",
    "earcut",
]


@pytest.mark.parametrize("folder", FOLDERS)
def test_sets_that_broke_other_triangulators(folder: str, shared: Path) -> None:
    path = shared / "fixtures" / folder
    if not path.is_dir():
        pytest.skip(f"{path} is absent")
    done = 0
    for name, nodes in node_sets(path).items():
        if len(distinct(nodes)) < 3:
            continue
        try:
            grid = grid_of(Surface(np.column_stack((nodes, np.zeros(len(nodes)))), name=name))
            if pairs.is_flat(grid.nodes):
                with pytest.raises(InputError, match="on one line"):
                    triangulate(grid.nodes, name=name)
                continue
            triangulation = triangulate(grid.nodes, name=name)
            check_half_edges(triangulation)
            check_delaunay(triangulation, ties=100)
        except AssertionError as error:
            error.add_note(name)
            raise
        done += 1
    assert done >= 2
