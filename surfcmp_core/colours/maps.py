"""Colour-blind-safe tables of colours, and those of what lies beyond them.

The maps are F. Crameri's "Scientific colour maps" (cmcrameri); their tables are read directly,
because importing the package costs a third of a second of matplotlib.
"""

from functools import cache
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Colours = NDArray[np.uint8]
"""(n, 3)."""
Rgb = tuple[int, int, int]

ABOVE: Rgb = (212, 0, 160)
"""Beyond the scale, on the positive side."""
BELOW: Rgb = (112, 40, 228)
"""Beyond the scale, on the negative side."""
WITHIN: Rgb = (150, 205, 176)
"""The band within the smallest tolerance."""
NOT_COMPARED: Rgb = (168, 173, 182)
"""On a light ground."""


@cache
def colour_map(name: str) -> Colours:
    """Return the (256, 3) table of the map called `name`."""
    spec = find_spec("cmcrameri")
    if spec is None or not spec.submodule_search_locations:
        raise ModuleNotFoundError("cmcrameri")
    table = Path(next(iter(spec.submodule_search_locations))) / "cmaps" / f"{name}.txt"
    return np.rint(np.loadtxt(table) * 255).astype(np.uint8)


def height_map() -> Colours:
    """Return the (256, 3) colours of heights."""
    return colour_map("batlow")


def difference_map(signed: bool) -> Colours:
    """Return the (256, 3) colours of differences: from zero, or with zero in the middle."""
    if signed:
        return colour_map("vik")
    stops = np.linspace(255, 26, 256).astype(np.intp)  # pale is small; black would hide the shading
    return np.asarray(colour_map("lajolla")[stops])


def spread(
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
