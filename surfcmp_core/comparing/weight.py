"""A weight µ(x, y) from the nodes of a surface file."""

from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparing.options import Weight
from surfcmp_core.errors import InputError
from surfcmp_core.grid import grid_of, safe_scale
from surfcmp_core.interpolation import interpolate
from surfcmp_core.io import read_surface
from surfcmp_core.localisation import locate_along_tree
from surfcmp_core.surface import Duplicates
from surfcmp_core.surface.refusals import refuse_surface
from surfcmp_core.surface.used import without_unused
from surfcmp_core.triangulation import triangulate


def read_weight(path: Path, duplicates: Duplicates = "refuse") -> Weight:
    """Read µ, the third column of a surface file.

    Parameters
    ----------
    path
        Any readable surface file; x, y in the comparison's plane and unit, whatever unit the file
        states. Its own triangles, if any, only tell which of its nodes count.
    duplicates
        What to do with different weights at one place.

    Returns
    -------
    Weight
        Linear between the file's nodes (on their Delaunay triangulation), and outside their hull
        the value at its nearest place.

    Raises
    ------
    InputError
        The file cannot be read, or holds a weight below zero.
    """
    surface = without_unused(read_surface(path, unit="mm", weights=True))  # mm: nothing converted
    refuse_surface(replace(surface, name=str(path)))
    grid = grid_of(surface, duplicates=duplicates)
    if (grid.z < 0).any():
        below = int((grid.z < 0).sum())
        raise InputError(f"{below} weights are below zero", where=(str(path),))

    def weight(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
        places = np.column_stack([x, y])
        try:
            scale = safe_scale(grid.nodes, places)
            triangulation = triangulate(grid.nodes * scale, name=str(path))
        except InputError as fault:
            raise fault.at(str(path)) from None
        # The nodes of T come along a curve, so each is searched from the one before.
        steps = np.arange(len(places), dtype=np.int32)
        path_ = np.column_stack([steps[:-1], steps[1:]])
        found = locate_along_tree(triangulation, places * scale, path_)
        return interpolate(triangulation, grid.z, places * scale, found, continued=True)

    return weight
