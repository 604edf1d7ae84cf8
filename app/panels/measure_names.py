"""Plain names of the measures; their meaning stands in the core's report."""

from app.texts import QT_TRANSLATE_NOOP

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
