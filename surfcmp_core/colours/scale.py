"""The range and the colours of differences: the same in every picture of a comparison."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparing.comparison import Comparison

Colours = NDArray[np.uint8]

NOT_COMPARED = "#a8adb6"
ABOVE = "#d400a0"
BELOW = "#7028e4"
"""Beyond the scale, above and below it."""
WITHIN = (150, 205, 176)
"""The band within the smallest tolerance."""


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
        Whether a picture that shows one map shows the sign.
    """

    end: float
    bands: tuple[float, ...] = ()
    signed: bool = False


def scale_of(comparison: Comparison, document: Mapping[str, Any]) -> Scale:
    """Return the scale the document asks for (its key "scale"), else a fitting one."""
    asked = document.get("scale")
    if asked is None:
        return Scale(scale_end(comparison))
    return Scale(float(asked["end"]), tuple(asked["bands"]), bool(asked["signed"]))


def scale_end(comparison: Comparison) -> float:
    """Return 1, 2 or 5 times a power of ten, with at most a hundredth of the area beyond it."""
    values, area = comparison.mean_abs[comparison.compared], comparison.area[comparison.compared]
    order = np.argsort(values)
    share = np.cumsum(area[order])
    if not share.size or not math.isfinite(share[-1]):
        return 1.0
    value = float(values[order][np.searchsorted(share, 0.99 * share[-1])])
    if not math.isfinite(value) or value <= 0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(value))
    return float(
        f"{next(k for k in (1, 2, 5, 10) if value <= k * power * (1 + 1e-9)) * power:.12g}"
    )


def colour_table(signed: bool) -> Colours:
    """Return the (256, 3) colours of a continuous scale; pale is small, never black."""
    from cmcrameri import cm

    places = np.arange(256) if signed else np.linspace(255, 26, 256).astype(np.intp)
    table = (cm.vik if signed else cm.lajolla)(places)[:, :3]
    colours: Colours = np.rint(255 * table).astype(np.uint8)
    return colours


def band_edges(scale: Scale, signed: bool) -> NDArray[np.float64]:
    """Return the ascending values at which a banded scale changes its colour."""
    up = np.array(scale.bands, dtype=np.float64)
    return np.concatenate([-up[::-1], up]) if signed else up


def band_colours(scale: Scale, signed: bool) -> Colours:
    """Return one colour for each band, one more than `band_edges`; the outer ones are open."""
    k = len(scale.bands)
    table, within = colour_table(signed), np.array([WITHIN], dtype=np.uint8)
    if not signed:
        return np.vstack([within, table[np.linspace(70, 220, k).astype(np.intp)]])
    low, high = np.linspace(20, 96, k).astype(np.intp), np.linspace(160, 235, k).astype(np.intp)
    return np.vstack([table[low], within, table[high]])


def bands_of(values: NDArray[np.float64], scale: Scale, signed: bool) -> NDArray[np.float64]:
    """Return the number of each value's band, NaN for NaN; a limit counts to the one nearer 0."""
    edges = band_edges(scale, signed)
    band = np.searchsorted(edges, values, side="left")
    if signed:
        band = np.where(values < 0, np.searchsorted(edges, values, side="right"), band)
    return np.where(np.isnan(values), np.nan, band)
