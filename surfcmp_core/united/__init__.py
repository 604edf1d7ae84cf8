"""T: the united Delaunay triangulation of both grids and its chains."""

from surfcmp_core.united.united import United, unite

__all__ = ["United", "unite"]
