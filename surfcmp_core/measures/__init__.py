"""From differences at the nodes of T to the measures."""

from surfcmp_core.measures.hausdorff import hausdorff
from surfcmp_core.measures.measure import measure
from surfcmp_core.measures.measures import Measures
from surfcmp_core.measures.overlay import measure_exactly
from surfcmp_core.measures.overlay_side import LinearSurface
from surfcmp_core.measures.totals import TriangleValues
from surfcmp_core.measures.triangle_area import triangle_areas

__all__ = [
    "LinearSurface",
    "Measures",
    "TriangleValues",
    "hausdorff",
    "measure",
    "measure_exactly",
    "triangle_areas",
]
