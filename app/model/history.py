"""Undo and redo: what was compared and how it was looked at, step by step."""

from dataclasses import dataclass, fields, replace
from enum import StrEnum

from app.model.document import Document
from app.model.view_state import Kept

MOST_STEPS = 300


class Change(StrEnum):
    """What one step changed."""

    SURFACES = "surfaces"
    MOTION = "motion"
    OPTIONS = "options"
    REGIONS = "regions"
    PAINT = "paint"
    REGION_NAME = "region name"
    REGION_COLOUR = "region colour"
    REGION_WEIGHT = "region weight"
    SCALE = "scale"
    # fields of `Kept`, by their names
    HEATMAP = "heatmap"
    EDGES = "edges"
    PROBES = "probes"
    SECTION = "section"
    LANDMARKS = "landmarks"
    VIEW = "view"
    """A field of `Kept` that has no name here."""


@dataclass(frozen=True, slots=True)
class Step:
    """A document, and the part of the view that undo brings back."""

    document: Document
    view: Kept


def change_between(old: Step, new: Step) -> Change:
    """Return what `new` changed; the weightiest where it is several things at once."""
    one, two = old.document, new.document
    if one.paths != two.paths:
        return Change.SURFACES
    if one.motion != two.motion:
        return Change.MOTION
    if one.regions != two.regions:
        return _region_change(one, two)
    if not one.same_places(two):
        return Change.OPTIONS
    if old.view.scale != new.view.scale or one != two:
        return Change.SCALE
    names = [part.name for part in fields(Kept)]
    name = next(name for name in names if getattr(old.view, name) != getattr(new.view, name))
    return Change(name) if name in Change else Change.VIEW


def _region_change(one: Document, two: Document) -> Change:
    if len(one.regions) != len(two.regions):
        return Change.REGIONS
    for name, change in (
        ("strokes", Change.PAINT),
        ("weight", Change.REGION_WEIGHT),
        ("colour", Change.REGION_COLOUR),
    ):
        if any(
            getattr(a, name) != getattr(b, name)
            for a, b in zip(one.regions, two.regions, strict=True)
        ):
            return change
    return Change.REGION_NAME


class History:
    """The steps so far, and which of them is current."""

    def __init__(self, first: Step) -> None:
        self._steps = [first]
        self._index = 0

    @property
    def current(self) -> Step:
        """The step in force."""
        return self._steps[self._index]

    @property
    def undoable(self) -> Change | None:
        """What undo would take back; None where there is nothing."""
        if self._index == 0:
            return None
        return change_between(self._steps[self._index - 1], self.current)

    @property
    def redoable(self) -> Change | None:
        """What redo would do again; None where there is nothing."""
        if self._index + 1 == len(self._steps):
            return None
        return change_between(self.current, self._steps[self._index + 1])

    def push(self, step: Step, *, merged: bool = False) -> bool:
        """Make `step` current and forget what was undone; say whether anything changed.

        `merged`: one step with the current one, where both changed the scale, as a drag does.
        """
        if step == self.current:
            return False
        del self._steps[self._index + 1 :]
        if (
            merged
            and self.undoable is Change.SCALE
            and change_between(self.current, step) is Change.SCALE
        ):
            self._replace(step)
            return True
        self._steps.append(step)
        del self._steps[:-MOST_STEPS]
        self._index = len(self._steps) - 1
        return True

    def amend(self, view: Kept) -> None:
        """Replace the view of the current step: it follows from its document."""
        self._replace(replace(self.current, view=view))

    def begin(self) -> None:
        """Forget the steps before the current one that had nothing to compare."""
        kept = [step for step in self._steps[: self._index] if step.document.complete]
        self._steps[: self._index] = kept
        self._index = len(kept)
        self._replace(self.current)

    def drop(self) -> None:
        """Forget the current document, as one that came to nothing, and all after it."""
        failed = self.current.document
        while self._index and self.current.document == failed:
            self._index -= 1
        del self._steps[self._index + 1 :]

    def go_to(self, document: Document) -> None:
        """Return to a document: what was done since is forgotten, what was undone is not."""
        places = [k for k, step in enumerate(self._steps) if step.document == document]
        before = [k for k in places if k <= self._index]
        if before:
            self._index = before[-1]
            del self._steps[self._index + 1 :]
        elif places:
            self._index = places[0]
        else:
            view = self.current.view
            self.drop()
            self.push(Step(document, view))

    def _replace(self, step: Step) -> None:
        """Put a step in place of the current one; neighbours that are the same are one step."""
        before, after = self._steps[: self._index], self._steps[self._index + 1 :]
        while before and before[-1] == step:
            before.pop()
        while after and after[0] == step:
            after.pop(0)
        self._steps = [*before, step, *after]
        self._index = len(before)

    def undo(self) -> Step:
        """Step back and return the step now current."""
        self._index = max(self._index - 1, 0)
        return self.current

    def redo(self) -> Step:
        """Step forward and return the step now current."""
        self._index = min(self._index + 1, len(self._steps) - 1)
        return self.current
