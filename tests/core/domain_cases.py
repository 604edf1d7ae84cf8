"""Meshes to ask where there are data."""

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core import Surface
from surfcmp_core.domain import (
    Footprint,
)
from surfcmp_core.domain.footprint import DATA, HOLE, OUTSIDE, states_at
from surfcmp_core.localisation import locate_from
from surfcmp_core.triangulation import Triangulation
from tests.core import oracles
from tests.pairs import Nodes

Faces = NDArray[np.int32]
States = NDArray[np.uint8]


def lattice(columns: int, rows: int) -> Nodes:
    x, y = np.meshgrid(np.arange(columns), np.arange(rows))
    return np.column_stack((x.ravel(), y.ravel())).astype(np.float64)


def is_under(nodes: Nodes, faces: Faces, queries: Nodes) -> NDArray[np.bool_]:
    """Which places lie under a face that is no line, borders included; every face is tried."""
    whole = oracles.exact(np.concatenate((nodes, queries)))
    x, y = whole[: len(nodes)].T
    px, py = whole[len(nodes) :].T
    found = np.zeros(len(queries), bool)
    for a, b, c in faces.tolist():
        turn = oracles.sign(oracles.orientation(x[a], y[a], x[b], y[b], x[c], y[c]))
        sides = [
            turn * oracles.orientation(x[u], y[u], x[v], y[v], px, py) >= 0
            for u, v in ((a, b), (b, c), (c, a))
        ]
        if turn:
            found |= np.logical_and.reduce(sides)
    return found


def states_of(footprint: Footprint, queries: Nodes) -> States:
    t = footprint.triangulation
    return states_at(footprint, queries, locate_from(t, queries, np.zeros(len(queries), np.int32)))


def flooded(triangulation: Triangulation, with_data: NDArray[np.bool_]) -> States:
    """DATA, or OUTSIDE where triangles without data lead to the hull, else HOLE."""
    state = np.where(with_data, DATA, HOLE)
    neighbours = triangulation.twin.reshape(-1, 3) // 3
    is_ghost = neighbours >= triangulation.real
    while True:
        beside = is_ghost | (np.append(state, [OUTSIDE])[np.where(is_ghost, -1, neighbours)] == 1)
        more = (state == HOLE) & beside[: triangulation.real].any(axis=1)
        if not more.any():
            return np.asarray(state, np.uint8)
        state[more] = OUTSIDE


cell = st.tuples(st.integers(0, 5), st.integers(0, 4))


def longest_sides(triangulation: Triangulation) -> NDArray[np.float64]:
    corners = triangulation.nodes[triangulation.triangles]
    sides = corners - np.roll(corners, 1, axis=1)
    return np.asarray(np.hypot(sides[..., 0], sides[..., 1]).max(axis=1))


def surface_of(nodes: Nodes, faces: Faces | None, name: str) -> Surface:
    return Surface(np.column_stack((nodes, nodes[:, 0] - nodes[:, 1])), faces, name)
