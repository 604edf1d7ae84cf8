"""The value behind each triangle's colour in the heatmap."""

from __future__ import annotations

from enum import IntEnum
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.model.view_state import Heatmap

if TYPE_CHECKING:  # the window is on the screen before the core is loaded
    from surfcmp_core.comparing.comparison import Comparison


class Trust(IntEnum):
    """What a triangle of T rests on."""

    BOTH = 0
    """Nodes of both grids."""
    ONLY_1 = 1
    """Nodes of grid 1 alone: surface 2 is interpolated over a gap."""
    ONLY_2 = 2
    """Nodes of grid 2 alone."""
    NOT_COMPARED = 3


def values_of(
    comparison: Comparison, heatmap: Heatmap, some: NDArray[np.int64] | None = None
) -> NDArray[np.float64]:
    """Return (M,) the values `heatmap` shows, or those of `some` triangles; NaN without one.

    `Heatmap.TRUST` gives the numbers of `Trust`.
    """
    which = slice(None) if some is None else some
    match heatmap:
        case Heatmap.ABSOLUTE:
            return comparison.mean_abs[which]
        case Heatmap.SIGNED:
            return comparison.mean_signed[which]
        case Heatmap.REPRESENTATIVE:
            both = trust_of(comparison, some) == Trust.BOTH
            return np.where(both, comparison.mean_abs[which], np.nan)
        case Heatmap.TRUST:
            return trust_of(comparison, some).astype(np.float64)
        case Heatmap.HEIGHT_1:
            return np.asarray(comparison.z1[comparison.united.triangles[which]].mean(axis=1))
        case Heatmap.HEIGHT_2:
            return np.asarray(comparison.z2[comparison.united.triangles[which]].mean(axis=1))


def trust_of(comparison: Comparison, some: NDArray[np.int64] | None = None) -> NDArray[np.uint8]:
    """Return (M,) a `Trust` for each triangle of T, or for `some`."""
    which = slice(None) if some is None else some
    united = comparison.united
    seen = np.bitwise_or.reduce(united.label[united.triangles[which]], axis=1)
    trust = np.select(
        [~comparison.compared[which], seen == 3, seen == 1],
        [Trust.NOT_COMPARED, Trust.BOTH, Trust.ONLY_1],
        default=Trust.ONLY_2,
    )
    return trust.astype(np.uint8)
