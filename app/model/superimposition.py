"""How both scans are looked at in one scene; nothing here changes a number."""

from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Self


class Style(StrEnum):
    """What a scan's triangles are drawn as."""

    SOLID = "solid"
    WIRE = "wire"
    POINTS = "points"


@dataclass(frozen=True, slots=True)
class Coat:
    """How one scan is drawn.

    Attributes
    ----------
    opacity : float
        0 to 1.
    style : Style
    heatmap : bool
        In the colours of the difference, else in the surface's own.
    """

    opacity: float = 1.0
    style: Style = Style.SOLID
    heatmap: bool = False


@dataclass(frozen=True, slots=True)
class Cut:
    """A plane that cuts both scans, upright on the plane of comparison.

    Attributes
    ----------
    axis : int
        0: x is the same all over it, 1: y is.
    share : float
        Where, from 0 at the lowest to 1 at the highest coordinate of both.
    """

    axis: int = 0
    share: float = 0.5


@dataclass(frozen=True, slots=True)
class Superimposition:
    """What the view of both scans shows.

    Attributes
    ----------
    coats : two Coat
    fade : float
        0: surface 1 alone, 1: surface 2 alone, 0.5: both.
    cut : Cut or None
    before : bool
        Surface 2 where it lay before it was moved onto surface 1.
    perspective : bool
        Near things look larger; else parallel lines stay so.
    """

    coats: tuple[Coat, Coat] = (Coat(), Coat(opacity=0.6))
    fade: float = 0.5
    cut: Cut | None = None
    before: bool = False
    perspective: bool = False

    def opacity(self, surface: int) -> float:
        """Tell how opaque surface 0 or 1 is, faded."""
        share = 1.0 - self.fade if surface == 0 else self.fade
        return self.coats[surface].opacity * min(1.0, 2.0 * share)

    def flickered(self) -> Self:
        """Return the state that shows the other scan alone: the eye finds a shift in a flicker."""
        return replace(self, fade=0.0 if self.fade > 0.0 else 1.0)

    def dressed(self, surface: int, coat: Coat) -> Self:
        """Return the state with another coat of surface 0 or 1."""
        coats = (coat, self.coats[1]) if surface == 0 else (self.coats[0], coat)
        return replace(self, coats=coats)
