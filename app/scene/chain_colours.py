"""A colour for each chain: closed ones warm, open ones cool, neighbours in number far apart."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.colours.maps import Colours

GOLDEN = 0.6180339887498949
"""Multiples of it modulo 1 spread evenly, however many there are."""


def chain_colours(closed: NDArray[np.bool_]) -> Colours:
    """Return one colour for each chain.

    Parameters
    ----------
    closed : (C,) bool

    Returns
    -------
    (C, 3) uint8
    """
    spread = (np.arange(len(closed)) * GOLDEN) % 1.0
    second = (np.arange(len(closed)) * GOLDEN * GOLDEN) % 1.0
    hue = np.where(closed, 5.0 + 90.0 * spread, 185.0 + 115.0 * spread)
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
