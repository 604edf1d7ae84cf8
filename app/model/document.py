"""The document: everything that decides the numbers."""

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Self

from surfcmp_core.comparison import Options

IDENTITY = ((1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0, 1.0))
"""The motion that moves nothing."""

Transform = tuple[tuple[float, float, float, float], ...]


@dataclass(frozen=True, slots=True)
class Source:
    """Where a surface comes from: a file, or one half of a built-in sample pair."""

    path: Path | None = None
    sample: str = ""
    number: int = 1

    @property
    def name(self) -> str:
        """How the window calls it."""
        return self.path.name if self.path else f"{self.sample} {self.number} (sample)"

    @classmethod
    def of_file(cls, path: Path) -> Self:
        """Return the source that reads `path`."""
        return cls(path=path.absolute())


@dataclass(frozen=True, slots=True)
class Document:
    """Inputs, options and the motion of surface 2; equal documents give equal numbers."""

    sources: tuple[Source | None, Source | None] = (None, None)
    options: Options = field(default_factory=Options)
    transform: Transform = IDENTITY
    """Moves surface 2, in the files' coordinates."""

    @property
    def complete(self) -> bool:
        """Whether both surfaces are there."""
        return all(self.sources)

    def with_source(self, number: int, source: Source | None) -> Self:
        """Return the document with surface `number` (1 or 2) replaced."""
        one, two = self.sources
        return replace(self, sources=(source, two) if number == 1 else (one, source))

    def swapped(self) -> Self:
        """Return the document with the surfaces' roles exchanged."""
        return replace(self, sources=(self.sources[1], self.sources[0]))


def sample(name: str) -> Document:
    """Return the document of a built-in sample pair."""
    return Document(sources=(Source(sample=name, number=1), Source(sample=name, number=2)))
