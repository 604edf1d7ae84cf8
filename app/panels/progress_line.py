"""The running work in the status bar: stage, progress, Cancel."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QWidget

from app.look.texts import QT_TRANSLATE_NOOP
from app.look.theme import UNIT
from app.panels.widgets import tool_button

STAGES = {
    "read": QT_TRANSLATE_NOOP("ProgressStrip", "Reading"),
    "triangulate": QT_TRANSLATE_NOOP("ProgressStrip", "Triangulating"),
    "spanning trees": QT_TRANSLATE_NOOP("ProgressStrip", "Spanning trees"),
    "locate": QT_TRANSLATE_NOOP("ProgressStrip", "Locating nodes"),
    "interpolate": QT_TRANSLATE_NOOP("ProgressStrip", "Interpolating"),
    "interface": QT_TRANSLATE_NOOP("ProgressStrip", "Tracing chains"),
    "measures": QT_TRANSLATE_NOOP("ProgressStrip", "Measuring"),
    "done": QT_TRANSLATE_NOOP("ProgressStrip", "Finishing"),
    "picture": QT_TRANSLATE_NOOP("ProgressStrip", "Preparing the picture"),
}


class ProgressStrip(QWidget):
    """Visible while something runs."""

    cancel_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.stage = QLabel()
        self.bar = QProgressBar(maximum=1000, textVisible=False)
        self.bar.setFixedWidth(20 * UNIT)
        self.bar.setAccessibleName(self.tr("Progress"))
        tip = self.tr("Stop comparing (Esc); what was shown before stays")
        self.cancel = tool_button(self.tr("Cancel"), tip, plain=True)
        self.cancel.clicked.connect(self.cancel_asked)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, UNIT, 0)
        row.setSpacing(UNIT)
        for widget in (self.stage, self.bar, self.cancel):
            row.addWidget(widget)
        self.hide()

    def begin(self) -> None:
        """Show that work has begun."""
        self.tell("read", 0.0)
        self.show()

    def tell(self, stage: str, fraction: float) -> None:
        """Show the stage and how much of the whole is done."""
        name, _, note = stage.partition(" (")  # the core may add why it takes long
        text = self.tr(STAGES.get(name, name)) + "…"
        self.stage.setText(f"{text} ({note}" if note else text)
        self.bar.setValue(round(1000 * fraction))
