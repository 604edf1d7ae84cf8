"""A surface: what it is, in which unit and axes, what of it counts."""

from surfcmp_core.surface.surface import Duplicates, Surface

__all__ = ["Duplicates", "Surface"]
