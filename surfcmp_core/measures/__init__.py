"""From differences at the nodes of T to the measures."""

from surfcmp_core.measures.exact.overlay import disagreement, measure_exactly
from surfcmp_core.measures.exact.overlay_side import LinearSurface
from surfcmp_core.measures.exact.within import area_within, shares_within
from surfcmp_core.measures.hausdorff import hausdorff
from surfcmp_core.measures.measures import Measures
from surfcmp_core.measures.nodal import measure
from surfcmp_core.measures.totals import Covered, TriangleValues
from surfcmp_core.measures.triangle_area import triangle_areas

__all__ = [
    "Covered",
    "LinearSurface",
    "Measures",
    "TriangleValues",
    "area_within",
    "disagreement",
    "hausdorff",
    "measure",
    "measure_exactly",
    "shares_within",
    "triangle_areas",
]
