"""The document: everything that decides the numbers."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Self

from app.model.region import Region
from surfcmp_core.comparing.options import DEFAULTS, NOT_MOVED, Motion, Options


@dataclass(frozen=True, slots=True)
class Document:
    """Inputs, options and regions; equal documents give equal numbers."""

    paths: tuple[Path | None, Path | None] = (None, None)
    options: Options = DEFAULTS
    """As for every comparison; `align` is a motion that is known."""
    regions: tuple[Region, ...] = ()
    """Later ones lie over earlier ones."""

    @property
    def complete(self) -> bool:
        """Whether both surfaces are named."""
        return all(self.paths)

    @property
    def motion(self) -> Motion:
        """Of surface 2."""
        assert isinstance(self.options.align, Motion)
        return self.options.align

    def asking(self, **options: Any) -> Self:
        """Return the document with some options changed."""
        return replace(self, options=replace(self.options, **options))

    def with_path(self, number: int, path: Path | None) -> Self:
        """Return the document with surface `number` (1 or 2) replaced, and no longer moved."""
        one, two = self.paths
        paths = (path, two) if number == 1 else (one, path)
        return replace(self, paths=paths).asking(align=NOT_MOVED)

    def swapped(self) -> Self:
        """Return the document with the surfaces' roles exchanged, where nothing was moved."""
        return replace(self, paths=self.paths[::-1]).asking(align=NOT_MOVED)

    def same_places(self, other: "Document") -> bool:
        """Whether both have the same T, so that places on one are places on the other."""
        alike = other.asking(tolerances=self.options.tolerances)
        return replace(alike, regions=self.regions) == self
