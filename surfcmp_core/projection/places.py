"""Nodes that fall on one place of the plane."""

import numpy as np
from numpy.typing import NDArray


def same_place(
    nodes: NDArray[np.float64], z: NDArray[np.float64]
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Find groups of nodes with equal x and y, bit for bit.

    Parameters
    ----------
    nodes : (n, 2) float64
        Without -0.0.
    z : (n,) float64

    Returns
    -------
    members : (k,) int64
        Nodes that share their place with another, group by group; in a group from the lowest z up,
        nodes of equal z by number.
    starts : (g,) int64
        Where each group starts in `members`.
    """
    bits = nodes.view(np.uint64)
    # equal places have equal keys; keys rarely agree without that, and sort fast
    keys = bits[:, 0] * np.uint64(0x9E3779B97F4A7C15)
    keys ^= keys >> np.uint64(29)
    keys += bits[:, 1]
    keys *= np.uint64(0xBF58476D1CE4E5B9)
    keys ^= keys >> np.uint64(32)
    ordered = np.sort(keys)
    twice = ordered[1:][ordered[1:] == ordered[:-1]]
    suspects = np.flatnonzero(np.isin(keys, twice)) if len(twice) else np.empty(0, np.int64)
    suspects = suspects[np.lexsort((z[suspects], nodes[suspects, 1], nodes[suspects, 0]))]
    first = np.ones(len(suspects), bool)
    first[1:] = (nodes[suspects[1:]] != nodes[suspects[:-1]]).any(axis=1)
    last = np.ones(len(suspects), bool)
    last[:-1] = first[1:]
    shared = ~(first & last)
    return suspects[shared], np.flatnonzero(first[shared])
