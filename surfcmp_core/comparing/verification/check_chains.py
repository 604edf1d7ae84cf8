"""Whether the chains of T are what its triangles and labels say."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparing.verification.holds import hold
from surfcmp_core.united import United


def check_chains(united: United) -> None:
    """Check that chains are the connected parts of the interface, each in its order.

    Parameters
    ----------
    united : United

    Raises
    ------
    Violation
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    labels = united.label[united.triangles]
    interface = (labels == 1).any(axis=1) & (labels == 2).any(axis=1)
    hold(np.array_equal(united.chain >= 0, interface), "a chain is not of interface triangles")
    inside = np.flatnonzero(interface)
    chains = len(united.chain_closed)
    if len(inside) == 0:
        hold(chains == 0, "a chain has no triangle")
        return
    number = united.chain[inside]
    hold(
        np.array_equal(inside, np.arange(inside[0], len(united.chain)))
        and (np.diff(number) >= 0).all()
        and np.array_equal(np.unique(number), np.arange(chains)),
        "chains do not stand one after the other",
    )
    one, other = _neighbours(united, inside)
    links = coo_array((np.ones(len(one), np.int8), (one, other)), shape=(len(inside),) * 2)
    parts, part = connected_components(links, directed=False)
    together = len(np.unique(part.astype(np.int64) * parts + number))
    hold(parts == chains == together, "chains are not the connected parts of the interface")
    lowest = np.full(parts, 2)
    np.minimum.at(lowest, number, np.bincount(one, minlength=len(inside)))
    hold(np.array_equal(united.chain_closed, lowest == 2), "a chain is not closed as it says")
    onward = np.zeros(len(inside), bool)
    onward[one[other == one + 1]] = True
    hold(
        onward[np.flatnonzero(np.diff(number) == 0)].all(),
        "a triangle of a chain is not beside the one before",
    )


def _neighbours(
    united: United, inside: NDArray[np.intp]
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Pair the interface triangles on either side of each interface edge, by their rows."""
    triangles, count = united.triangles[inside], len(united.nodes)
    a, b = triangles.ravel().astype(np.int64), triangles[:, [1, 2, 0]].ravel().astype(np.int64)
    rows = np.repeat(np.arange(len(inside)), 3)
    chosen = (united.label[a] | united.label[b]) == 3
    chosen &= (united.label[a] != 3) & (united.label[b] != 3)
    a, b, rows = a[chosen], b[chosen], rows[chosen]
    order = np.argsort(a * count + b)
    at = np.searchsorted((a * count + b)[order], b * count + a)
    at = order[np.minimum(at, len(order) - 1)]
    has_twin = (a[at] == b) & (b[at] == a)
    return rows[has_twin], rows[at[has_twin]]
