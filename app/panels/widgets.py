"""Small widgets that several panels use."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QActionGroup
from PySide6.QtWidgets import (
    QLabel,
    QLineEdit,
    QMenu,
    QPushButton,
    QToolButton,
    QWidget,
)

from app.numbers import short


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


class Panel(QWidget):
    """A docked panel's ground."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)


class ChoiceButton(QPushButton):
    """One choice out of a few, in a menu."""

    chosen = Signal(object)

    def __init__(self, choices: dict[object, str]) -> None:
        super().__init__()
        self._texts = choices
        menu = QMenu(self)
        group = QActionGroup(self)
        self.choices = {}
        for key, text in choices.items():
            action = menu.addAction(text)
            action.setCheckable(True)
            action.triggered.connect(lambda _=False, k=key: self.chosen.emit(k))
            group.addAction(action)
            self.choices[key] = action
        self.setMenu(menu)

    def show_choice(self, key: object) -> None:
        """Show what is chosen."""
        self.setText(f"{self._texts[key]}  ▾")
        self.choices[key].setChecked(True)


class NumberBox(QLineEdit):
    """A positive number, written as short as it is."""

    changed = Signal(float)

    def __init__(self) -> None:
        super().__init__()
        self._value = 1.0
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.editingFinished.connect(self._edited)

    @property
    def value(self) -> float:
        """The number in force."""
        return self._value

    def show_value(self, value: float) -> None:
        """Show a number."""
        self._value = value
        if not self.hasFocus() or not self.isModified():
            self.setText(short(value))

    def _edited(self) -> None:
        try:
            value = float(self.text().replace(",", "."))
        except ValueError:
            value = 0.0
        self.setModified(False)
        if value > 0 and value != self._value:
            self._value = value
            self.changed.emit(value)
        self.setText(short(self._value))
