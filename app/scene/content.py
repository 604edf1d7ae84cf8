"""A comparison together with what is shown of it and takes long to find."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from app.scene.chain_table import ChainTable, chain_table
from app.scene.distribution import Distributions, distributions_of
from app.scene.geometry import Geometry, geometry_of

if TYPE_CHECKING:
    from surfcmp_core.comparison import Comparison


@dataclass(frozen=True, slots=True, eq=False)
class Content:
    """What the views and panels show."""

    comparison: Comparison
    geometry: Geometry
    distributions: Distributions
    chains: ChainTable
    counts: dict[str, int]


def content_of(comparison: Comparison, geometry: Geometry | None = None) -> Content:
    """Return the comparison ready to be shown; `geometry` where it is known."""
    return Content(
        comparison,
        geometry or geometry_of(comparison),
        distributions_of(comparison),
        chain_table(comparison),
        comparison.counts,
    )
