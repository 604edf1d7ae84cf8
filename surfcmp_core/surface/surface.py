"""A surface as it was read: nodes in space, its own triangles, and where it came from."""

from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Duplicates = Literal["refuse", "mean", "max", "min"]
"""What to do with nodes of equal (x, y) and different z."""


@dataclass(frozen=True, slots=True, eq=False)
class Surface:
    """A cloud or a mesh, as read.

    Attributes
    ----------
    points : (n, 3) float64
        x, y, z of each node, in `unit`. Finite, but for nodes of a mesh that no triangle uses:
        those are no part of the surface (:mod:`surfcmp_core.surface.used`).
    faces : (m, 3) int32 or None
        The model's own triangles, as node numbers; None for a cloud.
    name : str
        How messages call it: the file's name, or "surface 1".
    path : Path or None
        The file it was read from.
    sha256 : str
        Of the file's bytes, lower-case hexadecimal; empty for arrays.
    unit : str or None
        Length unit of `points`; None where the file does not say.
    scale : Fraction
        How many `unit` one unit of the file's own coordinates is.
    space : {"RAS", "LPS"} or None
        Which axes `points` has, as medical programs state it: x to the right, y to the front, z
        up, or x to the left, y to the back, z up; None where the file does not say.
    turned : bool
        Whether x and y have another sign than in the file.
    georeferenced : bool
        Whether `unit` is that of a geodetic reference system, which the file names.
    dropped : dict of str to int
        Nodes left out so far, counted by reason.
    changed : dict of str to int
        What reading did to the model besides (polygons split, faces left out, nodes converted to
        another unit), counted.
    """

    points: NDArray[np.float64]
    faces: NDArray[np.int32] | None = None
    name: str = "surface"
    path: Path | None = None
    sha256: str = ""
    unit: str | None = None
    scale: Fraction = Fraction(1)
    space: str | None = None
    turned: bool = False
    georeferenced: bool = False
    dropped: dict[str, int] = field(default_factory=dict)
    changed: dict[str, int] = field(default_factory=dict)

    @property
    def kind(self) -> str:
        """``"mesh"`` or ``"cloud"``."""
        return "cloud" if self.faces is None else "mesh"

    @property
    def from_file(self) -> NDArray[np.float64]:
        """(4, 4) what leads from the file's own coordinates to `points`."""
        scale, sign = float(self.scale), -1.0 if self.turned else 1.0
        return np.diag([sign * scale, sign * scale, scale, 1.0])
