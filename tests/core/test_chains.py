"""Chains of interface triangles: known pictures, and the record of how they were traced."""

from collections import Counter
from collections.abc import Callable
from itertools import product

import numpy as np
import pytest
from numpy.typing import NDArray

from surfcmp_core.errors import Cancelled
from surfcmp_core.grid import box_of, grid_of, shared_nodes
from surfcmp_core.interface import Chains, Event, Joined, extract_chains, join
from surfcmp_core.spanning_tree import spanning_tree, tree_ends
from surfcmp_core.surface import Surface
from surfcmp_core.triangulation import triangulate
from surfcmp_core.united import United, unite
from tests.core import oracles
from tests.invariants import check_pair, merge
from tests.pairs import Nodes, Pair, pair_of

pytestmark = pytest.mark.plain


def _ring(count: int, radius: float, turn: float = 0.0) -> Nodes:
    angle = (np.arange(count) + turn) * 2.0 * np.pi / count
    return radius * np.column_stack((np.cos(angle), np.sin(angle)))


def _chains(first: Nodes, second: Nodes) -> list[bool]:
    """Check the pair and say of each chain whether it is closed, those first."""
    united = check_pair(Pair("by hand", first, second)).united
    return sorted(united.chain_closed.tolist(), reverse=True)


def _moved(nodes: Nodes, x: float, y: float) -> Nodes:
    return np.asarray(nodes + np.array([x, y]))


SQUARE = np.array([[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]])
SMALL = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])


def test_one_grid_within_the_other_has_one_closed_chain() -> None:
    assert _chains(_ring(12, 4.0), _ring(7, 1.0)) == [True]
    assert _chains(SQUARE, SMALL + 3.0) == [True]


def test_rings_within_rings_have_a_closed_chain_between_each_two() -> None:
    first = np.concatenate((_ring(40, 4.0), _ring(20, 2.0)))
    second = np.concatenate((_ring(30, 3.0, 0.3), _ring(9, 1.0, 0.1)))
    assert _chains(first, second) == [True] * 3


def test_grids_side_by_side_have_one_open_chain() -> None:
    assert _chains(SQUARE, _moved(SQUARE, 20.0, 1.0)) == [False]
    assert _chains(SQUARE, _moved(SQUARE, 0.0, 20.0)) == [False]
    assert _chains(SMALL, _moved(SMALL, 1e6, -3.0)) == [False]


def test_strips_that_alternate_have_open_chains_between_them() -> None:
    row = np.column_stack((np.arange(30.0), np.zeros(30)))
    first = np.concatenate([_moved(row, 0.0, 10.0 * k) for k in (0, 2, 4)])
    second = np.concatenate([_moved(row, 0.0, 10.0 * k) for k in (1, 3)])
    assert _chains(first, second) == [False] * 4


def test_islands_have_a_chain_each() -> None:
    x, y = np.meshgrid(np.arange(40.0), np.arange(40.0))
    sea = np.column_stack((x.ravel(), y.ravel()))
    islands = np.array([[7.0, 7.0], [30.0, 9.0], [12.0, 31.0], [33.0, 33.0]])
    near = np.hypot(*(sea[:, None, :] - islands).T).min(axis=0) < 3.5
    blocks = [SMALL + island - 0.3 for island in islands]
    assert _chains(sea[~near], np.concatenate(blocks)) == [True] * 4


def test_a_chain_ends_at_shared_nodes() -> None:
    # both grids have the outer square; each has its own half of the inside
    first = np.concatenate((SQUARE, [[2.0, 3.0], [2.0, 5.0], [2.5, 4.0]]))
    second = np.concatenate((SQUARE, [[6.0, 3.0], [6.0, 5.0], [5.5, 4.0]]))
    assert _chains(first, second) == [False]


def test_equal_grids_and_subsets_have_no_chain() -> None:
    first = np.random.default_rng(1).random((50, 2))
    assert _chains(first, first) == []
    assert _chains(first, first[:20]) == []
    assert _chains(first[:20], first) == []
    united = merge(first, first[:20]).united
    assert set(united.label.tolist()) == {1, 3}
    assert (united.origin & 1 == 1).all()


