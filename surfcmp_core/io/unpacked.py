"""How much may come out of what a file packs."""

from surfcmp_core.errors import InputError

_FREE = 1 << 25
"""Octets that any file may unpack to."""
_RATIO = 100
"""Octets for each packed one: real nodes reach some 20, zeros 1000."""


def check_unpacked(octets: int, packed: int) -> None:
    """Refuse what only a file made to fill the memory declares, before anything is unpacked.

    Parameters
    ----------
    octets : int
        Declared, or unpacked so far.
    packed : int
        Octets of the file that they come from.

    Raises
    ------
    InputError
        It says both numbers.
    """
    if octets > _FREE + _RATIO * packed:
        raise InputError(f"{octets} bytes are packed into {packed}, as in no surface: not unpacked")
