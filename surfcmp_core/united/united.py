"""The united triangulation with provenance and chains."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.interface import Chains, Joined, extract_chains, join
from surfcmp_core.interface.joined import MARKS, PASSED, WORDS, following
from surfcmp_core.spanning_tree import spanning_tree, tree_ends
from surfcmp_core.triangulation import Triangulation, is_flat, triangulate
from surfcmp_core.triangulation.half_edges import half_edges
from surfcmp_core.united.follow import follow_chains


@dataclass(frozen=True, slots=True, eq=False)
class United:
    """The Delaunay triangulation T of both grids (paper: the general triangulation).

    Attributes
    ----------
    nodes : (N, 2) float64
        All nodes of grid 1, then those of grid 2 that are not shared.
    label : (N,) uint8
        1: node of G1 alone, 2: of G2 alone, 3: shared.
    node_1, node_2 : (n1,), (n2,) int32
        Number in `nodes` of each node of grid 1 and of grid 2.
    triangles : (M, 3) int32
        Counter-clockwise; triangles of one chain stand together, in the order of the chain.
    origin : (M,) uint8
        Bit 1: triangle of T1, bit 2: of T2, 0: of neither.
    chain : (M,) int32
        Number of its chain, -1 for none.
    chain_closed : (C,) bool
        Whether the chain returns to its first triangle; an open one ends on the hull of T
        or at shared nodes.
    tree1, tree2 : (n1 - 1, 2), (n2 - 1, 2) int32
        Minimum spanning trees of T1 and T2, in numbers of `nodes`.
    """

    nodes: NDArray[np.float64]
    label: NDArray[np.uint8]
    node_1: NDArray[np.int32]
    node_2: NDArray[np.int32]
    triangles: NDArray[np.int32]
    origin: NDArray[np.uint8]
    chain: NDArray[np.int32]
    chain_closed: NDArray[np.bool_]
    tree1: NDArray[np.int32]
    tree2: NDArray[np.int32]

    @property
    def representative(self) -> NDArray[np.bool_]:
        """(M,) bool: triangles whose nodes include one of G1 and one of G2 (formula (3))."""
        a, b, c = (self.label[self.triangles[:, i]] for i in range(3))
        return np.asarray((a | b | c) == 3)


@kernel
def _assemble(
    words: NDArray[np.int32],
    base: NDArray[np.int32],
    apex: NDArray[np.int32],
    triangles: NDArray[np.int32],
) -> int:
    """Write the clouts' triangles, then the chains'; return the number of the former."""
    count = 0
    last = triangles.shape[0] - 1
    for h in range(0, words.size, WORDS):  # without a branch, which nothing could foretell
        place = min(count, last)
        triangles[place, 0] = words[h]
        triangles[place, 1] = words[h + 1]
        triangles[place, 2] = words[h + 2]
        count += (words[h + MARKS] & PASSED == 0) & (words[h + 2] >= 0)
    for k in range(base.size):
        triangles[count + k, 0] = words[base[k]]
        triangles[count + k, 1] = words[following(base[k])]
        triangles[count + k, 2] = apex[k]
    return count


@kernel
def _origins(
    triangles: NDArray[np.int32], label: NDArray[np.uint8], origin: NDArray[np.uint8]
) -> None:
    # an empty disc of T is empty of each grid: all nodes in one grid make it a triangle there
    for t in range(len(triangles)):
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        origin[t] = label[a] & label[b] & label[c]


def _merged(joined: Joined, chains: Chains) -> tuple[NDArray[np.int32], int]:
    """List the triangles of T in the numbers of `joined`, and count the clouts'."""
    triangles = np.empty((2 * len(joined.nodes), 3), np.int32)
    clouts = _assemble(joined.words, chains.base, chains.apex, triangles)
    return triangles[: clouts + len(chains.base)], clouts


