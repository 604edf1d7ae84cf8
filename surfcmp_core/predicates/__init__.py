"""Exact predicates on nodes in the plane: the only geometry the merge rests on.

Each has a floating-point filter and an exact fall-back in expansions. They are exact for
coordinates that :func:`surfcmp_core.grid.safe_range.safe_scale` accepts. Ties among cocircular
nodes are broken by the coordinates alone, so that the Delaunay triangulation of a set of distinct
nodes is unique.
"""

from surfcmp_core.predicates.in_circle import LENGTHS_FILTER, in_circle, in_disc
from surfcmp_core.predicates.lengths import compare_lengths
from surfcmp_core.predicates.orientation import orientation, twice_area
from surfcmp_core.predicates.scalar_product import scalar_product
from surfcmp_core.predicates.tangent_circles import CIRCLES_FILTER, compare_tangent_circles

__all__ = [
    "CIRCLES_FILTER",
    "LENGTHS_FILTER",
    "compare_lengths",
    "compare_tangent_circles",
    "in_circle",
    "in_disc",
    "orientation",
    "scalar_product",
    "twice_area",
]
