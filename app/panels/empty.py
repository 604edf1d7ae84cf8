"""What stands in place of the views while there is nothing to show."""

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QVBoxLayout

from app.look.theme import UNIT


class EmptyState(QFrame):
    """Says what is there, what is missing and what to do."""

    open_asked = Signal()
    sample_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("view")
        self._title = QLabel(alignment=Qt.AlignmentFlag.AlignCenter)
        font = self._title.font()
        font.setPointSizeF(font.pointSizeF() * 1.5)
        font.setWeight(font.Weight.DemiBold)
        self._title.setFont(font)
        self._text = QLabel(alignment=Qt.AlignmentFlag.AlignCenter, wordWrap=True)
        self._text.setProperty("kind", "quiet")
        self.open = QPushButton()
        self.open.setProperty("kind", "primary")
        self.open.clicked.connect(self.open_asked)
        self.sample = QPushButton(self.tr("Show the sample faces"))
        self.sample.clicked.connect(self.sample_asked)
        buttons = QHBoxLayout()
        buttons.setSpacing(UNIT)
        buttons.addStretch(1)
        buttons.addWidget(self.open)
        buttons.addWidget(self.sample)
        buttons.addStretch(1)
        column = QVBoxLayout(self)
        column.setContentsMargins(4 * UNIT, 4 * UNIT, 4 * UNIT, 4 * UNIT)
        column.setSpacing(2 * UNIT)
        column.addStretch(1)
        column.addWidget(self._title)
        column.addWidget(self._text)
        column.addLayout(buttons)
        column.addStretch(1)

    def tell(self, paths: tuple[Path | None, Path | None], busy: bool) -> None:
        """Describe the state of affairs."""
        from surfcmp_core.io.read import READERS

        self.open.setVisible(not busy)
        self.sample.setVisible(not busy)
        missing = [k + 1 for k, path in enumerate(paths) if path is None]
        names = [path.name for path in paths if path is not None]
        if busy:
            self._title.setText(self.tr("Comparing"))
            self._text.setText(self.tr("{} with {}").format(*names))
        elif len(missing) == 1:
            self._title.setText(self.tr("Surface {} is missing").format(missing[0]))
            self._text.setText(
                self.tr("{} is there. Drop the other surface here, or open it.").format(names[0])
            )
            self.open.setText(self.tr("Open surface {}…").format(missing[0]))
        else:
            self._title.setText(self.tr("Drop two surfaces here"))
            self._text.setText(
                self.tr("Scans, terrain or any height field: {}").format(" ".join(READERS))
            )
            self.open.setText(self.tr("Open surfaces…"))
