"""Which side of a surface is looked at: its front, or its back."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.compiled.linear_algebra import dots, length, weighed_sum
from surfcmp_core.projection.flat_bits import Samples, samples_of
from surfcmp_core.projection.view import side_of_pixels
from surfcmp_core.surface import Surface

_CLOSED = 0.25
"""A mesh whose vector area is below this share of its area counts as closed."""
_SURE = 0.5
"""Backs outweigh fronts in the view by this share of both, or the reverse, where no doubt is left
which side is looked at: three quarters are of one kind."""
_EDGE_ON = 1e-9
"""Cosine below which a bit is not seen."""


def seen_from_behind(*surfaces: Surface) -> tuple[bool, ...]:
    """Tell which of one or two surfaces a viewer at z = +∞ looks at from their backs.

    The front is the side from which triangles wind counter-clockwise. Of a closed mesh the outside
    is looked at, and the file's triangles are to be turned over where their fronts are inside. Of
    an open one either side may be looked at: the one of which more is seen, nothing lying before
    it. Where the two surfaces then differ, and one of them shows nearly as much of one side as of
    the other, it goes by the other surface: both are compared on one side. Where neither leaves
    any doubt, their triangles wind against each other.

    Parameters
    ----------
    *surfaces : Surface
        One or two, in the view's coordinates.

    Returns
    -------
    bool of each
        False for a cloud.
    """
    balances = [_balance(samples_of(surface)) for surface in surfaces]
    turned = [balance < 0.0 for balance in balances]
    meshes = [k for k, surface in enumerate(surfaces) if surface.faces is not None]
    if len(meshes) == 2 and turned[0] != turned[1]:
        weaker = min(meshes, key=lambda k: abs(balances[k]))
        if abs(balances[weaker]) < _SURE:
            turned[weaker] = turned[1 - weaker]
    return tuple(turned)


def _balance(samples: Samples | None) -> float:
    """Give the share of what is seen by which fronts outweigh backs, from -1 to 1."""
    if samples is None:
        return 0.0
    if length(weighed_sum(samples.areas, samples.normals)) < _CLOSED:
        volume = (samples.areas * dots(samples.places, samples.normals)).sum()
        return 1.0 if volume >= 0.0 else -1.0
    front, back = _sides_seen(samples.places, samples.normals, samples.areas)
    return (front - back) / (front + back) if front + back > 0.0 else 0.0


@kernel
def _sides_seen(
    places: NDArray[np.float64], normals: NDArray[np.float64], areas: NDArray[np.float64]
) -> tuple[float, float]:
    """Give the area in the plane of the fronts and of the backs that are seen, by a depth buffer.

    Whatever lies in front hides what is behind, whichever side it shows.
    """
    n = places.shape[0]
    low_u = low_v = np.inf
    high_u = high_v = -np.inf
    count = 0
    for i in range(n):
        if abs(normals[i, 2]) > _EDGE_ON:
            count += 1
            low_u, high_u = min(low_u, places[i, 0]), max(high_u, places[i, 0])
            low_v, high_v = min(low_v, places[i, 1]), max(high_v, places[i, 1])
    if count == 0:
        return 0.0, 0.0
    side = side_of_pixels(high_u - low_u, high_v - low_v, count)
    wide = int((high_u - low_u) / side) + 1
    top = np.full(wide * (int((high_v - low_v) / side) + 1), -np.inf)
    pixel = np.empty(n, np.int64)
    reach = np.empty(n)
    for i in range(n):
        facing = abs(normals[i, 2])
        if facing > _EDGE_ON:
            column, row = int((places[i, 0] - low_u) / side), int((places[i, 1] - low_v) / side)
            pixel[i] = row * wide + column
            # how far its plane may rise or fall within the pixel
            reach[i] = np.sqrt(2.0 * max(0.0, 1.0 - facing * facing)) / facing * side
            top[pixel[i]] = max(top[pixel[i]], places[i, 2] - reach[i])
    front = 0.0
    back = 0.0
    for i in range(n):
        facing = normals[i, 2]
        if abs(facing) > _EDGE_ON and places[i, 2] + reach[i] + 2.0 * side >= top[pixel[i]]:
            if facing > 0.0:
                front += areas[i] * facing
            else:
                back -= areas[i] * facing
    return front, back
