"""How the comparison is looked at; nothing here changes a number."""

from dataclasses import dataclass, replace
from enum import StrEnum

from app.model.landmark import Pair


class Heatmap(StrEnum):
    """What the fourth view colours each triangle of T by."""

    ABSOLUTE = "absolute"
    SIGNED = "signed"
    REPRESENTATIVE = "representative"
    TRUST = "trust"
    HEIGHT_1 = "height 1"
    HEIGHT_2 = "height 2"

    @property
    def of_difference(self) -> bool:
        """Whether the colours stand for a difference, on the scale the user set."""
        return self in {Heatmap.ABSOLUTE, Heatmap.SIGNED, Heatmap.REPRESENTATIVE}


@dataclass(frozen=True, slots=True)
class Scale:
    """The range of the differences' colours: 0 to `limit`, or -`limit` to `limit` when signed.

    Attributes
    ----------
    limit : float
        Largest difference that has a colour of its own, in the unit of the input.
    tolerances : tuple of float
        Ascending; where `banded`, the colour changes at these and nowhere else.
    banded : bool
        Bands between tolerances in place of a continuous scale.
    pinned : bool
        The user chose `limit`: other inputs leave it alone.
    """

    limit: float = 1.0
    tolerances: tuple[float, ...] = (0.5, 1.0, 2.0)
    banded: bool = False
    pinned: bool = False


@dataclass(frozen=True, slots=True)
class Place:
    """A place on T: a triangle, and the weights of its nodes there."""

    triangle: int
    weights: tuple[float, float, float]


KEPT = ("heatmap", "scale", "edges", "probes", "section", "landmarks")
"""Fields of `ViewState` that are steps of the history; the others pass, as the camera does."""


@dataclass(frozen=True, slots=True)
class ViewState:
    """What the four views show."""

    relief: bool = True
    heatmap: Heatmap = Heatmap.SIGNED
    scale: Scale = Scale()
    edges: bool = True
    filled: int | None = None
    """The view (0 to 3) that has the window to itself."""
    picked: Place | None = None
    """The place on T shown in all views."""
    probes: tuple[Place, ...] = ()
    """Places whose labels stay."""
    chain: int | None = None
    """The chain that stands out from the others."""
    brush: tuple[float, float] | None = None
    """The range of differences that stands out; the others fade."""
    section: tuple[float, float, float, float] | None = None
    """The line along which profiles are drawn: x, y of its ends in the plane of comparison."""
    landmarks: tuple[Pair, ...] = ()
    dark: bool = False

    @property
    def kept(self) -> "ViewState":
        """The state that undo and redo bring back; all else is as at first."""
        return ViewState(**{name: getattr(self, name) for name in KEPT})

    @property
    def drawn(self) -> "ViewState":
        """The state without what is laid over the pictures and not drawn in them."""
        return replace(self, picked=None, probes=(), filled=None, landmarks=())

    def within(self, triangles: int) -> "ViewState":
        """Return the state without places on triangles that T, with so many, does not have."""
        there = tuple(place for place in self.probes if place.triangle < triangles)
        picked = self.picked
        if picked is not None and picked.triangle >= triangles:
            picked = None
        return replace(self, probes=there, picked=picked)
