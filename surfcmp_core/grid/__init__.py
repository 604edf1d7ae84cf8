"""Grids: distinct nodes in the plane with one value each."""

from surfcmp_core.grid.grid import Grid, box_of, grid_of
from surfcmp_core.grid.safe_range import safe_scale
from surfcmp_core.grid.shared import shared_nodes

__all__ = ["Grid", "box_of", "grid_of", "safe_scale", "shared_nodes"]
