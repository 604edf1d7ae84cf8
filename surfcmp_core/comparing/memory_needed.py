"""How much memory a comparison needs: asked before anything is taken."""

from surfcmp_core.errors import InputError
from surfcmp_core.surface import Surface
from surfcmp_core.system.memory import need_memory

COMPARING = 350
"""Bytes for each node of both surfaces, above the input: 300 measured on 0.3 and 1 M nodes."""
EXACT = 100
"""Bytes more for each node, for the exact reading."""


def check_comparison(surface_1: Surface, surface_2: Surface, exact: bool) -> None:
    """Refuse a comparison that memory does not suffice for.

    Raises
    ------
    InputError
        More is needed than is free.
    """
    nodes = len(surface_1.points) + len(surface_2.points)
    each = COMPARING + (EXACT if exact else 0)
    try:
        need_memory(float(nodes) * each)
    except InputError as fault:
        raise fault.at(*(str(one.path or one.name) for one in (surface_1, surface_2))) from None
