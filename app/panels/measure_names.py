"""Plain names of the measures; their meaning stands in the core's report."""

from app.look.texts import QT_TRANSLATE_NOOP

NAMES = {
    "mean_abs": QT_TRANSLATE_NOOP("MeasuresPanel", "Mean |d|"),
    "rms": QT_TRANSLATE_NOOP("MeasuresPanel", "RMS"),
    "p50": QT_TRANSLATE_NOOP("MeasuresPanel", "Median"),
    "p90": QT_TRANSLATE_NOOP("MeasuresPanel", "90th percentile"),
    "p95": QT_TRANSLATE_NOOP("MeasuresPanel", "95th percentile"),
    "max_abs": QT_TRANSLATE_NOOP("MeasuresPanel", "Largest |d|"),
    "mean_signed": QT_TRANSLATE_NOOP("MeasuresPanel", "Signed mean"),
    "mean_abs_interface": QT_TRANSLATE_NOOP("MeasuresPanel", "Mean |d|, both grids"),
    "volume_above": QT_TRANSLATE_NOOP("MeasuresPanel", "Volume above"),
    "volume_below": QT_TRANSLATE_NOOP("MeasuresPanel", "Volume below"),
    "area_compared": QT_TRANSLATE_NOOP("MeasuresPanel", "Area compared"),
    "area_interface": QT_TRANSLATE_NOOP("MeasuresPanel", "Area on both grids"),
    "coverage_1": QT_TRANSLATE_NOOP("MeasuresPanel", "Coverage of 1"),
    "coverage_2": QT_TRANSLATE_NOOP("MeasuresPanel", "Coverage of 2"),
    "rho_V": QT_TRANSLATE_NOOP("MeasuresPanel", "ρ_V"),
    "rho_V_mu": QT_TRANSLATE_NOOP("MeasuresPanel", "ρ_V with weight µ"),
    "rho_delta_V": QT_TRANSLATE_NOOP("MeasuresPanel", "ρ_δV"),
    "hausdorff_1_2": QT_TRANSLATE_NOOP("MeasuresPanel", "Hausdorff 1 → 2"),
    "hausdorff_2_1": QT_TRANSLATE_NOOP("MeasuresPanel", "Hausdorff 2 → 1"),
}

CORE_TEXTS = (
    QT_TRANSLATE_NOOP("MeasuresPanel", "Difference"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "Within tolerance"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "Volume"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "Coverage"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "Sums of the paper"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "Hausdorff"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "Difference, exact"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "Within tolerance, exact"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "Volume, exact"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "Coverage, exact"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "mean of |d| over the compared area"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "root mean square of d; weighs large differences more"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "half of the area lies below (mean |d| of each triangle)"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "90 % of the area lies below"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "95 % of the area lies below"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "largest |d| at a node"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "mean of d; above and below cancel, so it flatters"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "mean of |d| where both grids have nodes"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "between the surfaces where 1 lies above 2"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "between the surfaces where 1 lies below 2"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "area compared, seen along z"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "part of it in triangles with nodes of both grids"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "share of surface 1 that was compared"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "share of surface 2 that was compared"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "ρ_V, one term for each triangle"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "ρ_V with the weight µ"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "ρ_δV, representative triangles only"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "farthest node of 1 from the nodes of 2, in space"),
    QT_TRANSLATE_NOOP("MeasuresPanel", "farthest node of 2 from the nodes of 1, in space"),
    QT_TRANSLATE_NOOP(
        "MeasuresPanel",
        "They fall when a scan is thinned, whatever the surfaces do: only the means above"
        " can be compared between pairs.",
    ),
    QT_TRANSLATE_NOOP(
        "MeasuresPanel",
        "Integrated over the overlay of T1 and T2; the values above are nodal, with d"
        " linear on each triangle of T.",
    ),
)
"""What the core says of its measures: groups, sentences, notes."""
