"""The measures of one comparison, under the names of the definitions."""

from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class Measures:
    """Every measure of a comparison; lengths in the input's unit, areas and volumes in its powers.

    d = F̂1 − F̂2; sums and means run over the compared triangles only.
    """

    rho_V: float
    """(2) of the paper with µ = 1: sum over the triangles of V / S, length."""
    rho_V_mu: float
    """(1)-(2) with the weight µ, length."""
    rho_delta_V: float
    """(3): the sum over representative triangles only, length."""
    mean_abs: float
    """Area-weighted mean of |d|, length."""
    mean_abs_interface: float
    """The same over representative triangles, length."""
    mean_signed: float
    """Area-weighted mean of d, length."""
    rms: float
    """Root of the area-weighted mean of d², length."""
    max_abs: float
    """Largest |d| at a node of a compared triangle, length."""
    p50: float
    """Area-weighted median of the triangles' mean |d|, length."""
    p90: float
    """90th area-weighted percentile of the same, length."""
    p95: float
    """95th area-weighted percentile of the same, length."""
    within_tolerance: dict[str, float] = field(default_factory=dict)
    """Tolerance (as its shortest decimal) to the share of the compared area with |d| ≤ it."""
    volume_above: float = 0.0
    """∬ of the positive part of d, length³."""
    volume_below: float = 0.0
    """∬ of the negative part of d, as a positive number, length³."""
    area_compared: float = 0.0
    """Area of the compared triangles in the plane, length²."""
    area_interface: float = 0.0
    """Area of the compared representative triangles, length²."""
    coverage_1: float = 0.0
    """Share of surface 1's own footprint that was compared."""
    coverage_2: float = 0.0
    """Share of surface 2's own footprint that was compared."""
    hausdorff_1_2: float = 0.0
    """Largest distance in space from a node of 1 to the nearest node of 2, length."""
    hausdorff_2_1: float = 0.0
    """Largest distance in space from a node of 2 to the nearest node of 1, length."""
    exact: "Measures | None" = None
    """The same measures by the exact reading, over the overlay of T1 and T2, where asked for."""
