"""The document: everything that decides the numbers, and the unit they are told in."""

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Self

from surfcmp_core.comparison import Options

Transform = tuple[tuple[float, float, float, float], ...]

IDENTITY: Transform = (
    (1.0, 0.0, 0.0, 0.0),
    (0.0, 1.0, 0.0, 0.0),
    (0.0, 0.0, 1.0, 0.0),
    (0.0, 0.0, 0.0, 1.0),
)
"""The motion that moves nothing."""


@dataclass(frozen=True, slots=True)
class Document:
    """Inputs, options and the motion of surface 2; equal documents give equal numbers."""

    paths: tuple[Path | None, Path | None] = (None, None)
    options: Options = field(default_factory=Options)
    transform: Transform = IDENTITY
    """Moves surface 2, in the files' coordinates."""
    unit: str = ""
    """What the user says the files' unit is; empty: what the files say."""

    @property
    def complete(self) -> bool:
        """Whether both surfaces are named."""
        return all(self.paths)

    def with_path(self, number: int, path: Path | None) -> Self:
        """Return the document with surface `number` (1 or 2) replaced."""
        one, two = self.paths
        return replace(self, paths=(path, two) if number == 1 else (one, path))

    def swapped(self) -> Self:
        """Return the document with the surfaces' roles exchanged."""
        return replace(self, paths=(self.paths[1], self.paths[0]))
