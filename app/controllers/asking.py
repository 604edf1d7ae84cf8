"""What controllers need of a screen, in the abstract: a place for words, and questions."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Protocol


class Telling(Protocol):
    """Where one line for the user goes."""

    def tell(self, text: str, kind: str = "error") -> None:
        """Show a message, an ``"error"`` or a ``"note"``."""

    def ask(self, text: str, answer: str, work: Callable[[], object]) -> None:
        """Show a note with one thing that can be done about it."""

    def hide(self) -> None:
        """Take the message away."""


class Asking(Protocol):
    """What asks the user to choose; None or nothing where the user thinks better of it."""

    def file(self, title: str, start: str = "", kinds: str = "") -> Path | None:
        """Ask for a file that is there."""

    def files(self, title: str, kinds: str) -> list[Path]:
        """Ask for several of them."""

    def place(self, title: str, start: str, kinds: str) -> tuple[Path | None, str]:
        """Ask where to write, and as which of the kinds."""

    def colour(self, title: str, old: tuple[int, int, int]) -> tuple[int, int, int] | None:
        """Ask for a colour."""

    def choose(self, heading: str, answers: Mapping[str, Callable[[], object]]) -> None:
        """Offer things to do, where the mouse is; returns at once."""
