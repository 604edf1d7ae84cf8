"""Numbers as people read them: four figures, a unit, nothing false."""

import math
from collections.abc import Sequence

_POWERS = {1: "", 2: "²", 3: "³"}
NOTHING = "–"


def figure(value: float | None) -> str:
    """Four significant figures; a dash where there is no value."""
    if value is None or not math.isfinite(value):
        return NOTHING
    if value == 0:
        return "0"
    if 1e-4 <= abs(value) < 1e7:
        decimals = max(0, 3 - math.floor(math.log10(abs(value))))
        return f"{value:.{decimals}f}".replace("-", "−")
    mantissa, exponent = f"{value:.3e}".split("e")
    return f"{mantissa}e{int(exponent)}".replace("-", "−")


def with_unit(value: float | None, power: int | None, unit: str) -> tuple[str, str]:
    """Return the figure and its unit; shares (power None) become per cent."""
    if power is None:
        share = None if value is None else 100 * value
        if share is None or not math.isfinite(share):
            return NOTHING, ""
        return f"{share:.2f}", "%"
    text = figure(value)
    return (text, "") if text == NOTHING else (text, unit + _POWERS[power])


def towards(direction: Sequence[float]) -> str:
    """Tell a unit direction by its parts and its angle to z."""
    x, y, z = direction
    from_z = math.degrees(math.acos(min(max(z, -1.0), 1.0)))
    parts = ", ".join(f"{part:.4f}".replace("-", "−") for part in (x, y, z))
    return f"{parts}: {from_z:.1f}° from z"


def thousands(count: int) -> str:
    """Group digits by thin spaces: 1 234 567."""
    return f"{count:,}".replace(",", "\u2009")
