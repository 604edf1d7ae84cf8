"""Localisation of one grid in the triangulation of the other."""

from surfcmp_core.localisation.localisation import locate_along_tree, locate_from
from surfcmp_core.localisation.straight import relocate

__all__ = ["locate_along_tree", "locate_from", "relocate"]
