"""A comparison together with what is shown of it and takes long to find."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.scene.borders import borders_of
from app.scene.chain_table import ChainTable, chain_table
from app.scene.distribution import Distributions, distributions_of
from app.scene.geometry import Geometry, geometry_of
from app.scene.once import Once
from surfcmp_core.colours.maps import Rgb, difference_map

if TYPE_CHECKING:
    from surfcmp_core.comparing.comparison import Comparison


@dataclass(frozen=True, slots=True, eq=False)
class Content:
    """What the views and panels show."""

    comparison: Comparison
    geometry: Geometry
    distributions: Distributions
    chains: ChainTable
    counts: dict[str, int]
    borders: tuple[tuple[NDArray[np.int32], Rgb], ...] = ()
    """Sides of T around each region, and its colour."""
    once: Once = field(default_factory=Once, init=False)
    """What is found for the views: it ends with the content."""


def content_of(
    comparison: Comparison,
    geometry: Geometry | None = None,
    region: NDArray[np.int32] | None = None,
    colours: Sequence[Rgb] = (),
) -> Content:
    """Return the comparison ready to be shown; `geometry` where it is known.

    `region` gives each triangle's region (-1: none), `colours` those of the regions.
    """
    from surfcmp_core.comparing.clock import at_once

    borders: tuple[tuple[NDArray[np.int32], Rgb], ...] = ()
    if region is not None:
        borders = borders_of(comparison.united.triangles, region, list(colours))
    difference_map(signed=True)  # is read from its file here, beside the window
    shape, (distributions, chains) = at_once(
        lambda: geometry or geometry_of(comparison),
        lambda: (distributions_of(comparison), chain_table(comparison)),
        comparison.options.threads,
    )
    return Content(comparison, shape, distributions, chains, comparison.counts, borders)
