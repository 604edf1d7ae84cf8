"""Names of files and what stands in them, as text that can be shown anywhere."""

from pathlib import Path


def one_line(text: str | Path) -> str:
    """Return a file's name, or a message about it, as one line that any stream can take.

    Parameters
    ----------
    text
        What the system gave; bytes that are no UTF-8 stand in it as surrogates.

    Returns
    -------
    str
        With a replacement mark for each character that cannot be printed.
    """
    decoded = str(text).encode("utf-8", "surrogateescape").decode("utf-8", "replace")
    return "".join(c if c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in decoded)


def quoted(text: str, most: int = 40) -> str:
    """Quote at most so many characters on one line."""
    return repr(text if len(text) <= most else text[: most - 3] + "...")
