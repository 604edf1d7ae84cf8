"""Which triangles of T are compared, and why the others are not."""

from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.domain.footprint import DATA, HOLE, OUTSIDE, Footprint, states_at
from surfcmp_core.kernel import kernel
from surfcmp_core.localisation import locate_from


class Reason(IntEnum):
    """Why a triangle of T is compared or not."""

    COMPARED = 0
    OUTSIDE_1 = 1
    """Outside surface 1."""
    OUTSIDE_2 = 2
    """Outside surface 2."""
    HOLE = 3
    """Within both surfaces' outlines, but one has a hole there."""
    DEGENERATE = 4
    """Its area rounds to nothing."""


@kernel
def _combine(
    nodes: NDArray[np.float64],
    triangles: NDArray[np.int32],
    node_state: NDArray[np.uint8],
    state: NDArray[np.uint8],
) -> None:
    """Combine the states of three nodes: outside before hole before data."""
    for t in range(triangles.shape[0]):
        worst = 0
        for i in range(3):
            s = node_state[triangles[t, i]]
            if s == 1 or (s == 2 and worst == 0):
                worst = s
        state[t] = worst


def states_of_triangles(
    footprint: Footprint,
    nodes: NDArray[np.float64],
    triangles: NDArray[np.int32],
    node_state: NDArray[np.uint8],
    hints: NDArray[np.int32],
    *,
    ask_centroids: bool,
) -> NDArray[np.uint8]:
    """Tell which triangles of T lie where one surface has data.

    Parameters
    ----------
    footprint : Footprint
        Of that surface.
    nodes, triangles : (N, 2) float64, (M, 3) int32
        T.
    node_state : (N,) uint8
        DATA, OUTSIDE or HOLE at each node of T.
    hints : (N,) int32
        A triangle of the footprint's triangulation at or near each node of T.
    ask_centroids : bool
        Whether there must be data at the centroid too.

    Returns
    -------
    (M,) uint8
        DATA, OUTSIDE or HOLE.
    """
    state = np.empty(len(triangles), np.uint8)
    _combine(nodes, triangles, node_state, state)
    if footprint.is_hull or not ask_centroids:
        return state
    asked = np.flatnonzero(state == DATA)
    chosen = triangles[asked]
    centroids = (nodes[chosen[:, 0]] + nodes[chosen[:, 1]] + nodes[chosen[:, 2]]) / 3.0
    found = locate_from(footprint.triangulation, centroids, hints[chosen[:, 0]])
    state[asked] = states_at(footprint, centroids, found)
    return state


def reasons(
    state_1: NDArray[np.uint8], state_2: NDArray[np.uint8], area: NDArray[np.float64]
) -> NDArray[np.uint8]:
    """Say of each triangle of T why it is compared or not.

    Parameters
    ----------
    state_1, state_2 : (M,) uint8
        Of :func:`states_of_triangles` for either surface.
    area : (M,) float64

    Returns
    -------
    (M,) uint8
        A `Reason` each.
    """
    reason = np.full(len(area), Reason.COMPARED, np.uint8)
    reason[area <= 0.0] = Reason.DEGENERATE
    reason[(state_1 == HOLE) | (state_2 == HOLE)] = Reason.HOLE
    reason[state_2 == OUTSIDE] = Reason.OUTSIDE_2
    reason[state_1 == OUTSIDE] = Reason.OUTSIDE_1
    return reason
