"""The document: everything that decides the numbers, and the unit of the files."""

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Self

import numpy as np

from app.model.region import Region
from surfcmp_core.alignment import record_of_motion
from surfcmp_core.comparing.comparison import Options

Matrix = tuple[tuple[float, float, float, float], ...]

IDENTITY: Matrix = (
    (1.0, 0.0, 0.0, 0.0),
    (0.0, 1.0, 0.0, 0.0),
    (0.0, 0.0, 1.0, 0.0),
    (0.0, 0.0, 0.0, 1.0),
)
"""The motion that moves nothing."""
FIT_KEYS = frozenset(record_of_motion("none", np.eye(4))) - {"method", "matrix"}
"""What a fit says of itself."""


@dataclass(frozen=True, slots=True)
class Motion:
    """How surface 2 was moved onto surface 1, and how well that went.

    Attributes
    ----------
    matrix : 4 x 4 floats
        In the unit and axes of surface 1's file.
    method : str
        In words, for reports.
    residual : float or None
        Root mean square distance that was left, in the comparison's unit; None where unknown.
    pairs : int
        Pairs of places it was found from.
    fit : dict
        What a fit says of itself, by the keys of "alignment" in the .json result; else empty.
    """

    matrix: Matrix = IDENTITY
    method: str = "none"
    residual: float | None = None
    pairs: int = 0
    fit: dict[str, Any] = field(default_factory=dict)


NOT_MOVED = Motion()


@dataclass(frozen=True, slots=True)
class Document:
    """Inputs, options, motion and regions; equal documents give equal numbers."""

    paths: tuple[Path | None, Path | None] = (None, None)
    options: Options = field(default_factory=Options)
    motion: Motion = NOT_MOVED
    """Of surface 2."""
    unit: str = ""
    """What the user says the files' unit is; empty: what the files say."""
    project: str = "z"
    """Direction of view, as the command line's option of that name."""
    regions: tuple[Region, ...] = ()
    """Later ones lie over earlier ones."""

    @property
    def complete(self) -> bool:
        """Whether both surfaces are named."""
        return all(self.paths)

    def with_path(self, number: int, path: Path | None) -> Self:
        """Return the document with surface `number` (1 or 2) replaced, and no longer moved."""
        one, two = self.paths
        paths = (path, two) if number == 1 else (one, path)
        return replace(self, paths=paths, motion=NOT_MOVED)

    def swapped(self) -> Self:
        """Return the document with the surfaces' roles exchanged, where nothing was moved."""
        return replace(self, paths=(self.paths[1], self.paths[0]), motion=NOT_MOVED)

    def same_places(self, other: "Document") -> bool:
        """Whether both have the same T, so that places on one are places on the other."""
        options = replace(other.options, tolerances=self.options.tolerances)
        return replace(other, options=options, regions=self.regions) == self
