"""T1 and T2: the unique Delaunay triangulation of a grid, with half-edges and ghosts."""

from surfcmp_core.triangulation.triangulation import Triangulation, is_flat, triangulate

__all__ = ["Triangulation", "is_flat", "triangulate"]
