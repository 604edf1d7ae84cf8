"""How much of a surface one view shows."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.projection.flat_bits import Samples
from surfcmp_core.projection.frame import frame

_EACH_PIXEL = 4.0
"""Bits in front that a pixel of the depth buffer gets on average."""
_GRAZING = 0.01
"""Cosine between view and normal below which a bit counts as seen in part only."""
_WHOLE = 3
"""How often the share of a connected part that is seen is squared: parts are to be seen whole."""
_EDGE_ON = 1e-9
"""Cosine below which a bit is not seen: more than rounding, less than any real slope."""


@kernel
def side_of_pixels(wide: float, high: float, bits: int) -> float:
    """Choose a depth buffer's pixels: no more of them than bits, however thin the view is."""
    side = np.sqrt(wide * high * _EACH_PIXEL / bits)
    return float(max(side, max(wide, high) / bits, 1e-300))


@kernel
def _seen(
    places: NDArray[np.float64],
    normals: NDArray[np.float64],
    areas: NDArray[np.float64],
    pieces: NDArray[np.int32],
    axes: NDArray[np.float64],
    seen: NDArray[np.float64],
) -> float:
    n = places.shape[0]
    at = np.empty((n, 4))
    front = 0
    low_u = low_v = np.inf
    high_u = high_v = -np.inf
    for i in range(n):
        facing = (
            axes[2, 0] * normals[i, 0] + axes[2, 1] * normals[i, 1] + axes[2, 2] * normals[i, 2]
        )
        at[i, 3] = facing
        if facing <= _EDGE_ON:
            continue
        for k in range(3):
            at[i, k] = (
                axes[k, 0] * places[i, 0] + axes[k, 1] * places[i, 1] + axes[k, 2] * places[i, 2]
            )
        front += 1
        low_u = min(low_u, at[i, 0])
        high_u = max(high_u, at[i, 0])
        low_v = min(low_v, at[i, 1])
        high_v = max(high_v, at[i, 1])
    if front == 0:
        return 0.0
    side = side_of_pixels(high_u - low_u, high_v - low_v, front)
    wide = int((high_u - low_u) / side) + 1
    high = int((high_v - low_v) / side) + 1
    top = np.full(wide * high, -np.inf)
    pixel = np.empty(n, np.int64)
    reach = np.empty(n)
    for i in range(n):
        facing = at[i, 3]
        if facing <= _EDGE_ON:
            continue
        column = int((at[i, 0] - low_u) / side)
        row = int((at[i, 1] - low_v) / side)
        pixel[i] = row * wide + column
        # how far its plane may rise or fall within the pixel: a steep sheet does not hide itself
        reach[i] = np.sqrt(2.0 * max(0.0, 1.0 - facing * facing)) / facing * side
        top[pixel[i]] = max(top[pixel[i]], at[i, 2] - reach[i])
    shadow = 0.0
    for i in range(n):
        facing = at[i, 3]
        if facing > _EDGE_ON and at[i, 2] + reach[i] + 2.0 * side >= top[pixel[i]]:
            seen[pieces[i]] += areas[i] * min(facing / _GRAZING, 1.0)
            shadow += areas[i] * facing
    return shadow


def seen(
    samples: Samples, direction: NDArray[np.float64], *, whole: bool = True
) -> tuple[float, float]:
    """Judge how much of a surface is seen from far along a direction.

    A bit of the surface is seen where it faces the viewer and no other one that does lies in front
    of it.

    Parameters
    ----------
    samples : Samples
    direction : (3,) float64
        Towards the viewer; unit.
    whole : bool
        Weigh each connected part by a high power of the share of it that is seen: a view that shows
        one sheet whole and hides the other outdoes one that shows most of both.

    Returns
    -------
    seen : float
        Area that is seen, as a share of the whole area.
    shadow : float
        Area that what is seen covers in the plane of the view, as a share of the whole area.
    """
    axes = np.ascontiguousarray(frame(direction)[:3, :3])
    by_piece = np.zeros(int(samples.pieces.max()) + 1)
    shadow = _seen(samples.places, samples.normals, samples.areas, samples.pieces, axes, by_piece)
    if not whole:
        return float(by_piece.sum()), shadow
    areas = np.bincount(samples.pieces, samples.areas)
    share = by_piece / areas
    for _ in range(_WHOLE):
        share = share * share
    return float((share * areas).sum()), shadow
