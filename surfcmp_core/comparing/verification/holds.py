"""How a check says that what must hold does not."""

from surfcmp_core.errors import Violation


def hold(condition: object, what: str) -> None:
    """Raise `Violation` with what must hold, where it does not."""
    if not condition:
        raise Violation(what)
