"""What a reader of a comparison has to know about the surfaces, in words."""

from collections.abc import Sequence

import numpy as np

from surfcmp_core.comparing.comparison import MeshFaces
from surfcmp_core.compiled.linear_algebra import length
from surfcmp_core.domain.layers import MIXED
from surfcmp_core.errors import InputError
from surfcmp_core.io.facts import folded_share
from surfcmp_core.io.no_data import suspected
from surfcmp_core.surface import Surface
from surfcmp_core.surface.used import UNUSED

_ALIKE = 5.0
"""Surfaces whose sizes differ by more than this factor are questioned."""


def _unused(surface: Surface) -> list[str]:
    count = surface.dropped.get(UNUSED)
    return [f"{count} nodes that no triangle uses are left out"] if count else []


def _changed(surface: Surface) -> dict[str, int]:
    """Tell what its reader did and saw; of arrays, which none has read, what one would see."""
    return surface.changed if surface.path else {**surface.changed, **suspected(surface.points)}


def _folding(surface: Surface) -> list[str]:
    share = folded_share(surface)
    return [f"{100.0 * share:.3g} % of the area, seen along z, folds over"] if share else []


def _layered(share: float) -> list[str]:
    if share <= MIXED:
        return []
    return [
        f"not one-valued: seen along z, {100.0 * share:.3g} % of its nodes lie among nodes of "
        "another layer, as where front and back are mixed (--project auto keeps what is seen)"
    ]


def nothing_common(
    first: Surface, second: Surface, limits: tuple[float, float], *, derived: bool
) -> InputError:
    """Say that there is nothing to compare, and how far the edges of clouds may reach."""
    told = [
        f"{limit:.4g} {surface.unit or ''}".rstrip() + f" ({surface.name})"
        for surface, limit in zip((first, second), limits, strict=True)
        if limit < np.inf
    ]
    fault = InputError("no common area to compare", where=(first.name, second.name))
    if not told:
        return fault
    how = ", as derived from the spacing of the nodes" if derived else ""
    return fault.with_hints(
        f"over edges longer than {' and '.join(told)} a cloud has no data{how}"
        " (--max-edge says how long they may be)"
    )


def _overlapping(faces: MeshFaces | None) -> list[str]:
    if faces is None or faces.overlapping == 0:
        return []
    return [
        f"{faces.overlapping} faces lie over others in the plane; "
        "the exact reading does not take all of them as the file has them"
    ]


def _unlike(first: Surface, second: Surface) -> list[str]:
    """Question a pair of which one is far larger than the other: their units may differ."""
    sizes = [length(np.ptp(s.points, axis=0)) for s in (first, second)]
    ratio = max(sizes) / min(sizes)
    if ratio <= _ALIKE:
        return []
    return [
        f"{first.name} and {second.name}: one is {ratio:.3g} times as large as the other; "
        "are both in the same unit?"
    ]


def cautions(
    pair: tuple[Surface, Surface],
    among_layers: Sequence[float],
    faces: Sequence[MeshFaces | None],
) -> tuple[str, ...]:
    """Say what a reader of the result has to know about either surface.

    Parameters
    ----------
    pair : (Surface, Surface)
        In the comparison's coordinates.
    among_layers : two float
        Share of each cloud's nodes that lie among those of another layer.
    faces : two MeshFaces or None
        What became of each mesh's faces.

    Returns
    -------
    tuple of str
        A line each, with the surface's name.
    """
    notes = [
        f"{surface.name}: {note}"
        for surface, share, own in zip(pair, among_layers, faces, strict=True)
        for note in (
            *(f"{count} {what}" for what, count in _changed(surface).items()),
            *_unused(surface),
            *_folding(surface),
            *_layered(share),
            *_overlapping(own),
        )
    ]
    return (*notes, *_unlike(*pair))
