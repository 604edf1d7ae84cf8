"""What a reader of one format hands over, before it is believed."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True, eq=False)
class Raw:
    """Nodes and polygons as a file holds them: neither finite nor in range for sure."""

    points: NDArray[np.float64]
    """(n, 3) x, y, z."""
    polygons: list[NDArray[np.integer]] = field(default_factory=list)
    """Polygons grouped by size: each (k, c) node numbers, k polygons of c corners."""
    comments: tuple[str, ...] = ()
    """Lines of comment, which may state a unit and axes."""
    unit: str | None = None
    """Unit to tell and to leave the coordinates in."""
    georeferenced: bool = False
    """Whether `unit` is that of a geodetic reference system."""
    keeps_unit: bool = False
    """Whether the coordinates are to be left in the unit that the comments state, too."""
    refused: str = ""
    """Why the coordinates cannot be lengths in one unit, where the file says so."""
    dropped: dict[str, int] = field(default_factory=dict)
    """Nodes that are left out, counted by reason."""
    changed: dict[str, int] = field(default_factory=dict)
    """What was left out or split besides, counted."""
