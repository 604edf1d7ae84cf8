"""Small widgets that several panels use."""

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QActionGroup
from PySide6.QtWidgets import (
    QHeaderView,
    QLabel,
    QLineEdit,
    QMenu,
    QPushButton,
    QToolButton,
    QTreeWidget,
    QTreeWidgetItem,
    QWidget,
)

from app.look.numerals import short
from app.look.theme import UNIT, tabular

RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


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
        self.setText(short(self._value))
        self.setMinimumWidth(6 * UNIT)
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


class NumberTree(QTreeWidget):
    """A plain table: a name on the left, numbers at the right."""

    def __init__(self, name: str, heads: list[str]) -> None:
        super().__init__()
        self.setAccessibleName(name)
        self.setRootIsDecorated(False)
        self.setIndentation(0)
        self.setUniformRowHeights(True)
        font = tabular(self.font())
        font.setPointSizeF(font.pointSizeF() * 0.92)
        self.setFont(font)
        self.setHeaderLabels(heads)
        self.header().setFont(font)
        self.header().setStretchLastSection(False)
        self.header().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        for column in range(1, len(heads)):
            self.headerItem().setTextAlignment(column, RIGHT)

    def add_row(self, texts: list[str]) -> QTreeWidgetItem:
        """Add a row: its name, then its numbers."""
        item = QTreeWidgetItem(texts)
        for column in range(1, len(texts)):
            item.setTextAlignment(column, RIGHT)
        item.setSizeHint(0, QSize(0, 3 * UNIT))
        self.addTopLevelItem(item)
        return item
