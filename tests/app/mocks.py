"""Stand-ins for what controllers are tied to; they need no screen."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal

from app.jobs.comparing import Compared
from app.model.document import Document
from app.model.tool import Tool
from app.model.view_state import ScaleChoice, ViewState
from app.scene.content import Content


class MockDisplay(QObject):
    """A view state without views."""

    changed = Signal()
    shown = Signal(object)
    tool_changed = Signal(object)
    path_drawn = Signal(object, object)
    landmark_picked = Signal(int, object)

    def __init__(self) -> None:
        super().__init__()
        self.state = ViewState()
        self.content: Content | None = None
        self.unit = ""
        self.tool = Tool.LOOK
        self.looked_at: list[Any] = []
        self.marks: list[Any] = []
        self.brush = 0.0

    def change(self, **changes: Any) -> None:
        self.show(replace(self.state, **changes))

    def show(self, state: ViewState) -> None:
        if state != self.state:
            self.state = state
            self.changed.emit()

    def set_content(self, content: Content, unit: str, scale: ScaleChoice) -> None:
        self.content, self.unit = content, unit
        self.state = replace(self.state, scale=scale)
        self.changed.emit()

    def use(self, tool: Tool) -> None:
        self.tool = tool
        self.tool_changed.emit(tool)

    def look_at(self, low: Any, high: Any) -> None:
        self.looked_at.append((low, high))

    def set_landmarks(self, marks: list[Any]) -> None:
        self.marks = marks

    def set_brush(self, radius: float) -> None:
        self.brush = radius


class MockWorkbench(QObject):
    """A document without a core behind it."""

    changed = Signal()
    compared = Signal(object)
    failed = Signal(str)

    def __init__(self, document: Document | None = None) -> None:
        super().__init__()
        self.document = document or Document()
        self.shown: Compared | None = None
        self.unit = "mm"
        self.opened: list[tuple[list[Path], int | None]] = []
        self.views: list[dict[str, Any]] = []

    def set_document(self, document: Document, **view: Any) -> None:
        self.document = document
        self.views.append(view)
        self.changed.emit()

    def open(self, paths: list[Path], number: int | None = None) -> None:
        self.opened.append((list(paths), number))

    def finish(self, result: Compared) -> None:
        self.shown, self.document = result, result.document
        self.compared.emit(result)


class MockTelling:
    """Remembers what was said."""

    def __init__(self) -> None:
        self.said: list[tuple[str, str]] = []
        self.offer: Callable[[], object] | None = None

    def tell(self, text: str, kind: str = "error") -> None:
        self.said.append((text, kind))

    def ask(self, text: str, answer: str, work: Callable[[], object]) -> None:
        self.said.append((text, answer))
        self.offer = work

    def hide(self) -> None:
        self.said.clear()


class MockAsking:
    """Answers as it was told to."""

    def __init__(self, *answers: Path | None, kind: int = 0) -> None:
        self.answers = list(answers)
        self.kind = kind
        self.asked: list[tuple[str, ...]] = []
        self.offered: dict[str, Callable[[], object]] = {}
        self.tint: tuple[int, int, int] | None = None

    def file(self, title: str, start: str = "", kinds: str = "") -> Path | None:
        self.asked.append((title, start, kinds))
        return self.answers.pop(0)

    def files(self, title: str, kinds: str) -> list[Path]:
        self.asked.append((title, kinds))
        found, self.answers = self.answers, []
        return [path for path in found if path is not None]

    def place(self, title: str, start: str, kinds: str) -> tuple[Path | None, str]:
        self.asked.append((title, start, kinds))
        return self.answers.pop(0), kinds.split(";;")[self.kind]

    def colour(self, title: str, old: tuple[int, int, int]) -> tuple[int, int, int] | None:
        self.asked.append((title, str(old)))
        return self.tint

    def choose(self, heading: str, answers: Mapping[str, Callable[[], object]]) -> None:
        self.asked.append((heading,))
        self.offered = dict(answers)
