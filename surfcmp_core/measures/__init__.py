"""From differences at the nodes of T to the measures."""

from surfcmp_core.measures.hausdorff import hausdorff
from surfcmp_core.measures.measure import TriangleValues, measure
from surfcmp_core.measures.measures import Measures
from surfcmp_core.measures.triangle_area import triangle_areas

__all__ = ["Measures", "TriangleValues", "hausdorff", "measure", "triangle_areas"]