def _united_of_surfaces(first: Nodes, second: Nodes, progress: object = None) -> United:
    surfaces = [Surface(np.column_stack((nodes, nodes[:, 0]))) for nodes in (first, second)]
    box = box_of(*surfaces)
    grids = [grid_of(surface, box=box) for surface in surfaces]
    t1, t2 = (triangulate(grid.nodes) for grid in grids)
    trees = spanning_tree(t1), spanning_tree(t2)
    return unite(t1, t2, *trees, shared_nodes(*grids), progress)  # type: ignore[arg-type]


@pytest.mark.large
def test_tracing_many_triangles_tells_how_far_it_is_and_can_be_stopped() -> None:
    rng = np.random.default_rng(2)
    first, second = rng.random((2, 120_000, 2))
    told: list[float] = []
    united = _united_of_surfaces(first, second, told.append)
    assert told
    assert told == sorted(told)
    assert 0.0 < told[0] <= told[-1] <= 1.0
    assert (united.chain >= 0).sum() > 200_000

    def stop(share: float) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        _united_of_surfaces(first, second, stop)
    again = _united_of_surfaces(first, second)
    assert np.array_equal(united.triangles, again.triangles)


# the record

Edges = set[tuple[int, int]]


def _edges(triangles: NDArray[np.int32]) -> Edges:
    corners = np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)])
    return {(a, b) for a, b in np.sort(corners, axis=1).tolist()}


def _edge(a: int, b: int) -> tuple[int, int]:
    return (a, b) if a < b else (b, a)


def _recorded(pair: Pair) -> tuple[Joined, Chains]:
    t1, t2 = triangulate(pair.first), triangulate(pair.second)
    joined = join(t1, t2, spanning_tree(t1), spanning_tree(t2))
    return joined, extract_chains(joined, record=True)


FAMILIES = ["uniform", "clusters_apart", "nested", "half_cell", "rings", "combs", "apart"]


def _without_shared(family: str, seed: int) -> Pair | None:
    pair = pair_of(family, seed)
    both = {tuple(node) for node in pair.first.tolist()}
    scale = np.abs(pair.first).max()
    if any(tuple(node) in both for node in pair.second.tolist()) or not 1e-9 < scale < 1e12:
        return None
    return pair


@pytest.mark.parametrize("family", FAMILIES)
def test_record_tells_what_tracing_does(family: str) -> None:
    asked = 0
    for seed in range(12):
        pair = _without_shared(family, seed)
        if pair is None:
            continue
        asked += 1
        t1, t2 = triangulate(pair.first), triangulate(pair.second)
        trees = spanning_tree(t1), spanning_tree(t2)
        chains = extract_chains(join(t1, t2, *trees), record=True)
        silent = extract_chains(join(t1, t2, *trees))
        assert len(silent.events) == 0
        for field in ("base", "apex", "first", "closed"):
            assert np.array_equal(getattr(chains, field), getattr(silent, field))
        _check_record(chains, pair)
    assert asked >= 3


