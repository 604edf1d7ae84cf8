"""What a projection leaves out, and why."""

from dataclasses import dataclass
from enum import IntEnum

import numpy as np
from numpy.typing import NDArray


class Fate(IntEnum):
    """What becomes of a triangle."""

    KEPT = 0
    DEGENERATE = 1
    """Without area in the plane."""
    BACK_FACING = 2
    """Its outer side looks away from the viewer."""
    HIDDEN = 3
    """Something lies in front of it, or of one of its nodes."""
    ISLAND = 4
    """Part of a small piece that hangs together with nothing else."""

    @property
    def label(self) -> str:
        """Name in reports and counts."""
        return self.name.lower().replace("_", "-")


@dataclass(frozen=True, slots=True, eq=False)
class Removed:
    """The parts of one surface that its one-valued part lacks.

    Attributes
    ----------
    faces : (k, 3) int32
        Triangles removed, in node numbers of the surface as it was.
    fate : (k,) uint8
        Why: a `Fate` each.
    kept : (n,) int64
        For each node of the one-valued part, its number in the surface as it was.
    nodes : dict of str to int
        Nodes removed by reason, only reasons that occur; a node that several triangles lost goes by
        the last of their reasons in the order of `Fate`.
    area : dict of str to float
        Area in space of the triangles removed, by reason.
    area_kept : float
        Area in space of the triangles kept.
    reversed : bool
        Whether the file's triangles were turned over, because their outer side was inside.
    """

    faces: NDArray[np.int32]
    fate: NDArray[np.uint8]
    kept: NDArray[np.int64]
    nodes: dict[str, int]
    area: dict[str, float]
    area_kept: float
    reversed: bool
