"""What must hold of every united triangulation, checked on one pair of grids at a time."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparing.verification import check_united
from surfcmp_core.grid import safe_scale
from surfcmp_core.spanning_tree import spanning_tree, tree_ends
from surfcmp_core.triangulation import Triangulation, triangulate
from surfcmp_core.united import United, unite
from tests.core import oracles
from tests.pairs import Nodes, Pair

Ints = NDArray[np.int64]


def shared_by_hand(first: Nodes, second: Nodes) -> NDArray[np.int32]:
    number = {tuple(row): k for k, row in enumerate(first.tolist())}
    return np.array([number.get(tuple(row), -1) for row in second.tolist()], np.int32)


@dataclass(frozen=True, slots=True, eq=False)
class Merged:
    """T as merged, and what it was merged from."""

    united: United
    first: Triangulation
    second: Triangulation


def merge(first: Nodes, second: Nodes) -> Merged:
    """Triangulate either grid and unite them, nodes in the order given."""
    scale = safe_scale(first, second)
    t1, t2 = triangulate(first * scale), triangulate(second * scale)
    partner = shared_by_hand(first, second)
    return Merged(unite(t1, t2, spanning_tree(t1), spanning_tree(t2), partner), t1, t2)


def ranks(nodes: Nodes) -> Ints:
    """Place of each of some distinct nodes in lexicographic order: a name without coordinates."""
    rank = np.empty(len(nodes), np.int64)
    rank[np.lexsort((nodes[:, 1], nodes[:, 0]))] = np.arange(len(nodes))
    return rank


def codes(triangles: NDArray[np.int32], name: Ints, count: int) -> Ints:
    """One number for each triangle: its nodes' names, the lowest first, in the sense given."""
    named = name[triangles]
    lowest = named.argmin(axis=1)
    rows = np.arange(len(named))
    a, b, c = (named[rows, (lowest + i) % 3] for i in range(3))
    return (a * count + b) * count + c


def same(a: Ints, b: Ints, what: str) -> None:
    a, b = np.sort(a), np.sort(b)
    assert np.array_equal(a, b), (
        f"{what}: {len(a)} against {len(b)}; {len(np.setdiff1d(a, b))} too many, "
        f"{len(np.setdiff1d(b, a))} missing"
    )


def check_delaunay(triangulation: Triangulation, *, ties: int = 1000) -> None:
    """Triangles cover the convex hull and every edge is Delaunay, exactly.

    Of edges between cocircular nodes so many are asked which of them is right.
    """
    t = triangulation
    x, y = oracles.exact(t.nodes).T
    a, b, c = t.triangles.T
    areas = oracles.orientation(x[a], y[a], x[b], y[b], x[c], y[c])
    assert (areas > 0).all()
    assert areas.sum() == oracles.hull_area(t.nodes)
    h = np.flatnonzero(t.twin[: 3 * t.real] < np.arange(3 * t.real))
    onward = np.where(h % 3 == 2, h - 2, h + 1)
    back = np.where(h % 3 == 0, h + 2, h - 1)
    k = t.twin[h]
    beyond = np.where(k % 3 == 0, k + 2, k - 1)
    four = [t.start[edge] for edge in (h, onward, back, beyond)]
    sides = oracles.in_circle(*(v for node in four for v in (x[node], y[node])))
    assert (sides <= 0).all()
    rng = np.random.default_rng(0)
    for row in rng.permutation(np.flatnonzero(sides == 0))[:ties]:
        assert not oracles.in_disc(*((x[node[row]], y[node[row]]) for node in four))


def check_triangles(merged: Merged, whole: NDArray[np.int32]) -> None:
    """T is the triangulation of the union, counter-clockwise, with the right provenance."""
    united = merged.united
    count = len(united.nodes)
    name = ranks(united.nodes)
    found = codes(united.triangles, name, count)
    same(found, codes(whole, name, count), "triangles of T")

    # Euler's formula; every directed edge once
    a, b = united.triangles.ravel(), united.triangles[:, [1, 2, 0]].ravel()
    there, back = a.astype(np.int64) * count + b, b.astype(np.int64) * count + a
    hull = 3 * len(found) - np.isin(there, back).sum()
    assert len(np.unique(there)) == len(there)
    assert len(found) == 2 * count - 2 - hull

    in_1 = codes(merged.first.triangles, name[united.node_1], count)
    in_2 = codes(merged.second.triangles, name[united.node_2], count)
    assert np.array_equal(united.origin, 1 * np.isin(found, in_1) + 2 * np.isin(found, in_2))
    labels = united.label[united.triangles]
    assert np.array_equal(united.chain >= 0, (labels == 1).any(axis=1) & (labels == 2).any(axis=1))
    # clouts and chains have no triangle in common and leave none out
    assert np.array_equal(united.chain >= 0, united.origin == 0)
    assert np.array_equal(united.representative, np.bitwise_or.reduce(labels, axis=1) == 3)


