"""What is asked of a comparison: every option that changes its numbers, whoever asks."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import OptionError
from surfcmp_core.surface import Duplicates

Domain = Literal["data", "hull", "plane"]
Weight = Callable[[NDArray[np.float64], NDArray[np.float64]], NDArray[np.float64]]
"""µ(x, y), sampled at the nodes of T and linear on each of its triangles."""
Matrix = tuple[tuple[float, float, float, float], ...]

IDENTITY: Matrix = (
    (1.0, 0.0, 0.0, 0.0),
    (0.0, 1.0, 0.0, 0.0),
    (0.0, 0.0, 1.0, 0.0),
    (0.0, 0.0, 0.0, 1.0),
)
"""The motion that moves nothing."""


@dataclass(frozen=True, slots=True)
class Motion:
    """How surface 2 was moved onto surface 1, and how well that went.

    Attributes
    ----------
    matrix : 4 x 4 floats
        Rigid; in the unit and axes of surface 1's file.
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
class Options:
    """Everything that changes the numbers but the surfaces; lengths in the comparison's unit.

    Raises
    ------
    OptionError
        One of them means nothing.
    """

    domain: Domain = "data"
    """Compare where both have data, inside both hulls, or over all of T, where either surface goes
    on with the nearest value of its hull."""
    max_edge: float | None = None
    """Longest edge over which a cloud has data; None: derived from its spacing; inf: no limit."""
    exact: bool = False
    """Also integrate exactly: over the overlay of T1 and T2 within both hulls; where `domain` is
    "data" and a surface is a mesh, on its own faces, over the area common to both."""
    tolerances: tuple[float, ...] = (0.5, 1.0, 2.0)
    """Lengths for which to give the share of the area within."""
    duplicates: Duplicates = "refuse"
    """What to do with nodes of equal (x, y) and different z."""
    threads: int = 2
    """How many may work at once."""
    unit: str | None = None
    """Of the files' coordinates, whatever they say; None: what they say."""
    no_data: tuple[float, ...] = ()
    """Values of x, y or z, in the file's unit, that stand for no data; NaN: all not finite."""
    weight: Path | Weight | None = None
    """µ, or the surface file whose third column it is; None: 1."""
    align: Motion | Path | Literal["icp"] = NOT_MOVED
    """How to move surface 2 onto surface 1: as known, by the matrix in a file, or by best fit."""
    project: str = "z"
    """The direction of view: "z", "auto", or "view:X,Y,Z" in the axes of surface 1's file."""
    verify: bool = False
    """Check all that must hold of the result, not only what takes no time."""

    def __post_init__(self) -> None:
        """Refuse what no input could make right."""
        for name, kind in (("domain", Domain), ("duplicates", Duplicates)):
            if getattr(self, name) not in get_args(kind):
                raise OptionError(name, getattr(self, name), f"one of {', '.join(get_args(kind))}")
        if self.max_edge is not None and not self.max_edge > 0.0:
            raise OptionError("max_edge", self.max_edge, "above zero (inf: no limit)")
        for tolerance in self.tolerances:
            if not 0.0 <= tolerance < math.inf:
                raise OptionError("tolerance", tolerance, "a number, zero or above")
        if not (isinstance(self.threads, int) and self.threads >= 1):
            raise OptionError("threads", self.threads, "a whole number above zero")
        self.view  # noqa: B018 - raises where it is none

    @property
    def view(self) -> Literal["auto"] | tuple[float, float, float] | None:
        """The direction towards the viewer; None: along z, and nothing is hidden."""
        if self.project == "z":
            return None
        if self.project == "auto":
            return "auto"
        kind, _, numbers = self.project.partition(":")
        try:
            x, y, z = (float(number) for number in numbers.split(","))
        except ValueError:
            x = y = z = 0.0
        if kind != "view" or not 0.0 < math.sqrt(x * x + y * y + z * z) < math.inf:
            raise OptionError("project", self.project, "auto, z or view:X,Y,Z")
        return x, y, z


DEFAULTS = Options()
