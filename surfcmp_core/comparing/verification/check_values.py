"""F̂ and the Hausdorff distances, at some nodes, by fractions and by trying all."""

from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.comparing.verification.holds import hold
from surfcmp_core.grid import safe_scale
from surfcmp_core.localisation import locate_from
from surfcmp_core.triangulation import Triangulation

_SOME = 200
"""Nodes of either grid that are asked about, evenly along the curve."""
_WEIGHTS = 2.0**-45
_LAST_BIT = 2.0**-52
_LEAST = 3.0 * 2.0**-1074
"""Steps of the smallest numbers, one for each that rounds."""


def check_values(comparison: Comparison) -> None:
    """Check F̂ at some nodes of the other grid by exact weights, and no node is too far off.

    Parameters
    ----------
    comparison : Comparison

    Raises
    ------
    Violation
    """
    united, measures = comparison.united, comparison.measures
    owns, zs = (united.node_1, united.node_2), (comparison.z1, comparison.z2)
    farthest = measures.hausdorff_2_1, measures.hausdorff_1_2
    for which in (0, 1):
        own, other, z = owns[which], owns[1 - which], zs[which]
        grid, opposite = comparison.grids[which], comparison.grids[1 - which]
        hold(np.array_equal(z[own], grid.z), "F̂ is not F at a surface's own nodes")
        some = np.linspace(0, len(other) - 1, min(_SOME, len(other))).astype(np.int64)
        asked = some[united.label[other[some]] != 3]
        triangulation = comparison.triangulations[which]
        _check_interpolated(triangulation, grid.z, opposite.nodes[asked], z[other[asked]])
        for k in some.tolist():
            away = grid.nodes - opposite.nodes[k]
            off = (away * away).sum(axis=1) + np.square(grid.z - opposite.z[k])
            distance = float(np.sqrt(off.min()))
            hold(
                distance <= farthest[which] * (1.0 + 4.0 * _LAST_BIT),
                f"a node is {distance!r} away, the Hausdorff distance {farthest[which]!r}",
            )


def _check_interpolated(
    triangulation: Triangulation,
    z: NDArray[np.float64],
    places: NDArray[np.float64],
    values: NDArray[np.float64],
) -> None:
    """Where a place lies in a triangle, its value is the mean of the corners', by fractions."""
    t = triangulation
    scale = safe_scale(t.nodes, places)
    scaled = Triangulation(t.nodes * scale, t.start, t.twin, t.real)
    found = locate_from(scaled, places * scale, np.zeros(len(places), np.int32))
    for k in np.flatnonzero((found < t.real) & ~np.isnan(values)).tolist():
        corners = t.triangles[found[k]]
        (ax, ay), (bx, by), (cx, cy) = (tuple(map(Fraction, t.nodes[v].tolist())) for v in corners)
        px, py = map(Fraction, places[k].tolist())
        whole = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        at_b = ((px - ax) * (cy - ay) - (cx - ax) * (py - ay)) / whole
        at_c = ((bx - ax) * (py - ay) - (px - ax) * (by - ay)) / whole
        a, b, c = (Fraction(float(z[v])) for v in corners)
        exact = float(a + at_b * (b - a) + at_c * (c - a))
        slack = _WEIGHTS * float(np.ptp(z[corners])) + _LAST_BIT * abs(exact) + _LEAST
        hold(
            min(at_b, at_c, 1 - at_b - at_c) >= 0 and abs(float(values[k]) - exact) <= slack,
            f"F̂ is {float(values[k])!r} where it should be {exact!r}",
        )
