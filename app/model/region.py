"""A named part of the plane of comparison."""

from dataclasses import dataclass

Polygon = tuple[tuple[float, float], ...]
Disc = tuple[float, float, float]
"""x, y of the centre, and the radius."""


@dataclass(frozen=True, slots=True)
class Region:
    """Where a lasso and a brush went; it stays in place when surfaces or grids change.

    Attributes
    ----------
    name : str
    colour : (int, int, int)
    weight : float
        µ of its triangles.
    polygons : tuple of Polygon
        A point belongs where it lies inside an odd number of windings of any of them.
    discs : tuple of Disc
        Dabs of the brush.
    """

    name: str
    colour: tuple[int, int, int]
    weight: float = 1.0
    polygons: tuple[Polygon, ...] = ()
    discs: tuple[Disc, ...] = ()
