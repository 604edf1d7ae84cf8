"""The range and the colours of differences: the same in every picture of a comparison."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.colours.maps import WITHIN, Colours, Rgb, difference_map, spread

if TYPE_CHECKING:  # the window has colours before kernels are loaded
    from surfcmp_core.comparing.comparison import Comparison

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Scale:
    """From 0 to `end`, or from -`end` to `end` where the sign is shown.

    Attributes
    ----------
    end : float
        Largest difference that has a colour of its own, in the unit of the input.
    bands : tuple of float
        Ascending; the colour changes at these and nowhere else. Empty: a continuous scale.
    signed : bool
        Whether the sign is shown.
    """

    end: float
    bands: tuple[float, ...] = ()
    signed: bool = False

    @property
    def low(self) -> float:
        """Least difference that has a colour of its own."""
        return -self.end if self.signed else 0.0


def scale_of(comparison: "Comparison", document: Mapping[str, Any]) -> Scale:
    """Return the scale the document asks for (its key "scale"), else a fitting one."""
    asked = document.get("scale")
    if asked is None:
        return Scale(scale_end(comparison))
    return Scale(float(asked["end"]), tuple(asked["bands"]), bool(asked["signed"]))


def scale_end(comparison: "Comparison") -> float:
    """Return a fitting end for the absolute differences of a comparison."""
    values, area = comparison.mean_abs[comparison.compared], comparison.area[comparison.compared]
    order = np.argsort(values)
    return fitting_end(values[order], np.cumsum(area[order]))


def fitting_end(values: Floats, areas: Floats) -> float:
    """Return a round number with at most a hundredth of the area beyond it.

    Parameters
    ----------
    values : (k,) float64
        Ascending.
    areas : (k,) float64
        Of the first 1, ..., k values together.
    """
    if not areas.size or not math.isfinite(areas[-1]):
        return 1.0
    return round_up(float(values[np.searchsorted(areas, 0.99 * areas[-1])]))


def round_up(value: float) -> float:
    """Return the smallest of 1, 2, 5 times a power of ten that is at least `value`."""
    if not math.isfinite(value) or value <= 0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(value))
    step = next(k for k in (1, 2, 5, 10) if value <= k * power * (1 + 1e-9))
    return float(f"{step * power:.12g}")


def band_edges(scale: Scale) -> Floats:
    """Return the ascending values at which a banded scale changes its colour."""
    up = np.array(scale.bands, dtype=np.float64)
    return np.concatenate([-up[::-1], up]) if scale.signed else up


def band_colours(scale: Scale) -> Colours:
    """Return one colour for each band, one more than `band_edges`; the outer ones are open."""
    k = len(scale.bands)
    table, within = difference_map(scale.signed), np.array([WITHIN], dtype=np.uint8)
    if not scale.signed:
        return np.vstack([within, table[np.linspace(70, 220, k).astype(np.intp)]])
    low, high = np.linspace(20, 96, k).astype(np.intp), np.linspace(160, 235, k).astype(np.intp)
    return np.vstack([table[low], within, table[high]])


def bands_of(values: Floats, scale: Scale) -> Floats:
    """Return the number of each value's band, NaN for NaN; a limit counts to the one nearer 0."""
    edges = band_edges(scale)
    band = np.searchsorted(edges, values, side="left")
    if scale.signed:
        band = np.where(values < 0, np.searchsorted(edges, values, side="right"), band)
    return np.where(np.isnan(values), np.nan, band)


def coloured(values: Floats, scale: Scale, missing: Rgb) -> Colours:
    """Return the (n, 3) colours of differences; NaN takes `missing`."""
    if not scale.bands:
        return spread(values, scale.low, scale.end, difference_map(scale.signed), missing)
    table = np.vstack([band_colours(scale), np.array([missing], dtype=np.uint8)])
    band = np.nan_to_num(bands_of(values, scale), nan=len(table) - 1)
    return np.asarray(table[band.astype(np.intp)])
