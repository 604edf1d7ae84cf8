"""Numbers as the window writes them where space is short."""

from surfcmp_core.report.numbers import figure, thousands, with_unit

__all__ = ["figure", "short", "thousands", "with_unit"]


def short(value: float) -> str:
    """Return the shortest decimal of `value`, with a true minus sign."""
    return f"{value:.6g}".replace("-", "−")
