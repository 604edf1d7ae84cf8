"""Whether T is the Delaunay triangulation of both grids, made of T1, T2 and the chains."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparing.verification.check_chains import check_chains
from surfcmp_core.comparing.verification.holds import hold
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import half_edges
from surfcmp_core.triangulation.lawson import is_triangulation, make_delaunay
from surfcmp_core.united import United


def check_united(united: United, first: Triangulation, second: Triangulation) -> None:
    """Check all that must hold of T, T1, T2, their spanning trees and the chains.

    Parameters
    ----------
    united : United
        T.
    first, second : Triangulation
        T1 and T2; their coordinates and T's are those on which predicates are exact.

    Raises
    ------
    Violation
    """
    for name, t in (("T1", first), ("T2", second)):
        check_half_edges(t)
        hold(is_triangulation(t.nodes, t.start, t.twin, t.real), f"{name} is no triangulation")
        flips = make_delaunay(t.nodes, t.start.copy(), t.twin.copy(), t.real)
        hold(flips == 0, f"{flips} edges of {name} are not Delaunay")
    check_nodes(united, first, second)
    edges = half_edges(united.triangles, len(united.nodes))
    real = len(united.triangles)
    hold(
        edges is not None and is_triangulation(united.nodes, *edges, real),
        "T is no triangulation of all nodes",
    )
    assert edges is not None
    flips = make_delaunay(united.nodes, *edges, real)
    hold(flips == 0, f"{flips} edges of T are not Delaunay")
    _check_origin(united, first, second)
    check_chains(united)
    for tree, own, t in (
        (united.tree1, united.node_1, first),
        (united.tree2, united.node_2, second),
    ):
        _check_tree(tree, own, t)


def check_half_edges(triangulation: Triangulation) -> None:
    """Check that twins are mutual, triangles close, and the ghosts close the hull once.

    Raises
    ------
    Violation
    """
    t = triangulation
    start, twin, real = t.start, t.twin, t.real
    h = np.arange(len(start))
    onward = np.where(h % 3 == 2, h - 2, h + 1)
    hold(start.dtype == twin.dtype == np.int32, "half-edges are not int32")
    hold(
        start.shape == twin.shape == (3 * (len(start) // 3),)
        and np.array_equal(twin[twin], h)
        and (twin // 3 != h // 3).all()
        and np.array_equal(start[twin], start[onward]),
        "half-edges and their twins do not fit",
    )
    hold(
        np.array_equal(np.unique(start[: 3 * real]), np.arange(len(t.nodes))),
        "a node is in no triangle",
    )
    ghosts = start[3 * real :].reshape(-1, 3)
    hold(
        (ghosts[:, 2] == -1).all()
        and (ghosts[:, :2] >= 0).all()
        and (twin[3 * real :: 3] < 3 * real).all()
        and (twin[: 3 * real] % 3 == 0)[twin[: 3 * real] >= 3 * real].all(),
        "a ghost lies beyond no edge of the hull",
    )
    hold(real == 2 * len(t.nodes) - 2 - len(ghosts), "Euler's formula does not hold")
    order = [real]  # from each ghost to that of the next hull edge counter-clockwise
    while (following := int(twin[3 * order[-1] + 2]) // 3) > real and len(order) < len(ghosts):
        order.append(following)
    around = ghosts[np.array(order) - real]
    hold(
        following == real
        and len(set(order)) == len(ghosts)
        and np.array_equal(around[:, 0], np.roll(around[:, 1], -1)),
        "the ghosts do not close the hull",
    )


def check_nodes(united: United, first: Triangulation, second: Triangulation) -> None:
    """Check that every node is there once, under its label, at its place.

    Raises
    ------
    Violation
    """
    hold(
        np.array_equal(united.nodes[united.node_1], first.nodes)
        and np.array_equal(united.nodes[united.node_2], second.nodes),
        "a node of T is not where it is in its grid",
    )
    label = np.zeros(len(united.nodes), np.uint8)
    label[united.node_1] |= 1
    label[united.node_2] |= 2
    hold(np.array_equal(label, united.label), "a node of T has the wrong label")
    order = np.lexsort((united.nodes[:, 1], united.nodes[:, 0]))
    hold(
        (united.nodes[order][1:] != united.nodes[order][:-1]).any(axis=1).all(),
        "T has two nodes at one place",
    )


def _named(
    triangles: NDArray[np.int32], name: NDArray[np.int32], count: int
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Name each triangle by its lowest edge, which it alone has on its left, and its third node."""
    named = name[triangles].astype(np.int64)
    lowest = named.argmin(axis=1)
    rows = np.arange(len(named))
    a, b, c = (named[rows, (lowest + i) % 3] for i in range(3))
    return a * count + b, c


def _check_origin(united: United, first: Triangulation, second: Triangulation) -> None:
    """Check that T is the triangles of T1 and T2 that are said to stay, and the chains."""
    count = len(united.nodes)
    edge, third = _named(united.triangles, np.arange(count, dtype=np.int32), count)
    for bit, own, t in ((1, united.node_1, first), (2, united.node_2, second)):
        at, beyond = _named(t.triangles, own, count)
        order = np.argsort(at)
        found = order[np.minimum(np.searchsorted(at[order], edge), len(order) - 1)]
        there = (at[found] == edge) & (beyond[found] == third)
        hold(np.array_equal(united.origin & bit > 0, there), f"a triangle is not of T{bit} as said")
    hold(
        np.array_equal(united.origin == 0, united.chain >= 0),
        "T is not made of triangles of T1 and T2 and the chains",
    )


def _check_tree(
    tree: NDArray[np.int32], own: NDArray[np.int32], triangulation: Triangulation
) -> None:
    """Check that a tree spans its grid along edges of its triangulation, and none is shorter."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components, minimum_spanning_tree

    t, count = triangulation, len(triangulation.nodes)
    number = np.full(int(max(own.max(), tree.max())) + 1, -1, np.int64)
    number[own] = np.arange(count)
    a, b = number[tree].T
    start, onward = t.triangles, t.triangles[:, [1, 2, 0]]
    tail, head = start.ravel().astype(np.int64), onward.ravel().astype(np.int64)
    there = np.unique(np.minimum(tail, head) * count + np.maximum(tail, head))
    hold(
        len(tree) == count - 1
        and (min(int(a.min()), int(b.min())) >= 0)
        and np.isin(np.minimum(a, b) * count + np.maximum(a, b), there).all(),
        "a spanning tree is not of edges of its triangulation",
    )
    links = coo_array((np.ones(len(a), np.int8), (a, b)), shape=(count, count))
    hold(connected_components(links, directed=False)[0] == 1, "a spanning tree does not span")
    low, high = there // count, there % count
    size = float(np.ptp(t.nodes, axis=0).max())
    lengths = _lengths(t.nodes, low, high) / size
    shortest = minimum_spanning_tree(coo_array((lengths, (low, high)), shape=(count, count)))
    excess = float(_lengths(t.nodes, a, b).sum() / size - shortest.sum())
    hold(abs(excess) <= 1e-12 * count, "a spanning tree is not the shortest")


def _lengths(
    nodes: NDArray[np.float64], a: NDArray[np.int64], b: NDArray[np.int64]
) -> NDArray[np.float64]:
    step = nodes[a] - nodes[b]
    return np.asarray(np.hypot(step[:, 0], step[:, 1]))
