"""Small widgets that several panels use."""

from PySide6.QtWidgets import QLabel, QToolButton


def tool_button(text: str, tip: str = "", *, plain: bool = False) -> QToolButton:
    """Return a button with a text; `tip` explains it, also to screen readers."""
    button = QToolButton()
    button.setText(text)
    if plain:
        button.setProperty("kind", "plain")
    if tip:
        button.setToolTip(tip)
        button.setAccessibleName(tip)
    return button


def quiet_label(text: str = "") -> QLabel:
    """Return a label for what matters less."""
    label = QLabel(text)
    label.setProperty("kind", "quiet")
    return label
