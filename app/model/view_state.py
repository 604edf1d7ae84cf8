"""How the comparison is looked at; nothing here changes a number.

A field of `Kept` is a step of the history, one of `ViewState` passes; both are saved with the
session, by name and type. What a field says of itself where it is declared is all there is to it.
"""

from dataclasses import dataclass, field, fields, replace
from enum import Enum, StrEnum
from typing import Self

from app.model.landmark import Landmark
from surfcmp_core.colours.scale import Scale


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


class ChainsBy(StrEnum):
    """What the third view colours the chains by."""

    ROLE = "role"
    """Rings round one node quiet, longer closed chains by length, open ones strong."""
    LENGTH = "length"
    MEAN = "mean"
    """Mean of |d| over a chain."""
    ORDER = "order"
    """In which they were found."""


@dataclass(frozen=True, slots=True)
class ScaleChoice:
    """What the user chose of the differences' colours.

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


class Of(Enum):
    """What a field belongs to: with another one of these it is as at first."""

    PLACES = "places"
    """The triangles of one T."""
    FILES = "files"
    WINDOW = "window"
    """It stays with the window whatever is opened."""


_PLACES, _FILES, _WINDOW = ({"of": owner} for owner in (Of.PLACES, Of.FILES, Of.WINDOW))


@dataclass(frozen=True, slots=True)
class Kept:
    """What undo and redo bring back: each change of it is a step of the history."""

    heatmap: Heatmap = Heatmap.SIGNED
    scale: ScaleChoice = ScaleChoice()
    edges: bool = True
    chains_by: ChainsBy = ChainsBy.ROLE
    probes: tuple[Place, ...] = field(default=(), metadata=_PLACES)
    """Places whose labels stay."""
    section: tuple[float, float, float, float] | None = field(default=None, metadata=_PLACES)
    """The line along which profiles are drawn: x, y of its ends in the plane of comparison."""
    landmarks: tuple[Landmark, ...] = field(default=(), metadata=_FILES)

    @property
    def colours(self) -> Scale:
        """The colours of differences, in the views and in reports."""
        chosen = self.scale
        bands = tuple(sorted(chosen.tolerances)) if chosen.banded else ()
        return Scale(chosen.limit, bands, self.heatmap is Heatmap.SIGNED)

    def without(self, owner: Of) -> Self:
        """Return the same with what belongs to `owner` as at first."""
        first = type(self)()
        mine = [part.name for part in fields(self) if part.metadata.get("of") is owner]
        return replace(self, **{name: getattr(first, name) for name in mine})

    def changed_as(self, old: "Kept", new: "Kept") -> Self:
        """Return the same with what `new` has in another way than `old` as `new` has it."""
        pairs = {part.name: (getattr(old, part.name), getattr(new, part.name)) for part in _KEPT}
        return replace(self, **{name: two for name, (one, two) in pairs.items() if one != two})


_KEPT = fields(Kept)


@dataclass(frozen=True, slots=True)
class ViewState(Kept):
    """What the four views show: what is kept, and what passes as the camera does."""

    relief: bool = True
    filled: int | None = field(default=None, metadata=_WINDOW)
    """The view (0 to 3) that has the window to itself."""
    picked: Place | None = field(default=None, metadata=_PLACES)
    """The place on T shown in all views."""
    chain: int | None = field(default=None, metadata=_PLACES)
    """The chain that stands out from the others."""
    brush: tuple[float, float] | None = field(default=None, metadata=_PLACES)
    """The range of differences that stands out; the others fade."""
    dark: bool = field(default=False, metadata=_WINDOW)

    @property
    def kept(self) -> Kept:
        """The part that undo and redo bring back."""
        return Kept(**{part.name: getattr(self, part.name) for part in _KEPT})

    def keeping(self, kept: Kept) -> Self:
        """Return the state with another part that undo and redo bring back."""
        return replace(self, **{part.name: getattr(kept, part.name) for part in _KEPT})

    def in_window_of(self, other: "ViewState") -> Self:
        """Return the state in the window that shows `other`."""
        mine = [part.name for part in fields(self) if part.metadata.get("of") is Of.WINDOW]
        return replace(self, **{name: getattr(other, name) for name in mine})

    @property
    def saved(self) -> Self:
        """The state as a session keeps it."""
        return replace(self, filled=None)

    @property
    def drawn(self) -> Self:
        """The state without what is laid over the pictures and not drawn in them."""
        return replace(self, picked=None, probes=(), filled=None, landmarks=())

    def within(self, triangles: int) -> Self:
        """Return the state without places on triangles that T, with so many, does not have."""
        there = tuple(place for place in self.probes if place.triangle < triangles)
        picked = self.picked
        if picked is not None and picked.triangle >= triangles:
            picked = None
        return replace(self, probes=there, picked=picked)
