"""A named part of the plane of comparison."""

from dataclasses import dataclass

Track = tuple[tuple[float, float], ...]
"""x, y of where the mouse went."""


@dataclass(frozen=True, slots=True)
class Stroke:
    """One drag of the lasso or of the brush.

    Attributes
    ----------
    path : Path
    radius : float
        Of the brush: it covers what is that near to the path. 0: a lasso, it covers what lies
        inside an odd number of windings of the path.
    takes : bool
        What it covers is taken away from the region, else added to it.
    """

    path: Track
    radius: float = 0.0
    takes: bool = False


@dataclass(frozen=True, slots=True)
class Region:
    """Strokes, one after the other; they stay in place when surfaces or grids change.

    Attributes
    ----------
    name : str
    colour : (int, int, int)
    weight : float
        µ of its triangles.
    strokes : tuple of Stroke
    """

    name: str
    colour: tuple[int, int, int]
    weight: float = 1.0
    strokes: tuple[Stroke, ...] = ()
