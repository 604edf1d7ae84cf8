"""Texts that stand where no widget translates them."""


def QT_TRANSLATE_NOOP(_context: str, text: str) -> str:  # noqa: N802 - Qt's tools look for it
    """Return the text; Qt's tools collect it for those who translate.

    Qt's own function of this name does the same, but is not typed as a text.
    """
    return text
