"""Grids: distinct nodes in the plane with one value each."""

from surfcmp_core.grid.grid import Grid, grid_of

__all__ = ["Grid", "grid_of"]
