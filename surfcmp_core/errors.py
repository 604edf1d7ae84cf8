"""The errors the core raises on purpose; each message is one line for the user."""


class SurfcmpError(Exception):
    """Base of all errors raised on purpose."""


class InputError(SurfcmpError):
    """The input cannot be compared; the message names the file (or surface) and the fault."""


class Cancelled(SurfcmpError):  # noqa: N818 - not a fault
    """The user asked to stop; raised from a progress callback."""


class Violation(SurfcmpError):  # noqa: N818 - as in "a violation is an error"
    """What must hold of every comparison does not: a fault of this program, not of the input."""
