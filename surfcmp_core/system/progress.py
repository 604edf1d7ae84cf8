"""How long work tells its stage, and how it is told to stop."""

from collections.abc import Callable

Progress = Callable[[str, float], None]
"""``progress(stage, fraction)`` with fraction in [0, 1] of the whole work.

It may raise :class:`surfcmp_core.errors.Cancelled`; the work then stops there.
"""


def silent(_stage: str, _fraction: float) -> None:
    """Report nothing."""
