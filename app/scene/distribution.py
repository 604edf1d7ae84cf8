"""How much area has which difference; any histogram and any share follow at once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.colours.scale import fitting_end

if TYPE_CHECKING:
    from surfcmp_core.comparing.comparison import Comparison

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Distribution:
    """Values in ascending order, and the share of the area up to each.

    Attributes
    ----------
    values : (k,) float64
    shares : (k + 1,) float64
        Share of the area of the first 0, 1, ..., k values; the last is 1.
    """

    values: Floats
    shares: Floats

    def below(self, limits: Floats) -> Floats:
        """Return the share of the area with a value of at most each limit."""
        return np.asarray(self.shares[np.searchsorted(self.values, limits, side="right")])

    def histogram(self, edges: Floats) -> Floats:
        """Return the share of the area between neighbouring edges; what lies beyond is left out.

        A value on an edge counts to the bin below it.
        """
        return np.diff(self.below(edges))

    def within(self, low: float, high: float) -> float:
        """Return the share of the area with values in [low, high]."""
        first = np.searchsorted(self.values, low, side="left")
        last = np.searchsorted(self.values, high, side="right")
        return float(self.shares[max(last, first)] - self.shares[first])


def distribution_of(values: Floats, areas: Floats) -> Distribution:
    """Return the distribution of (M,) values over (M,) areas; NaN is left out."""
    known = np.isfinite(values) & np.isfinite(areas)
    order = np.argsort(values[known])
    total = np.concatenate([[0.0], np.cumsum(areas[known][order])])
    return Distribution(values[known][order], total / (total[-1] or 1.0))


@dataclass(frozen=True, slots=True, eq=False)
class Distributions:
    """Of the triangles' signed and absolute means."""

    signed: Distribution
    absolute: Distribution

    @property
    def fitting_end(self) -> float:
        """A round end of a scale that leaves at most a hundredth of the area beyond it."""
        return fitting_end(self.absolute.values, self.absolute.shares[1:])


def distributions_of(comparison: Comparison) -> Distributions:
    """Return both distributions of a comparison."""
    return Distributions(
        distribution_of(comparison.mean_signed, comparison.area),
        distribution_of(comparison.mean_abs, comparison.area),
    )
