"""Interpolation of one surface at the nodes of the other grid."""

from surfcmp_core.interpolation.interpolation import interpolate

__all__ = ["interpolate"]
