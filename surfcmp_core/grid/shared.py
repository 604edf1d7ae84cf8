"""Nodes that belong to both grids."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.grid.grid import Grid


@kernel
def _match(
    keys_1: NDArray[np.uint64],
    nodes_1: NDArray[np.float64],
    keys_2: NDArray[np.uint64],
    nodes_2: NDArray[np.float64],
    partner: NDArray[np.int32],
) -> int:
    i = 0
    found = 0
    for j in range(nodes_2.shape[0]):
        partner[j] = -1
        x, y = nodes_2[j, 0], nodes_2[j, 1]
        while i < nodes_1.shape[0] and (
            keys_1[i] < keys_2[j]
            or (
                keys_1[i] == keys_2[j]
                and (nodes_1[i, 0] < x or (nodes_1[i, 0] == x and nodes_1[i, 1] < y))
            )
        ):
            i += 1
        if i < nodes_1.shape[0] and nodes_1[i, 0] == x and nodes_1[i, 1] == y:
            partner[j] = i
            found += 1
    return found


def shared_nodes(first: Grid, second: Grid) -> NDArray[np.int32]:
    """Find the nodes of equal (x, y), in one pass along the curve.

    Parameters
    ----------
    first, second : Grid
        Made with the same box.

    Returns
    -------
    (n2,) int32
        Node of grid 1 equal to each node of grid 2, -1 where there is none.
    """
    partner = np.empty(len(second.nodes), np.int32)
    _match(first.keys, first.nodes, second.keys, second.nodes, partner)
    return partner
