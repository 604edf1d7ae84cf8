"""Best fit of two surfaces by ICP, from partners that can be trusted."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.alignment.account import account_of
from surfcmp_core.alignment.closest_points import Found, closest_points
from surfcmp_core.alignment.doubts import UNSURE, doubts_of
from surfcmp_core.alignment.fit import Alignment, Method
from surfcmp_core.alignment.other_poses import better_pose
from surfcmp_core.alignment.prepared import Prepared, prepared, used_of
from surfcmp_core.compiled.linear_algebra import composed, dots, inverse
from surfcmp_core.errors import InputError
from surfcmp_core.projection.frame import moved
from surfcmp_core.surface import Surface
from surfcmp_core.surface.refusals import LARGEST_IN_SPACE, motion_of, refuse_surface
from surfcmp_core.surface.together import check_together
from surfcmp_core.system.progress import Progress, silent

_BESIDE_FIRST = 1.0
_BESIDE = 2.0
"""A node this many local spacings beside its partner lies beyond the border; at first, while all
is out of place, fewer."""
_NEAR_FIRST = 1e-3
_NEAR = 1e-5
"""Nodes are in place once none moves by more than this share of the extent; for a start, sooner."""


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

    Iterated closest points: in each round a node's partner is the nearest node of the other
    surface, and its distance is taken to the tangent plane there. On the overlap only, partners
    are rejected that lie on a border or to the side (there the node lies beyond the border, and
    would draw the surfaces over each other), and the farther off a node the less it counts, from
    three standard deviations on not at all: a swelling does not pull the rest along. There the
    smaller surface goes first onto the larger, so that nearly all nodes have partners; then the
    coarser onto the finer, whose tangent planes are the better ones.

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
        The same for the same input, bit for bit. Its `doubts` say why the pose may be wrong.

    Raises
    ------
    InputError
        Unlike units or axes; fewer than ten nodes to use on either surface, or fewer than ten
        trusted partners.

    References
    ----------
    [ChenMedioni1992]; [RusinkiewiczLevoy2001] (borders rejected); [BeatonTukey1974] (biweight).
    """
    check_together(surface_1, surface_2)
    method: Method = "icp overlap" if overlap_only else "icp"
    if region_1 is not None or region_2 is not None:
        method = "icp region"
    for surface in (surface_1, surface_2):
        refuse_surface(surface, LARGEST_IN_SPACE)
    surface_1, region_1 = used_of(surface_1, region_1)
    surface_2, region_2 = used_of(surface_2, region_2)
    placed = surface_2 if start is None else moved(surface_2, motion_of(start, "start"))
    origin = (surface_1.points.mean(axis=0) + placed.points.mean(axis=0)) / 2.0
    sides = prepared(surface_1, region_1, origin), prepared(placed, region_2, origin)

    for side in sides:
        if not side.extent > 0.0:
            raise InputError("beside the other surface it is but one place", where=(side.name,))

    def onto_finer(share: float) -> None:
        progress("align", share if not overlap_only else 0.5 + share / 2.0)

    motion = np.eye(4)
    rounds = 0
    if overlap_only:
        smaller = sides[0].extent < sides[1].extent
        first = _fit(
            sides, smaller, motion, _BESIDE_FIRST, _NEAR_FIRST, lambda s: progress("align", s / 2.0)
        )
        motion, rounds = first.motion, first.iterations
    coarser = bool(np.median(sides[0].spacing) > np.median(sides[1].spacing))
    found = _fit(sides, coarser, motion, _BESIDE if overlap_only else None, _NEAR, onto_finer)
    account = account_of(sides, found.motion)
    better = None
    if account.agreement < UNSURE:
        better = better_pose(sides, found.motion, found.residual, account.agreement)
    doubts = doubts_of(
        account,
        better,
        found.converged,
        found.residual,
        min(side.extent for side in sides),
        surface_1.unit or surface_2.unit or "units",
    )
    matrix = found.motion.copy()
    matrix[:3, 3] += origin - dots(matrix[:3, :3], origin)
    return Alignment(
        matrix if start is None else composed(matrix, start),
        method,
        found.residual,
        found.inliers,
        found.overlap,
        rounds + found.iterations,
        found.converged,
        found.pairs,
        found.residual_all,
        account.overlaps,
        account.agreement,
        account.turned,
        account.shifted,
        account.free,
        doubts=doubts,
    )


def _fit(
    sides: tuple[Prepared, Prepared],
    first_moves: bool,
    motion: NDArray[np.float64],
    beside: float | None,
    near: float,
    progress: Callable[[float], None],
) -> Found:
    """Find the motion of surface 2, by moving either of the two."""
    if not first_moves:
        return closest_points(*sides, motion, beside, near, progress)
    found = closest_points(sides[1], sides[0], inverse(motion), beside, near, progress)
    return replace(found, motion=inverse(found.motion))
