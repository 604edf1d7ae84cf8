"""T1 and T2: the unique Delaunay triangulation of a grid, with half-edges and ghosts."""

from surfcmp_core.triangulation.triangulation import Triangulation, triangulate

__all__ = ["Triangulation", "triangulate"]
