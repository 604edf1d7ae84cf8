"""Reading surfaces from files, and telling what one holds."""

from surfcmp_core.io.facts import Facts, facts_of
from surfcmp_core.io.read import read_surface

__all__ = ["Facts", "facts_of", "read_surface"]
