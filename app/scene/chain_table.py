"""One row for each chain."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.scene.chain_colours import chain_colours
from app.scene.geometry import Geometry
from surfcmp_core.colours.maps import Colours

if TYPE_CHECKING:
    from surfcmp_core.comparing.comparison import Comparison

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class ChainTable:
    """C chains, columns of equal length.

    Attributes
    ----------
    closed : (C,) bool
    triangles : (C,) int64
        Length: how many triangles.
    area : (C,) float64
        Of its compared triangles.
    mean_abs : (C,) float64
        Area-weighted mean of |d| over them; NaN where none is compared.
    share : (C,) float64
        Its part of ∬|d| over all compared triangles.
    colours : (C, 3) uint8
    """

    closed: NDArray[np.bool_]
    triangles: NDArray[np.int64]
    area: Floats
    mean_abs: Floats
    share: Floats
    colours: Colours


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
    colours = chain_colours(closed)
    return ChainTable(closed, triangles.astype(np.int64), area, mean_abs, share, colours)


def chain_box(comparison: Comparison, geometry: Geometry, chain: int) -> tuple[Floats, Floats]:
    """Return the corners of the box around a chain, in the scene's coordinates."""
    nodes = comparison.united.triangles[comparison.united.chain == chain].ravel()
    points = geometry.patches[2].points[nodes].astype(np.float64)
    return points.min(axis=0), points.max(axis=0)
