"""Best fit of two surfaces by ICP, from partners that can be trusted."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.alignment.alignment import Alignment, Method
from surfcmp_core.errors import InputError
from surfcmp_core.progress import Progress, silent
from surfcmp_core.projection.frame import moved
from surfcmp_core.surface import Surface

_NEIGHBOURS = 10
"""Nodes that give a tangent plane."""
_MOVING = 100_000
"""Most nodes that are moved; the surface they are moved onto is used whole."""
_BESIDE = 2.0
"""A node this many local spacings beside its partner lies beyond the border."""
_FAR = 3.0
"""Nodes farther off than this many standard deviations (by the median) do not count, and those
near that limit count little: Tukey's biweight."""
_ROUNDS = 50
_FEWEST = 10
"""Nodes that must be left to find six unknowns with some certainty."""
_STILL = 1e-5
"""A round that moves no node by more than this share of the extent is the last."""


def best_fit(
    surface_1: Surface,
    surface_2: Surface,
    *,
    start: NDArray[np.float64] | None = None,
    overlap_only: bool = True,
    region_1: NDArray[np.bool_] | None = None,
    region_2: NDArray[np.bool_] | None = None,
    progress: Progress = silent,
) -> Alignment:
    """Find the rigid motion that moves surface 2 best onto surface 1.

    Iterated closest points: in each round a node's partner is the nearest node of the finer
    surface, and its distance is taken to the tangent plane there. On the overlap only, partners
    are rejected that lie on a border or to the side (there the node lies beyond the border, and
    would draw the surfaces over each other), and the farther off a node the less it counts, from
    three standard deviations on not at all: a swelling does not pull the rest along.

    Parameters
    ----------
    surface_1, surface_2 : Surface
        In one unit, and nearly in place: some 30 degrees and a fifth of the extent.
    start : (4, 4) float64, optional
        Where surface 2 starts from, by landmarks for instance; the identity by default.
    overlap_only : bool
        False: all nodes count, also those beyond the border of the other surface.
    region_1, region_2 : (n1,), (n2,) bool, optional
        Nodes that may be used, for stable parts such as forehead and bridge of the nose.
    progress : Progress
        Told each round.

    Returns
    -------
    Alignment
        The same for the same input, bit for bit.

    Raises
    ------
    InputError
        Fewer than ten nodes to use on either surface, or fewer than ten trusted partners.

    References
    ----------
    Chen, Medioni, Object modelling by registration of multiple range images, 1992;
    Rusinkiewicz, Levoy, Efficient variants of the ICP algorithm, 2001 (borders rejected);
    Beaton, Tukey, The fitting of power series, 1974 (biweight).
    """
    method: Method = "icp overlap" if overlap_only else "icp"
    if region_1 is not None or region_2 is not None:
        method = "icp region"
    placed = moved(surface_2, np.eye(4) if start is None else np.asarray(start, np.float64))
    may_1, may_2 = _may_be_used(surface_1, region_1), _may_be_used(surface_2, region_2)
    if _spacing(surface_1.points[may_1]) <= _spacing(surface_2.points[may_2]):
        found = _fit(surface_1, may_1, placed, may_2, overlap_only, method, progress)
        matrix = found.matrix
    else:
        found = _fit(placed, may_2, surface_1, may_1, overlap_only, method, progress)
        matrix = _inverse(found.matrix)
    return replace(found, matrix=matrix if start is None else matrix @ start)


