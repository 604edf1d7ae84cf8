"""What each measure is called, in what unit it stands, and what it means in one line."""

from dataclasses import dataclass, replace
from typing import Any

SUMS = "Sums of the paper"


@dataclass(frozen=True, slots=True)
class Meaning:
    """One number of the result, as a person reads it."""

    key: str
    """Its name in the .json result."""
    group: str
    """The heading it stands under."""
    power: int | None
    """Its unit is this power of the length unit; None: a share of 1, shown in per cent."""
    text: str
    """One line for people who do not know the definition."""


MEANINGS = (
    Meaning("mean_abs", "Difference", 1, "mean of |d| over the compared area"),
    Meaning("rms", "Difference", 1, "root mean square of d; weighs large differences more"),
    Meaning("p50", "Difference", 1, "half of the area lies below (mean |d| of each triangle)"),
    Meaning("p90", "Difference", 1, "90 % of the area lies below"),
    Meaning("p95", "Difference", 1, "95 % of the area lies below"),
    Meaning("max_abs", "Difference", 1, "largest |d| at a node"),
    Meaning("mean_signed", "Difference", 1, "mean of d; above and below cancel, so it flatters"),
    Meaning("mean_abs_interface", "Difference", 1, "mean of |d| where both grids have nodes"),
    Meaning("within_tolerance", "Within tolerance", None, "share of the area with |d| ≤ {}"),
    Meaning("volume_above", "Volume", 3, "between the surfaces where 1 lies above 2"),
    Meaning("volume_below", "Volume", 3, "between the surfaces where 1 lies below 2"),
    Meaning("area_compared", "Coverage", 2, "area compared, seen along z"),
    Meaning("area_interface", "Coverage", 2, "part of it in triangles with nodes of both grids"),
    Meaning("coverage_1", "Coverage", None, "share of surface 1 that was compared"),
    Meaning("coverage_2", "Coverage", None, "share of surface 2 that was compared"),
    Meaning("rho_V", SUMS, 1, "ρ_V, one term for each triangle"),
    Meaning("rho_V_mu", SUMS, 1, "ρ_V with the weight µ"),
    Meaning("rho_delta_V", SUMS, 1, "ρ_δV, representative triangles only"),
    Meaning("hausdorff_1_2", "Hausdorff", 1, "farthest node of 1 from the nodes of 2, in space"),
    Meaning("hausdorff_2_1", "Hausdorff", 1, "farthest node of 2 from the nodes of 1, in space"),
)

NOTES = {
    SUMS: "They fall when a scan is thinned, whatever the surfaces do: only the means above can"
    " be compared between pairs.",
    "Difference, exact": "Integrated over the overlay of T1 and T2; the values above are nodal,"
    " with d linear on each triangle of T.",
}
"""What has to be said beside a group."""

REASONS = ("compared", "outside 1", "outside 2", "hole", "degenerate")
"""Names of `Reason`, in its order."""


@dataclass(frozen=True, slots=True)
class Line:
    """One measure of one comparison, ready to be set in a table."""

    group: str
    name: str
    value: float | None
    power: int | None
    text: str


def lines(measures: dict[str, Any], unit: str) -> list[Line]:
    """Return the measures of a .json document, line by line in the order people need them."""
    result = []
    for meaning in MEANINGS:
        value = measures[meaning.key]
        if meaning.key == "within_tolerance":
            result += [
                Line(meaning.group, f"≤ {t} {unit}", v, None, meaning.text.format(f"{t} {unit}"))
                for t, v in value.items()
            ]
        else:
            result.append(Line(meaning.group, meaning.key, value, meaning.power, meaning.text))
    if "exact" in measures:
        result += [
            replace(line, group=f"{line.group}, exact")
            for line in lines(measures["exact"], unit)
            if line.group not in (SUMS, "Hausdorff")
        ]
    return result
