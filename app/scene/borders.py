"""Where regions end."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.colours.maps import Rgb


def borders_of(
    triangles: NDArray[np.int32], region: NDArray[np.int32], colours: list[Rgb]
) -> tuple[tuple[NDArray[np.int32], Rgb], ...]:
    """Return for each region the sides of triangles (k, 2) between it and what it is not."""
    if not colours:
        return ()
    found = []
    for k, colour in enumerate(colours):
        mine = triangles[region == k].astype(np.int64)
        ends = mine[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
        sides = np.sort((ends.min(axis=1) << 32) | ends.max(axis=1))
        changes = np.ones(len(sides) + 1, dtype=bool)
        changes[1:-1] = sides[1:] != sides[:-1]
        once = sides[changes[1:] & changes[:-1]]
        outline = np.stack([once >> 32, once & 0xFFFFFFFF], axis=1)
        found.append((outline.astype(np.int32), colour))
    return tuple(found)
