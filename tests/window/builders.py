"""Small comparisons made without the core's pipeline, for tests of the scene."""

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import Delaunay

from surfcmp_core.comparison import Comparison, Options, Reason
from surfcmp_core.grid import Grid
from surfcmp_core.measures.measures import Measures
from surfcmp_core.surface import Surface
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.united import United


def comparison_of(
    one: NDArray[np.float64], two: NDArray[np.float64], *, hole: float = 0.0
) -> Comparison:
    """Compare two clouds (n, 3) by SciPy; nodes within `hole` of the middle have no data in 2."""
    nodes = np.vstack([one[:, :2], two[:, :2]])
    label = np.repeat(np.array([1, 2], np.uint8), [len(one), len(two)])
    triangles = _delaunay(nodes)
    chain, closed = _chains(triangles, label)
    order = np.argsort(np.where(chain < 0, len(triangles), chain), kind="stable")
    triangles, chain = triangles[order], chain[order]
    z1 = np.concatenate([one[:, 2], _nearest(one, two)])
    z2 = np.concatenate([_nearest(two, one), two[:, 2]])
    z2[np.hypot(*(nodes - nodes.mean(axis=0)).T) < hole] = np.nan
    d = z1 - z2
    side = nodes[triangles]
    across = (side[:, 1] - side[:, 0]).T, (side[:, 2] - side[:, 0]).T
    area = np.abs(across[0][0] * across[1][1] - across[0][1] * across[1][0]) / 2
    signed = d[triangles].mean(axis=1)
    missing = np.isnan(signed)
    area[missing] = np.nan
    united = United(
        nodes=nodes,
        label=label,
        node_1=np.arange(len(one), dtype=np.int32),
        node_2=np.arange(len(one), len(nodes), dtype=np.int32),
        triangles=triangles,
        origin=np.zeros(len(triangles), np.uint8),
        chain=chain,
        chain_closed=closed,
        tree1=np.zeros((0, 2), np.int32),
        tree2=np.zeros((0, 2), np.int32),
    )
    mean_abs = float(np.nansum(np.abs(signed) * area) / np.nansum(area))
    return Comparison(
        surfaces=(_surface(one, "one.ply"), _surface(two, "two.ply")),
        grids=(_grid(one, "one.ply"), _grid(two, "two.ply")),
        triangulations=(_triangulation(one), _triangulation(two)),
        united=united,
        z1=z1,
        z2=z2,
        weight=None,
        reason=np.where(missing, Reason.HOLE, Reason.COMPARED).astype(np.uint8),
        area=area,
        mean_abs=np.abs(signed),
        mean_signed=signed,
        measures=Measures(
            rho_V=1234.5,
            rho_V_mu=1234.5,
            rho_delta_V=567.8,
            mean_abs=mean_abs,
            mean_abs_interface=mean_abs,
            mean_signed=0.1,
            rms=mean_abs * 1.3,
            max_abs=float(np.nanmax(np.abs(d))),
            p50=0.2,
            p90=0.9,
            p95=1.1,
            within_tolerance={"0.5": 0.8, "1": 0.9, "2": 1.0},
            area_compared=float(np.nansum(area)),
            coverage_1=0.98,
            coverage_2=0.97,
        ),
        options=Options(),
        transform=np.eye(4),
        max_edges=(np.inf, np.inf),
    )


def hills(count: int, seed: int, lift: float = 0.0) -> NDArray[np.float64]:
    """Return (count, 3) nodes on a smooth hilly surface over [-50, 50]²."""
    xy = np.random.default_rng(seed).uniform(-50, 50, (count, 2))
    z = 8 * np.sin(xy[:, 0] / 15) * np.cos(xy[:, 1] / 12)
    return np.column_stack([xy, z + lift * np.exp(-((xy - 20) ** 2).sum(axis=1) / 200)])


def _surface(points: NDArray[np.float64], name: str) -> Surface:
    return Surface(points=points, name=name, unit="mm")


def _grid(points: NDArray[np.float64], name: str) -> Grid:
    return Grid(
        nodes=points[:, :2].copy(),
        z=points[:, 2].copy(),
        source=np.arange(len(points)),
        faces=None,
        merged=0,
        name=name,
    )


def _triangulation(points: NDArray[np.float64]) -> Triangulation:
    triangles = _delaunay(points[:, :2])
    start = np.ascontiguousarray(triangles.ravel(), dtype=np.int32)
    return Triangulation(points[:, :2], start, np.zeros_like(start), len(triangles))


def _delaunay(nodes: NDArray[np.float64]) -> NDArray[np.int32]:
    triangles = Delaunay(nodes - nodes.mean(axis=0)).simplices.astype(np.int32)
    a, b, c = (nodes[triangles[:, k]] for k in range(3))
    turn = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    triangles[turn < 0] = triangles[turn < 0][:, ::-1]
    return triangles


def _nearest(source: NDArray[np.float64], at: NDArray[np.float64]) -> NDArray[np.float64]:
    from scipy.spatial import cKDTree

    return np.asarray(source[cKDTree(source[:, :2]).query(at[:, :2])[1], 2])


def _chains(
    triangles: NDArray[np.int32], label: NDArray[np.uint8]
) -> tuple[NDArray[np.int32], NDArray[np.bool_]]:
    """Join triangles across edges that lead from grid 1 to grid 2."""
    sides: dict[tuple[int, int], list[int]] = {}
    for t, nodes in enumerate(triangles.tolist()):
        for a, b in zip(nodes, nodes[1:] + nodes[:1], strict=True):
            if label[a] != label[b]:
                sides.setdefault((min(a, b), max(a, b)), []).append(t)
    neighbours: dict[int, list[int]] = {}
    for pair in sides.values():
        for t in pair:
            neighbours.setdefault(t, []).extend(u for u in pair if u != t)
    chain = np.full(len(triangles), -1, np.int32)
    closed: list[bool] = []
    for first in neighbours:
        if chain[first] >= 0:
            continue
        members, stack = [], [first]
        chain[first] = len(closed)
        while stack:
            t = stack.pop()
            members.append(t)
            for u in neighbours[t]:
                if chain[u] < 0:
                    chain[u] = len(closed)
                    stack.append(u)
        closed.append(all(len(neighbours[t]) == 2 for t in members))
    return chain, np.array(closed, dtype=bool)