def _fit(
    fixed: Surface,
    may_fixed: NDArray[np.bool_],
    moving: Surface,
    may_moving: NDArray[np.bool_],
    overlap_only: bool,
    method: Method,
    progress: Progress,
) -> Alignment:
    """Move the coarser surface onto the finer one, which gives better tangent planes."""
    from small_gicp import KdTree, PointCloud, estimate_normals_covariances

    origin = fixed.points[may_fixed].mean(axis=0)  # the library loses digits far from 0
    places = fixed.points - origin
    cloud = PointCloud(places)
    tree = KdTree(cloud)
    estimate_normals_covariances(cloud, tree, num_neighbors=_NEIGHBOURS)
    normals = cloud.normals()[:, :3]
    near = np.asarray(tree.batch_knn_search(places, 4)[1])[:, 1:]
    spacing = np.sqrt(near.mean(axis=1))
    trusted = may_fixed & ~_on_border(fixed) if overlap_only else may_fixed

    nodes = moving.points[may_moving] - origin
    nodes = nodes[:: -(-len(nodes) // _MOVING)]
    extent = float(np.linalg.norm(np.ptp(nodes, axis=0)))
    motion = np.eye(4)
    still = False
    rounds = 0
    while True:
        at = nodes @ motion[:3, :3].T + motion[:3, 3]
        partner = np.asarray(tree.batch_nearest_neighbor_search(at)[0], np.intp)
        normal = normals[partner]
        away = at - places[partner]
        off = np.einsum("ij,ij->i", away, normal)
        paired = trusted[partner]
        weight = np.ones(len(at))
        if overlap_only:
            beside = np.sqrt(np.maximum((away**2).sum(axis=1) - off**2, 0.0))
            paired &= beside <= _BESIDE * spacing[partner]
            deviation = 1.4826 * float(np.median(np.abs(off[paired]))) if paired.any() else 0.0
            limit = max(_FAR * deviation, 1e-9 * extent)
            weight = np.maximum(1.0 - (off / limit) ** 2, 0.0) ** 2
        inlier = paired & (weight > 0.0)
        found = int(np.count_nonzero(inlier))
        if found < _FEWEST:
            raise InputError(
                f"{moving.name}: only {found} nodes find a partner on {fixed.name}; "
                "bring the surfaces nearer by landmarks first"
            )
        if still or rounds == _ROUNDS:
            break
        step = _step(at[inlier], normal[inlier], off[inlier], weight[inlier])
        still = float(np.abs(at @ step[:3, :3].T + step[:3, 3] - at).max()) <= _STILL * extent
        motion = step @ motion
        rounds += 1
        progress("align", rounds / _ROUNDS)
    matrix = motion.copy()
    matrix[:3, 3] += origin - motion[:3, :3] @ origin
    residual = float(np.sqrt((off[inlier] ** 2).mean()))
    return Alignment(matrix, method, residual, found, float(paired.mean()), rounds, still)


def _step(
    at: NDArray[np.float64],
    normal: NDArray[np.float64],
    off: NDArray[np.float64],
    weight: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Give the small motion that brings nodes nearest to their partners' planes."""
    slopes = np.column_stack((np.cross(at, normal), normal))
    # what no node resists (the turn of a sphere) stays as it is: least squares of least norm
    turn_and_shift = -np.linalg.pinv((slopes.T * weight) @ slopes, 1e-12, hermitian=True) @ (
        slopes.T @ (weight * off)
    )
    x, y, z = turn_and_shift[:3] / 2.0
    half = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    step = np.eye(4)
    step[:3, :3] = np.linalg.solve(np.eye(3) - half, np.eye(3) + half)  # Cayley: a rotation
    step[:3, 3] = turn_and_shift[3:]
    return step


def _may_be_used(surface: Surface, region: NDArray[np.bool_] | None) -> NDArray[np.bool_]:
    """Give the nodes in the region, of a mesh those that some triangle uses."""
    may = np.ones(len(surface.points), bool)
    if surface.faces is not None:
        may[:] = False
        may[surface.faces.ravel()] = True
    if region is not None:
        region = np.asarray(region)
        if region.dtype != np.bool_ or region.shape != may.shape:
            raise InputError(f"{surface.name}: the region is not one bool for each node")
        may &= region
    if np.count_nonzero(may) < _FEWEST:
        raise InputError(
            f"{surface.name}: {np.count_nonzero(may)} nodes to align; at least {_FEWEST} are needed"
        )
    return may


def _spacing(nodes: NDArray[np.float64]) -> float:
    """Give the median distance to the nearest other node."""
    from small_gicp import KdTree

    nodes = nodes - nodes.mean(axis=0)
    some = nodes[:: -(-len(nodes) // 10_000)]
    return float(np.sqrt(np.median(np.asarray(KdTree(nodes).batch_knn_search(some, 2)[1])[:, 1])))


def _on_border(surface: Surface) -> NDArray[np.bool_]:
    """Give the nodes of edges that one triangle alone has; none of a cloud."""
    border = np.zeros(len(surface.points), bool)
    if surface.faces is not None:
        faces = surface.faces.astype(np.int64)
        ends = np.concatenate((faces[:, :2], faces[:, 1:], faces[:, ::2]))
        keys, counts = np.unique(
            ends.min(axis=1) * len(border) + ends.max(axis=1), return_counts=True
        )
        lone = keys[counts == 1]
        border[lone // len(border)] = True
        border[lone % len(border)] = True
    return border


def _inverse(matrix: NDArray[np.float64]) -> NDArray[np.float64]:
    inverse = np.eye(4)
    inverse[:3, :3] = matrix[:3, :3].T
    inverse[:3, 3] = -matrix[:3, :3].T @ matrix[:3, 3]
    return inverse