def _merge_apart(
    first: Triangulation,
    second: Triangulation,
    progress: Callable[[float], None] | None,
    tree_1: NDArray[np.int32] | None = None,
    tree_2: NDArray[np.int32] | None = None,
) -> tuple[NDArray[np.int32], int, Chains]:
    """Merge triangulations that have no common node."""
    joined = join(
        first,
        second,
        spanning_tree(first) if tree_1 is None else tree_1,
        spanning_tree(second) if tree_2 is None else tree_2,
    )
    chains = extract_chains(joined, progress)
    return *_merged(joined, chains), chains


def _merge_shared(
    first: Triangulation,
    second: Triangulation,
    partner: NDArray[np.int32],
    nodes: NDArray[np.float64],
    node_2: NDArray[np.int32],
    progress: Callable[[float], None] | None,
) -> NDArray[np.int32]:
    """List the triangles of T where grids have common nodes; those count to one grid only.

    T is then merged from that grid's triangulation and the one of the rest of the other grid.
    """
    n1 = len(first.nodes)
    alone_2 = partner < 0
    if not alone_2.any():
        return first.triangles
    alone_1 = np.ones(n1, bool)
    alone_1[partner[~alone_2]] = False
    if not alone_1.any():
        return node_2[second.triangles]
    rest_2 = second.nodes[alone_2]
    if not is_flat(rest_2):
        return _merge_apart(first, triangulate(rest_2), progress)[0]
    rest_1 = first.nodes[alone_1]
    if not is_flat(rest_1):
        numbers = np.concatenate((np.flatnonzero(alone_1).astype(np.int32), node_2))
        return numbers[_merge_apart(triangulate(rest_1), second, progress)[0]]
    # hardly anything is left of either grid, so there is nothing to merge
    return triangulate(nodes).triangles


def unite(
    first: Triangulation,
    second: Triangulation,
    tree_1: NDArray[np.int32],
    tree_2: NDArray[np.int32],
    partner: NDArray[np.int32],
    progress: Callable[[float], None] | None = None,
) -> United:
    """Merge two Delaunay triangulations into the united one, in linear time.

    Parameters
    ----------
    first, second : Triangulation
        T1 and T2.
    tree_1, tree_2 : (n - 1,) int32
        Half-edges of their minimum spanning trees.
    partner : (n2,) int32
        Node of grid 1 equal to each node of grid 2, -1 where there is none.
    progress : callable, optional
        Called now and then with the share done; may raise to cancel.

    Returns
    -------
    United

    References
    ----------
    Section 3.1 of the paper.
    """
    n1 = len(first.nodes)
    alone_2 = partner < 0
    fresh = int(alone_2.sum())
    nodes = np.concatenate((first.nodes, second.nodes[alone_2]))
    node_1 = np.arange(n1, dtype=np.int32)
    node_2 = partner.copy()
    node_2[alone_2] = np.arange(n1, n1 + fresh, dtype=np.int32)
    label = np.full(n1 + fresh, 2, np.uint8)
    label[:n1] = 1
    label[partner[~alone_2]] = 3

    if fresh == len(partner):
        triangles, clouts, chains = _merge_apart(first, second, progress, tree_1, tree_2)
        lengths, closed = np.diff(chains.first), chains.closed
    else:
        triangles = _merge_shared(first, second, partner, nodes, node_2, progress)
        edges = half_edges(triangles, len(nodes))
        assert edges is not None, "a merged triangulation has a simple border"
        whole = Triangulation(nodes, *edges, len(triangles))
        order, starts, closed = follow_chains(whole, label)
        rest = np.ones(whole.real, bool)
        rest[order] = False
        clouts = whole.real - len(order)
        triangles = np.concatenate((whole.triangles[rest], whole.triangles[order]))
        lengths = np.diff(starts)

    origin = np.empty(len(triangles), np.uint8)
    _origins(triangles, label, origin)
    chain = np.full(len(triangles), -1, np.int32)
    chain[clouts:] = np.repeat(np.arange(len(closed), dtype=np.int32), lengths)
    return United(
        nodes,
        label,
        node_1,
        node_2,
        triangles,
        origin,
        chain,
        closed,
        tree_ends(first, tree_1),
        node_2[tree_ends(second, tree_2)],
    )