def _check_record(chains: Chains, pair: Pair) -> None:
    n1 = len(pair.first)
    nodes = np.concatenate((pair.first, pair.second))
    t1, t2 = triangulate(pair.first), triangulate(pair.second)
    tree_1, tree_2 = (tree_ends(t, spanning_tree(t)) for t in (t1, t2))
    tree = {_edge(a, b) for a, b in np.concatenate((tree_1, tree_2 + n1)).tolist()}
    of_grids = _edges(t1.triangles) | _edges(t2.triangles + np.int32(n1))
    whole = _edges(triangulate(nodes).triangles)

    count = Counter(Event(kind) for kind in chains.events[:, 0])
    events = {kind: chains.events[chains.events[:, 0] == kind, 1:3] for kind in Event}
    assert (np.diff(chains.events[:, 3]) >= 0).all()
    assert np.array_equal(events[Event.TRIANGLE][:, 0], np.arange(len(chains.base)))
    # either side of an open chain ends on the hull
    assert count[Event.STARTER] == len(chains.closed)
    assert count[Event.CHAIN_CLOSED] == chains.closed.sum()
    assert count[Event.CHAIN_ENDED] == 2 * (~chains.closed).sum()
    assert np.array_equal(events[Event.CHAIN_CLOSED][:, 0], np.flatnonzero(chains.closed))
    for a, b in events[Event.STARTER].tolist():
        assert (a < n1) != (b < n1)
        assert _edge(a, b) in whole
    # what is passed is what T does not have, at most once from either end, and once more where a
    # chain closes over its starter's fan
    passed = [(a, b) for a, b in events[Event.EDGE_PASSED].tolist() if b >= 0]
    assert {_edge(a, b) for a, b in passed} == of_grids - whole
    twice = [a for (a, _), times in Counter(passed).items() if times > 1]
    assert set(twice) <= set(events[Event.STARTER].ravel().tolist())
    assert max(Counter(passed).values(), default=1) <= 2
    bridges = {_edge(a, b) for a, b in events[Event.BRIDGE].tolist()}
    assert bridges == tree - whole
    # every bridge is looked at: its free node has been traced meanwhile, or a chain begins there
    taken = events[Event.BRIDGE_TAKEN], events[Event.BRIDGE_DONE]
    assert {_edge(a, b) for a, b in np.concatenate(taken).tolist()} == bridges
    assert count[Event.BRIDGE_TAKEN] == max(0, len(chains.closed) - 1)
    for kind in (Event.CIRCLE, Event.BRIDGE, Event.BRIDGE_TAKEN, Event.BRIDGE_DONE):
        assert (events[kind] < len(nodes)).all()


def test_next_starter_is_the_smallest_circle_on_its_bridge() -> None:
    asked = 0
    for family, seed in product(FAMILIES, range(12)):
        pair = _without_shared(family, seed)
        if pair is None:
            continue
        _, chains = _recorded(pair)
        nodes = oracles.exact(np.concatenate((pair.first, pair.second)))
        events = chains.events.tolist()
        taken = [k for k, event in enumerate(events) if event[0] == Event.BRIDGE_TAKEN]
        for k in taken:
            v, u = events[k][1:3]
            starter = next(event for event in events[k:] if event[0] == Event.STARTER)
            assert v in starter[1:3]
            d = starter[1] if starter[2] == v else starter[2]
            others = nodes[len(pair.first) :] if v < len(pair.first) else nodes[: len(pair.first)]
            ahead = others[((others - nodes[v]) * (nodes[u] - nodes[v])).sum(axis=1) > 0]
            smaller = oracles.compare_tangent_circles(*nodes[v], *nodes[u], *nodes[d], *ahead.T)
            assert (smaller <= 0).all()
            asked += 1
    assert asked > 100


def _star(count: int) -> Pair:
    """Nodes of either grid in turn around one of them, which all of the others see."""
    angle = np.linspace(0.0, 2.0 * np.pi, 2 * count, endpoint=False)
    ring = np.column_stack((np.cos(angle), np.sin(angle)))
    ring *= 1.0 + 0.01 / count * np.random.default_rng(count).random((2 * count, 1))
    return Pair("star", ring[::2], np.concatenate((ring[1::2], 1.5 * ring[1::2], [[1e-3, 2e-3]])))


@pytest.mark.large
@pytest.mark.parametrize(
    "pair_of_size",
    [lambda n: Pair("uniform", *np.random.default_rng(3).random((2, n, 2))), _star],
    ids=["uniform", "star"],
)
def test_work_grows_as_the_nodes(pair_of_size: Callable[[int], Pair]) -> None:
    for_each = []
    for n in (500, 1000, 2000, 4000, 8000):
        _, chains = _recorded(pair_of_size(n))
        for_each.append(chains.events[-1, 3] / n)
    assert max(for_each) < 1.2 * for_each[0]
