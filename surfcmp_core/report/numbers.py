"""Numbers as people read them: four figures, a unit, nothing false."""

import math

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


def thousands(count: int) -> str:
    """Group digits by thin spaces: 1 234 567."""
    return f"{count:,}".replace(",", "\u2009")
