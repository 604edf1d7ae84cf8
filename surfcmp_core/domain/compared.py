"""Which triangles of T are compared, and why the others are not."""

from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel


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
def _reasons(
    state_1: NDArray[np.uint8],
    state_2: NDArray[np.uint8],
    area: NDArray[np.float64],
    reason: NDArray[np.uint8],
) -> None:
    for t in range(area.size):
        if state_1[t] == 1:
            reason[t] = 1
        elif state_2[t] == 1:
            reason[t] = 2
        elif state_1[t] == 2 or state_2[t] == 2:
            reason[t] = 3
        elif area[t] > 0.0:
            reason[t] = 0
        else:
            reason[t] = 4


def reasons(
    state_1: NDArray[np.uint8], state_2: NDArray[np.uint8], area: NDArray[np.float64]
) -> NDArray[np.uint8]:
    """Say of each triangle of T why it is compared or not.

    Parameters
    ----------
    state_1, state_2 : (M,) uint8
        Of :func:`surfcmp_core.domain.footprint.states_of_triangles` for either surface.
    area : (M,) float64

    Returns
    -------
    (M,) uint8
        A `Reason` each.
    """
    reason = np.empty(len(area), np.uint8)
    _reasons(state_1, state_2, area, reason)
    return reason
