"""What each measure is called, in what unit it stands, and what it means in one line."""

from dataclasses import dataclass, replace
from typing import Any


def said(text: str) -> str:
    """Return a text that people read; Qt's tools, told of this name, collect it for translation."""
    return text


DIFFERENCE = said("Difference")
WITHIN = said("Within tolerance")
VOLUME = said("Volume")
COVERAGE = said("Coverage")
SUMS = said("Sums of the paper")
HAUSDORFF = said("Hausdorff")
EXACT = {
    DIFFERENCE: said("Difference, exact"),
    WITHIN: said("Within tolerance, exact"),
    VOLUME: said("Volume, exact"),
    COVERAGE: said("Coverage, exact"),
}
"""The headings of the exact reading, which has these groups only."""


@dataclass(frozen=True, slots=True)
class Meaning:
    """One number of the result, as a person reads it."""

    key: str
    """Its name in the .json result."""
    name: str
    """What a person calls it."""
    group: str
    """The heading it stands under."""
    power: int | None
    """Its unit is this power of the length unit; None: a share of 1, shown in per cent."""
    text: str
    """One line for people who do not know the definition."""


MEANINGS = (
    Meaning(
        "mean_abs", said("Mean |d|"), DIFFERENCE, 1, said("mean of |d| over the compared area")
    ),
    Meaning(
        "rms",
        said("RMS"),
        DIFFERENCE,
        1,
        said("root mean square of d; weighs large differences more"),
    ),
    Meaning(
        "p50",
        said("Median"),
        DIFFERENCE,
        1,
        said("half of the area lies below (mean |d| of each triangle)"),
    ),
    Meaning("p90", said("90th percentile"), DIFFERENCE, 1, said("90 % of the area lies below")),
    Meaning("p95", said("95th percentile"), DIFFERENCE, 1, said("95 % of the area lies below")),
    Meaning("max_abs", said("Largest |d|"), DIFFERENCE, 1, said("largest |d| at a node")),
    Meaning(
        "mean_signed",
        said("Signed mean"),
        DIFFERENCE,
        1,
        said("mean of d; above and below cancel, so it flatters"),
    ),
    Meaning(
        "mean_abs_interface",
        said("Mean |d|, both grids"),
        DIFFERENCE,
        1,
        said("mean of |d| where both grids have nodes"),
    ),
    Meaning("within_tolerance", "≤ {}", WITHIN, None, said("share of the area with |d| ≤ {}")),
    Meaning(
        "volume_above",
        said("Volume above"),
        VOLUME,
        3,
        said("between the surfaces where 1 lies above 2"),
    ),
    Meaning(
        "volume_below",
        said("Volume below"),
        VOLUME,
        3,
        said("between the surfaces where 1 lies below 2"),
    ),
    Meaning(
        "area_compared", said("Area compared"), COVERAGE, 2, said("area compared, seen along z")
    ),
    Meaning(
        "area_interface",
        said("Area on both grids"),
        COVERAGE,
        2,
        said("part of it in triangles with nodes of both grids"),
    ),
    Meaning(
        "coverage_1",
        said("Coverage of 1"),
        COVERAGE,
        None,
        said("share of surface 1 that was compared"),
    ),
    Meaning(
        "coverage_2",
        said("Coverage of 2"),
        COVERAGE,
        None,
        said("share of surface 2 that was compared"),
    ),
    Meaning("rho_V", said("ρ_V"), SUMS, 1, said("ρ_V, one term for each triangle")),
    Meaning("rho_V_mu", said("ρ_V with weight µ"), SUMS, 1, said("ρ_V with the weight µ")),
    Meaning("rho_delta_V", said("ρ_δV"), SUMS, 1, said("ρ_δV, representative triangles only")),
    Meaning(
        "hausdorff_1_2",
        said("Hausdorff 1 → 2"),
        HAUSDORFF,
        1,
        said("farthest node of 1 from the nodes of 2, in space"),
    ),
    Meaning(
        "hausdorff_2_1",
        said("Hausdorff 2 → 1"),
        HAUSDORFF,
        1,
        said("farthest node of 2 from the nodes of 1, in space"),
    ),
)

NOTES = {
    SUMS: said(
        "They fall when a scan is thinned, whatever the surfaces do: only the means above can"
        " be compared between pairs."
    ),
    EXACT[DIFFERENCE]: said(
        "Integrated over the overlay of T1 and T2; the values above are nodal, with d linear on"
        " each triangle of T."
    ),
}
"""What has to be said beside a group."""

REASONS = ("compared", "outside 1", "outside 2", "hole", "degenerate")
"""Names of `Reason`, in its order."""


@dataclass(frozen=True, slots=True)
class Line:
    """One measure of one comparison, ready to be set in a table."""

    meaning: Meaning
    group: str
    value: float | None
    tolerance: str = ""
    """With its unit, where the share within it is told."""

    @property
    def name(self) -> str:
        """Its key, or the tolerance."""
        return f"≤ {self.tolerance}" if self.tolerance else self.meaning.key

    @property
    def power(self) -> int | None:
        """Of the length unit; None: a share of 1."""
        return self.meaning.power

    @property
    def text(self) -> str:
        """What it means."""
        return self.meaning.text.format(self.tolerance)


def lines(measures: dict[str, Any], unit: str) -> list[Line]:
    """Return the measures of a .json document, line by line in the order people need them."""
    result = []
    for meaning in MEANINGS:
        value = measures[meaning.key]
        if meaning.group == WITHIN:
            result += [Line(meaning, WITHIN, share, f"{t} {unit}") for t, share in value.items()]
        else:
            result.append(Line(meaning, meaning.group, value))
    if "exact" in measures:
        result += [
            replace(line, group=EXACT[line.group])
            for line in lines(measures["exact"], unit)
            if line.group in EXACT
        ]
    return result
