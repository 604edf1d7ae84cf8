"""Texts that stand where no widget translates them."""

from PySide6.QtCore import QCoreApplication


def QT_TRANSLATE_NOOP(_context: str, text: str) -> str:  # noqa: N802 - Qt's tools look for it
    """Return the text; Qt's tools collect it for those who translate.

    Qt's own function of this name does the same, but is not typed as a text.
    """
    return text


def of_core(text: str) -> str:
    """Translate a text that the core has marked by `said`, which has no context."""
    return QCoreApplication.translate("", text)
