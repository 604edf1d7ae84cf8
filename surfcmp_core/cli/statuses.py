"""Exit statuses, and the one line that says why."""

import sys

from surfcmp_core.names import one_line

WRONG_USAGE = 2
CANNOT_COMPARE = 3
INTERRUPTED = 130


def complain(text: str) -> None:
    """Say on standard error, in one line, what is wrong."""
    print(f"surfcmp: {one_line(text)}", file=sys.stderr)
