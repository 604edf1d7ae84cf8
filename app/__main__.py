"""`surfcmp` and `python -m app`: the command line, or the window where no command is named."""

import sys
from collections.abc import Sequence
from pathlib import Path


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the program.

    Parameters
    ----------
    arguments
        Of the command line; by default the process's own.

    Returns
    -------
    int
        Exit status: 0 done, 2 wrong usage, 3 the input cannot be compared, 130 interrupted.
    """
    try:
        from surfcmp_core.cli.main import run
    except KeyboardInterrupt:
        return 130
    return run(sys.argv[1:] if arguments is None else arguments, _open_window)


def _open_window(paths: list[Path]) -> int:
    from app.window import run

    return run(paths)


if __name__ == "__main__":
    sys.exit(main())
