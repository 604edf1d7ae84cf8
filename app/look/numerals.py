"""Numbers as the window writes them; the same figures as in the core's reports.

The core is imported where it is needed: the window is on the screen before it is loaded.
"""

import math


def short(value: float) -> str:
    """Return the shortest decimal of `value`, with a true minus sign."""
    return f"{value:.6g}".replace("-", "−")


def with_unit(value: float | None, power: int | None, unit: str) -> tuple[str, str]:
    """Return the figure and its unit; shares (power None) become per cent."""
    from surfcmp_core.report import numbers

    return numbers.with_unit(value, power, unit)


def three(value: float) -> str:
    """Return three significant figures; a dash where there is no value."""
    if not math.isfinite(value):
        return "–"
    if 1e-4 <= abs(value) < 1000:
        return f"{value:#.3g}".removesuffix(".").replace("-", "−")
    return short(float(f"{value:.3g}"))


def four(value: float) -> str:
    """Return four significant figures; a dash where there is no value."""
    return short(float(f"{value:.4g}")) if math.isfinite(value) else "–"


def thousands(count: int) -> str:
    """Group digits by thin spaces: 1 234 567."""
    from surfcmp_core.report import numbers

    return numbers.thousands(count)
