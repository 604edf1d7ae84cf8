"""Colours of chains: by their role, or by a number that each has."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.model.view_state import ChainsBy
from app.scene.quiet_colours import palette
from surfcmp_core.colours.maps import Colours, difference_map, height_map, spread

if TYPE_CHECKING:
    from app.scene.chain_table import ChainTable

GOLDEN = 0.6180339887498949
"""Multiples of it modulo 1 spread evenly, however many there are."""
FEW = 30
"""Up to so many chains each has a hue of its own."""
FEW_OPEN = 12
"""Up to so many open ones each has one."""
SHORT, LONG = (0.92, 0.09, 92.0), (0.56, 0.16, 46.0)
"""Lightness, chroma and hue of the shortest chain that is no ring, and of the longest."""
OPEN = (0.47, 0.08, 205.0)


def chain_colours(table: ChainTable, by: ChainsBy, end: float, *, dark: bool) -> Colours:
    """Return one colour for each chain.

    Parameters
    ----------
    table : ChainTable
        C chains.
    by : ChainsBy
    end : float
        Mean of |d| that has the last colour.
    dark : bool
        In a dark window.

    Returns
    -------
    (C, 3) uint8
    """
    missing = palette(dark).no_data
    if by is ChainsBy.LENGTH:
        length = np.log(np.maximum(table.triangles, 1).astype(np.float64))
        return spread(length, 0.0, float(length.max(initial=1.0)), height_map(), missing)
    if by is ChainsBy.MEAN:
        return spread(table.mean_abs, 0.0, end, difference_map(signed=False), missing)
    if by is ChainsBy.ORDER:
        order = np.arange(len(table.closed), dtype=np.float64)
        return spread(order, 0.0, float(len(order)), height_map(), missing)
    return _by_role(table, dark)


def _by_role(table: ChainTable, dark: bool) -> Colours:
    if len(table.closed) <= FEW:
        return hues(table.closed)
    colours = np.empty((len(table.closed), 3), np.uint8)
    colours[table.ring] = palette(dark).ring
    longer = table.closed & ~table.ring
    colours[longer] = by_length(table.triangles[longer])
    opened = ~table.closed
    if opened.sum() <= FEW_OPEN:
        colours[opened] = hues(table.closed)[opened]
    else:
        one = [np.full(int(opened.sum()), part) for part in OPEN]
        colours[opened] = oklch(*one)
    return colours


def by_length(triangles: NDArray[np.int64]) -> Colours:
    """Return (k, 3) colours of one hue, darker the longer, by the logarithm."""
    length = np.log(triangles.astype(np.float64))
    span = float(np.ptp(length)) if length.size else 0.0
    share = (length - length.min()) / span if span > 0.0 else np.zeros(len(length))
    return oklch(*(low + share * (high - low) for low, high in zip(SHORT, LONG, strict=True)))


def hues(closed: NDArray[np.bool_]) -> Colours:
    """Return (C, 3) a hue each: closed ones warm, open ones cool, neighbours far apart."""
    spread_out = (np.arange(len(closed)) * GOLDEN) % 1.0
    second = (np.arange(len(closed)) * GOLDEN * GOLDEN) % 1.0
    hue = np.where(closed, 5.0 + 90.0 * spread_out, 185.0 + 115.0 * spread_out)
    lightness = np.where(closed, 0.66 + 0.16 * second, 0.50 + 0.20 * second)
    return oklch(lightness, np.full(len(closed), 0.135), hue)


def oklch(
    lightness: NDArray[np.float64], chroma: NDArray[np.float64], hue: NDArray[np.float64]
) -> Colours:
    """Return sRGB colours (n, 3) of Oklch coordinates, hue in degrees, clipped to the gamut.

    Source: B. Ottosson, "A perceptual color space for image processing" (2020).
    """
    angle = np.deg2rad(hue)
    a, b = chroma * np.cos(angle), chroma * np.sin(angle)
    lms = np.stack(
        [
            lightness + 0.3963377774 * a + 0.2158037573 * b,
            lightness - 0.1055613458 * a - 0.0638541728 * b,
            lightness - 0.0894841775 * a - 1.2914855480 * b,
        ],
        axis=-1,
    )
    to_rgb = np.array(
        [
            [4.0767416621, -3.3077115913, 0.2309699292],
            [-1.2684380046, 2.6097574011, -0.3413193965],
            [-0.0041960863, -0.7034186147, 1.7076147010],
        ]
    )
    linear = np.clip(lms**3 @ to_rgb.T, 0.0, 1.0)
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return np.asarray(np.rint(encoded * 255).astype(np.uint8))
