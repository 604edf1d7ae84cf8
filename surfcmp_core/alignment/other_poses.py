"""Whether a surface would lie better the other way round."""

from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.alignment.account import agreement_of
from surfcmp_core.alignment.closest_points import closest_points
from surfcmp_core.alignment.prepared import Prepared
from surfcmp_core.compiled.linear_algebra import applied, composed, eigen, moments
from surfcmp_core.errors import InputError
from surfcmp_core.system.progress import silent

_MOVING = 500
"""Nodes that are enough to tell poses from each other."""
_NEAR = 1e-4
_BESIDE = 2.0
_BETTER = 0.1
"""So much more agreement is no matter of chance."""


@dataclass(frozen=True, slots=True)
class Better:
    """A pose that fits better: root mean square distance and agreement."""

    residual: float
    agreement: float


def better_pose(
    sides: tuple[Prepared, Prepared], motion: NDArray[np.float64], residual: float, agreement: float
) -> Better | None:
    """Try poses turned by half about each main axis: a face upside down settles as well.

    Each is tried where the surface lies and with its middle on that of the other.

    Parameters
    ----------
    sides : two Prepared
    motion : (4, 4) float64
        The pose found, of surface 2.
    residual, agreement : float
        Of that pose.

    Returns
    -------
    Better or None
        The best of those that fit clearly better; None: there is none.
    """
    fixed, moving = sides
    some = replace(moving, moving=moving.moving[:: -(-len(moving.moving) // _MOVING)])
    middle = some.moving.mean(axis=0)
    spread = some.moving - middle
    axes = eigen(moments(spread, np.ones(len(spread))))[1]
    there = applied(motion, middle[None, :])[0]
    found = []
    for axis, to in product(axes.T, (there, fixed.moving.mean(axis=0))):
        half_turn = 2.0 * axis[:, None] * axis[None, :] - np.eye(3)
        start = np.eye(4)
        start[:3, :3] = composed(motion[:3, :3], half_turn)
        start[:3, 3] = to - applied(start, middle[None, :])[0]
        try:
            pose = closest_points(fixed, some, start, _BESIDE, _NEAR, lambda s: silent("", s))
        except InputError:  # no partners there
            continue
        other = Better(pose.residual, agreement_of(sides, pose.motion))
        if other.residual < residual and other.agreement > agreement + _BETTER:
            found.append(other)
    return max(found, key=lambda pose: pose.agreement, default=None)