def check_chains(merged: Merged) -> None:
    """Chains are those found by hand, contiguous, each triangle the next one's neighbour."""
    united = merged.united
    triangles, label = united.triangles.tolist(), united.label.tolist()
    by_hand = {min(chain): (chain, closed) for chain, closed in oracles.chains(triangles, label)}
    inside = np.flatnonzero(united.chain >= 0)
    number = united.chain[inside]
    if len(inside) == 0:
        assert not by_hand
        assert len(united.chain_closed) == 0
        return
    starts = np.flatnonzero(np.diff(number, prepend=-1))
    # numbered from 0 in the order in which they stand, each in one run
    assert np.array_equal(number[starts], np.arange(len(united.chain_closed)))
    assert len(starts) == len(by_hand)
    assert np.array_equal(inside, np.arange(inside[0], len(united.chain)))
    ends = np.append(starts[1:], len(inside)) + inside[0]
    for k, (begin, end) in enumerate(
        zip((starts + inside[0]).tolist(), ends.tolist(), strict=True)
    ):
        chain, closed = by_hand[begin]
        assert chain == set(range(begin, end))
        assert bool(united.chain_closed[k]) == closed
        following = [*range(begin + 1, end), begin] if closed else range(begin + 1, end)
        for t, u in zip(range(begin, end), following, strict=False):
            edge = set(triangles[t]) & set(triangles[u])
            assert {label[v] for v in edge} == {1, 2}
            assert len(edge) == 2
        if not closed:
            for end_triangle in (begin, end - 1):
                _check_end(triangles, label, end_triangle)


def _check_end(triangles: list[list[int]], label: list[int], t: int) -> None:
    """An open chain ends on the hull or at a shared node."""
    corners = triangles[t]
    if any(label[v] == 3 for v in corners):
        return
    directed = {(u[i], u[(i + 1) % 3]) for u in triangles for i in range(3)}
    edges = [(corners[i], corners[(i + 1) % 3]) for i in range(3)]
    assert any({label[a], label[b]} == {1, 2} and (b, a) not in directed for a, b in edges)


def check_trees(merged: Merged) -> None:
    united = merged.united
    for tree, triangulation, node in (
        (united.tree1, merged.first, united.node_1),
        (united.tree2, merged.second, united.node_2),
    ):
        expected = node[tree_ends(triangulation, spanning_tree(triangulation))]
        assert np.array_equal(tree, expected)


@dataclass(frozen=True, slots=True, eq=False)
class Fingerprint:
    """All of T in terms of its nodes' lexicographic ranks: what must not change."""

    triangles: Ints
    label: NDArray[np.uint8]
    origin: NDArray[np.uint8]
    chain: Ints
    """Row of the first triangle, in order of `triangles`, of the same chain; -1 for none."""
    closed: NDArray[np.bool_]

    def agrees(self, other: "Fingerprint", *, exchanged: bool = False) -> None:
        """Compare, where `exchanged` with the roles of the grids exchanged."""
        swap = np.array([0, 2, 1, 3], np.uint8) if exchanged else np.arange(4, dtype=np.uint8)
        assert np.array_equal(self.triangles, other.triangles)
        assert np.array_equal(self.label, swap[other.label])
        assert np.array_equal(self.origin, swap[other.origin])
        assert np.array_equal(self.chain, other.chain)
        assert np.array_equal(self.closed, other.closed)


def fingerprint(united: United) -> Fingerprint:
    name = ranks(united.nodes)
    found = codes(united.triangles, name, len(united.nodes))
    order = np.argsort(found)
    chain = united.chain[order].astype(np.int64)
    first = np.full(len(united.chain_closed), -1, np.int64)
    rows = np.flatnonzero(chain >= 0)
    first[chain[rows[::-1]]] = rows[::-1]
    closed = np.zeros(len(chain), bool)
    closed[rows] = united.chain_closed[chain[rows]]
    chain[rows] = first[chain[rows]]
    return Fingerprint(
        found[order], united.label[np.argsort(name)], united.origin[order], chain, closed
    )


def check_pair(pair: Pair) -> Merged:
    """Check all that must hold of the merge of one pair."""
    merged = merge(pair.first, pair.second)
    check_united(merged.united, merged.first, merged.second)
    check_triangles(merged, triangulate(merged.united.nodes).triangles)
    check_chains(merged)
    check_trees(merged)
    return merged


def check_unchanged(pair: Pair, merged: Merged, rng: np.random.Generator) -> None:
    """Roles, the order of nodes, exact moves and powers of two change nothing."""
    before = fingerprint(merged.united)
    before.agrees(fingerprint(merge(pair.second, pair.first).united), exchanged=True)
    first, second = rng.permutation(pair.first), rng.permutation(pair.second)
    power = 2.0 ** int(rng.integers(-40, 40))
    first, second = first * power, second * power
    shift = np.asarray(rng.integers(-1000, 1000, 2) * power, np.float64)
    if _is_exact(first, shift) and _is_exact(second, shift):
        first, second = first + shift, second + shift
    before.agrees(fingerprint(merge(first, second).united))


def _is_exact(nodes: Nodes, shift: Nodes) -> bool:
    """Whether no sum is rounded (Knuth's error of a sum)."""
    total = nodes + shift
    virtual = total - nodes
    return not ((nodes - (total - virtual)) + (shift - virtual)).any()
