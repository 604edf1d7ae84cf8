"""The errors the core raises on purpose; each message is one line for the user."""

from collections.abc import Iterable
from copy import copy
from typing import Self

from surfcmp_core.names import quoted


class SurfcmpError(Exception):
    """Base of all errors raised on purpose."""


class InputError(SurfcmpError):
    """The input cannot be compared; its line names the file (or surface) and the fault.

    Attributes
    ----------
    fault : str
        What is wrong, without a name ahead.
    where : tuple of str
        The files or surfaces it names, in order; empty where it is raised by what does not know.
    row : str or None
        The row of a file that cannot be read.
    hints : tuple of str
        What may be the reason, or help.
    """

    def __init__(
        self,
        fault: str,
        *,
        where: Iterable[str] = (),
        row: str | None = None,
        hints: Iterable[str] = (),
    ) -> None:
        super().__init__(fault)
        self.fault = fault
        self.where = tuple(where)
        self.row = row
        self.hints = tuple(hints)

    def __str__(self) -> str:
        """Return its line."""
        names = f"{' and '.join(self.where)}: " if self.where else ""
        row = "" if self.row is None else f" in the row {quoted(self.row)}"
        return names + "; ".join((self.fault + row, *self.hints))

    def at(self, *names: str) -> Self:
        """Return the same fault, of these files or surfaces where it names none yet."""
        told = copy(self)
        told.where = self.where or names
        return told

    def with_hints(self, *hints: str) -> Self:
        """Return the same fault with some hints more."""
        told = copy(self)
        told.hints = (*self.hints, *hints)
        return told


class Cancelled(SurfcmpError):  # noqa: N818 - not a fault
    """The user asked to stop; raised from a progress callback."""


class Violation(SurfcmpError):  # noqa: N818 - as in "a violation is an error"
    """What must hold of every comparison does not: a fault of this program, not of the input."""


class OptionError(SurfcmpError, ValueError):
    """An option means nothing, whatever the input.

    Attributes
    ----------
    option : str
        As in Python; the command line has it with dashes.
    value : object
    must : str
        What it must be.
    """

    def __init__(self, option: str, value: object, must: str) -> None:
        super().__init__(f"{option} {value!r}: must be {must}")
        self.option = option
        self.value = value
        self.must = must
