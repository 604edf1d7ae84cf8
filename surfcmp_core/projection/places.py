"""Nodes that fall on one place of the plane."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel

_CELL = 64.0
"""Width of the cells among which nodes a little apart are sought, in times of that little."""


def same_place(
    nodes: NDArray[np.float64], z: NDArray[np.float64], room: float = 0.0
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Find groups of nodes with equal x and y.

    Parameters
    ----------
    nodes : (n, 2) float64
        Without -0.0.
    z : (n,) float64
    room : float
        Up to this far apart x and y count as equal: what a motion has rounded off. 0: equal bit for
        bit.

    Returns
    -------
    members : (k,) int64
        Nodes that share their place with another, group by group; in a group from the lowest z up,
        nodes of equal z by number.
    starts : (g,) int64
        Where each group starts in `members`.
    """
    suspects = _near(nodes, room) if room > 0.0 else _alike(nodes)
    group = _groups(nodes[suspects], room)
    order = np.lexsort((z[suspects], group))
    suspects, group = suspects[order], group[order]
    first = np.ones(len(suspects), bool)
    first[1:] = group[1:] != group[:-1]
    last = np.ones(len(suspects), bool)
    last[:-1] = first[1:]
    shared = ~(first & last)
    return suspects[shared], np.flatnonzero(first[shared])


def _alike(nodes: NDArray[np.float64]) -> NDArray[np.int64]:
    """Give the nodes, and few others, that have the very x and y of another."""
    bits = nodes.view(np.uint64)
    # equal places have equal keys; keys rarely agree without that, and sort fast
    keys = bits[:, 0] * np.uint64(0x9E3779B97F4A7C15)
    keys ^= keys >> np.uint64(29)
    keys += bits[:, 1]
    keys *= np.uint64(0xBF58476D1CE4E5B9)
    keys ^= keys >> np.uint64(32)
    twice = _twice(np.sort(keys))
    return np.flatnonzero(np.isin(keys, twice)) if len(twice) else np.empty(0, np.int64)


def _twice(ordered: NDArray[np.uint64]) -> NDArray[np.uint64]:
    return np.asarray(ordered[1:][ordered[1:] == ordered[:-1]])


def _near(nodes: NDArray[np.float64], room: float) -> NDArray[np.int64]:
    """Give the nodes, and few others, that another lies within `room` of in x and in y."""
    keys = np.empty(len(nodes), np.uint64)
    # a node near the border of its cell may have its like beyond: up to three more cells
    more, whose = np.empty(3 * len(nodes), np.uint64), np.empty(3 * len(nodes), np.int64)
    x0, y0 = nodes.min(axis=0).tolist()
    count = _cell_keys(nodes, x0, y0, 1.0 / (_CELL * room), keys, more, whose)
    more, whose = more[:count], whose[:count]
    ordered = np.sort(keys)
    found = np.zeros(len(nodes), bool)
    if len(twice := _twice(ordered)):
        found |= np.isin(keys, twice)
    place = np.minimum(np.searchsorted(ordered, more), len(ordered) - 1)
    beyond = ordered[place] == more
    found[whose[beyond]] = True
    if beyond.any():
        found |= np.isin(keys, more[beyond])
    return np.flatnonzero(found)


@kernel
def _cell_key(column: int, row: int) -> np.uint64:
    key = np.uint64(column) * np.uint64(0x9E3779B97F4A7C15)
    key ^= key >> np.uint64(29)
    key += np.uint64(row)
    key *= np.uint64(0xBF58476D1CE4E5B9)
    return key ^ (key >> np.uint64(32))


@kernel
def _cell_keys(
    nodes: NDArray[np.float64],
    x0: float,
    y0: float,
    per_cell: float,
    keys: NDArray[np.uint64],
    more: NDArray[np.uint64],
    whose: NDArray[np.int64],
) -> int:
    """Give each node the key of its cell, and those near a border the keys of the next ones."""
    edge = 2.0 / _CELL  # twice what may part two alike, for the rounding here
    count = 0
    for i in range(nodes.shape[0]):
        x, y = (nodes[i, 0] - x0) * per_cell + 1.375, (nodes[i, 1] - y0) * per_cell + 1.375
        column, row = int(x), int(y)
        keys[i] = _cell_key(column, row)
        aside = -1 if x - column < edge else 1 if column + 1.0 - x < edge else 0
        up = -1 if y - row < edge else 1 if row + 1.0 - y < edge else 0
        for k in range(3):
            right, above = aside if k != 1 else 0, up if k != 0 else 0
            if (right != 0 or k == 1) and (above != 0 or k == 0):
                more[count] = _cell_key(column + right, row + above)
                whose[count] = i
                count += 1
    return count


def _groups(nodes: NDArray[np.float64], room: float) -> NDArray[np.int64]:
    """Give nodes one number where no step of x or y from one to the next exceeds `room`."""
    group = np.zeros(len(nodes), np.int64)
    count = min(len(nodes), 1)
    while True:
        for values in nodes.T:
            order = np.lexsort((values, group))
            cut = (np.diff(group[order]) != 0) | (np.diff(values[order]) > room)
            group[order[1:]] = np.cumsum(cut)
            group[order[:1]] = 0
        found = int(group.max(initial=-1)) + 1
        if found == count:
            return group
        count = found
