"""Colour-blind-safe colour maps and the colours of quantities.

The maps are F. Crameri's "Scientific colour maps" (cmcrameri); their tables are read directly,
because importing the package costs a third of a second of matplotlib.
"""

from functools import cache
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.model.view_state import Heatmap, Scale

Colours = NDArray[np.uint8]
Rgb = tuple[int, int, int]

ABOVE: Rgb = (212, 0, 160)
"""Beyond the scale, on the positive side."""
BELOW: Rgb = (112, 40, 228)
"""Beyond the scale, on the negative side."""
WITHIN: Rgb = (150, 205, 176)
"""The band within the smallest tolerance."""


@cache
def colour_map(name: str) -> Colours:
    """Return the (256, 3) table of the map called `name`."""
    spec = find_spec("cmcrameri")
    if spec is None or not spec.submodule_search_locations:
        raise ModuleNotFoundError("cmcrameri")
    table = Path(next(iter(spec.submodule_search_locations))) / "cmaps" / f"{name}.txt"
    return np.rint(np.loadtxt(table) * 255).astype(np.uint8)


def map_of(heatmap: Heatmap) -> Colours:
    """Return the table that `heatmap` is drawn with."""
    if heatmap is Heatmap.SIGNED:
        return colour_map("vik")
    if heatmap in {Heatmap.HEIGHT_1, Heatmap.HEIGHT_2}:
        return colour_map("batlow")
    stops = np.linspace(255, 26, 256).astype(np.intp)  # pale is small; black would hide the shading
    return np.asarray(colour_map("lajolla")[stops])


def band_edges(scale: Scale, signed: bool) -> NDArray[np.float64]:
    """Return the ascending values at which a banded scale changes its colour."""
    up = np.array(sorted(scale.tolerances), dtype=np.float64)
    return np.concatenate([-up[::-1], up]) if signed else up


def band_colours(scale: Scale, signed: bool) -> Colours:
    """Return one colour for each band, one more than `band_edges`; the outer ones are open."""
    k = len(scale.tolerances)
    within = np.array([WITHIN], np.uint8)
    if signed:
        low = colour_map("vik")[np.linspace(20, 96, k).astype(np.intp)]
        high = colour_map("vik")[np.linspace(160, 235, k).astype(np.intp)]
        return np.vstack([low, within, high])
    return np.vstack([within, map_of(Heatmap.ABSOLUTE)[np.linspace(70, 220, k).astype(np.intp)]])


def continuous(
    values: NDArray[np.float64], low: float, high: float, table: Colours, missing: Rgb
) -> Colours:
    """Return the (n, 3) colours of `values` on [low, high]; beyond it `BELOW` and `ABOVE`.

    NaN takes `missing`.
    """
    span = high - low or 1.0
    place = np.nan_to_num((values - low) * (len(table) / span), nan=0.0)
    colours = table[np.clip(place, 0, len(table) - 1).astype(np.intp)]
    colours[values > high] = ABOVE
    colours[values < low] = BELOW
    colours[np.isnan(values)] = missing
    return np.asarray(colours)


def banded(values: NDArray[np.float64], scale: Scale, signed: bool, missing: Rgb) -> Colours:
    """Return the (n, 3) colours of `values` in the bands of `scale`; a limit itself is within."""
    edges = band_edges(scale, signed)
    band = np.searchsorted(edges, values, side="left")
    if signed:  # a negative limit, too, counts to the band nearer zero
        negative = values < 0
        band[negative] = np.searchsorted(edges, values[negative], side="right")
    colours = band_colours(scale, signed)[np.minimum(band, len(edges))]
    colours[np.isnan(values)] = missing
    return np.asarray(colours)
