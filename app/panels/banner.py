"""One line about what went wrong; it stays until it is closed and blocks nothing."""

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton

from app.look.theme import UNIT
from app.panels.widgets import tool_button


class Banner(QFrame):
    """A line over the views."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("banner")
        self.label = QLabel(wordWrap=True)
        self.label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.action = QPushButton()
        self.action.setAccessibleName(self.tr("Do what the message offers"))
        self.action.clicked.connect(self._act)
        self._work: Callable[[], object] | None = None
        close = tool_button(self.tr("Close"), self.tr("Close the message"), plain=True)
        close.clicked.connect(self.hide)
        row = QHBoxLayout(self)
        row.setContentsMargins(UNIT + 4, UNIT // 2, UNIT // 2, UNIT // 2)
        row.addWidget(self.label, 1)
        row.addWidget(self.action)
        row.addWidget(close, 0, Qt.AlignmentFlag.AlignTop)
        self.hide()

    def tell(self, text: str, kind: str = "error") -> None:
        """Show a message, an ``"error"`` or a ``"note"``."""
        self.setProperty("kind", kind)
        for widget in (self, self.label):
            widget.style().unpolish(widget)
            widget.style().polish(widget)
        self._work = None
        self.action.hide()
        self.label.setText(text)
        self.setAccessibleDescription(text)
        self.show()

    def ask(self, text: str, answer: str, work: Callable[[], object]) -> None:
        """Show a note with one thing that can be done about it."""
        self.tell(text, "note")
        self._work = work
        self.action.setText(answer)
        self.action.show()

    def _act(self) -> None:
        work, self._work = self._work, None
        self.hide()
        if work is not None:
            work()
