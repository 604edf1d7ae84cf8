"""Plain names of the measures; their meaning stands in the core's report."""

NAMES = {
    "mean_abs": "Mean |d|",
    "rms": "RMS",
    "p50": "Median",
    "p90": "90th percentile",
    "p95": "95th percentile",
    "max_abs": "Largest |d|",
    "mean_signed": "Signed mean",
    "mean_abs_interface": "Mean |d|, both grids",
    "volume_above": "Volume above",
    "volume_below": "Volume below",
    "area_compared": "Area compared",
    "area_interface": "Area on both grids",
    "coverage_1": "Coverage of 1",
    "coverage_2": "Coverage of 2",
    "rho_V": "ρ_V",
    "rho_V_mu": "ρ_V with weight µ",
    "rho_delta_V": "ρ_δV",
    "hausdorff_1_2": "Hausdorff 1 → 2",
    "hausdorff_2_1": "Hausdorff 2 → 1",
}
