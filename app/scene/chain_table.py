"""One row for each chain."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.scene.geometry import Geometry

if TYPE_CHECKING:
    from surfcmp_core.comparing.comparison import Comparison

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class ChainTable:
    """C chains, columns of equal length.

    Attributes
    ----------
    closed : (C,) bool
    ring : (C,) bool
        Closed round one single node.
    triangles : (C,) int64
        Length: how many triangles.
    area : (C,) float64
        Of its compared triangles.
    mean_abs : (C,) float64
        Area-weighted mean of |d| over them; NaN where none is compared.
    share : (C,) float64
        Its part of ∬|d| over all compared triangles.
    """

    closed: NDArray[np.bool_]
    ring: NDArray[np.bool_]
    triangles: NDArray[np.int64]
    area: Floats
    mean_abs: Floats
    share: Floats

    @property
    def counts(self) -> dict[str, int]:
        """How many there are of each kind."""
        rings = int(self.ring.sum())
        closed = int(self.closed.sum())
        return {"rings": rings, "longer": closed - rings, "open": len(self.closed) - closed}


def chain_table(comparison: Comparison) -> ChainTable:
    """Return the table of a comparison's chains."""
    chain = comparison.united.chain
    closed = comparison.united.chain_closed
    count = len(closed)
    inside = chain >= 0
    counted = inside & comparison.compared
    area = np.bincount(chain[counted], comparison.area[counted], minlength=count)
    volume = comparison.mean_abs * comparison.area
    volumes = np.bincount(chain[counted], volume[counted], minlength=count)
    with np.errstate(invalid="ignore", divide="ignore"):
        mean_abs = volumes / area
        share = volumes / np.nansum(volume)
    triangles = np.bincount(chain[inside], minlength=count)
    ring = closed & _round_one_node(comparison.united.triangles[inside], chain[inside], count)
    return ChainTable(closed, ring, triangles.astype(np.int64), area, mean_abs, share)


def _round_one_node(
    triangles: NDArray[np.int32], chain: NDArray[np.int32], count: int
) -> NDArray[np.bool_]:
    """Tell of each chain whether all its triangles have one node in common.

    It would be one of the nodes of the chain's first triangle.
    """
    found = np.zeros(count, np.bool_)
    if not len(triangles):
        return found
    numbers, first = np.unique(chain, return_index=True)
    length = np.bincount(chain, minlength=count)
    for corner in range(3):
        node = np.full(count, -1, np.int32)
        node[numbers] = triangles[first, corner]
        has = (triangles == node[chain][:, None]).any(axis=1)
        found |= (np.bincount(chain[has], minlength=count) == length) & (length > 0)
    return found


def chain_box(comparison: Comparison, geometry: Geometry, chain: int) -> tuple[Floats, Floats]:
    """Return the corners of the box around a chain, in the scene's coordinates."""
    nodes = comparison.united.triangles[comparison.united.chain == chain].ravel()
    points = geometry.patches[2].points[nodes].astype(np.float64)
    return points.min(axis=0), points.max(axis=0)
