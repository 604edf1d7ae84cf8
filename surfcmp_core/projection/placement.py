"""From two surfaces as they lie to two that can be compared along one view."""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.linear_algebra import composed
from surfcmp_core.projection import (
    Removed,
    frame,
    moved,
    rounded_off,
    schlicht_part,
    seen_from_behind,
    viewing_direction,
    wound_alike,
)
from surfcmp_core.surface import Surface
from surfcmp_core.surface.refusals import LARGEST_IN_SPACE, refuse_surface
from surfcmp_core.surface.together import check_together
from surfcmp_core.surface.used import UNUSED, nodes_in_use, used_part

View = Literal["auto"] | tuple[float, float, float]
"""The direction towards the viewer; "auto": the one that shows most of both surfaces."""
_BELOW = -0.5
"""Cosine to the files' +z below which a direction that was found looks from their other side."""


@dataclass(frozen=True, slots=True, eq=False)
class Placement:
    """Two surfaces seen along z, one-valued.

    Attributes
    ----------
    surfaces : two Surface
        What is seen, in the comparison's coordinates; nodes left out are counted in `dropped`,
        triangles turned to wind like their neighbours in `changed`.
    removed : two Removed
        What is not seen, and why.
    motions : two (4, 4) float64
        From the coordinates of each surface to the comparison's.
    sought : bool
        Whether the direction was found from the surfaces.
    """

    surfaces: tuple[Surface, Surface]
    removed: tuple[Removed, Removed]
    motions: tuple[NDArray[np.float64], NDArray[np.float64]]
    sought: bool = False

    @property
    def warnings(self) -> tuple[str, ...]:
        """Which side is looked at, where it is not plain; how much of each surface is left out."""
        result = self._sides()
        for surface, removed in zip(self.surfaces, self.removed, strict=True):
            lost = sum(removed.area.values())
            nodes = sum(count for why, count in removed.nodes.items() if why != UNUSED)
            if lost > 0:
                share = f"{100 * lost / (lost + removed.area_kept):.3g} % of its area"
                result.append(f"{surface.name}: {share} is not seen in this view and is left out")
            elif nodes:
                result.append(f"{surface.name}: {nodes} nodes below others are left out")
        return tuple(result)

    def _sides(self) -> list[str]:
        names = [surface.name for surface in self.surfaces]
        backs = [k for k in range(2) if self.removed[k].reversed]
        meshes = [surface.faces is not None for surface in self.surfaces]
        if len(backs) == 1 and all(meshes):
            (k,) = backs
            return [
                f"{names[k]}: its triangles wind against those of {names[1 - k]}:"
                " it is looked at from its back; turn them over if that is not meant"
            ]
        result = [
            f"{names[k]}: is looked at from its back, for its triangles wind clockwise in this view"
            for k in backs
        ]
        if self.sought and any(meshes) and self.motions[0][2, 2] < _BELOW:
            wound = " and ".join(n for n, mesh in zip(names, meshes, strict=True) if mesh)
            result.append(
                f"{wound}: seen from the files' +z, triangles wind clockwise, so --project auto"
                " looks from the other side: signs count towards that viewer"
            )
        return result


@dataclass(frozen=True, slots=True, eq=False)
class Sight:
    """One surface seen along z, one-valued.

    Attributes
    ----------
    part : Surface
        What is seen, in the view's coordinates; counted as in a :class:`Placement`.
    removed : Removed
        What is not seen, and why.
    motion : (4, 4) float64
        From the surface's coordinates to the view's; the third row is the direction.
    """

    part: Surface
    removed: Removed
    motion: NDArray[np.float64]


def look_at(surface: Surface, view: View = "auto") -> Sight:
    """Turn one surface so that the view runs along z, and keep what is seen of it.

    Parameters
    ----------
    surface : Surface
    view
        As for :func:`place`; "auto": the one that shows most of this surface.

    Returns
    -------
    Sight

    Raises
    ------
    InputError
        The surface shows nothing in this view, or no view can be found.
    """
    refuse_surface(surface, LARGEST_IN_SPACE)
    used = wound_alike(used_part(surface))
    motion = frame(viewing_direction(used) if view == "auto" else view)
    room = rounded_off(used, motion)
    return Sight(*_seen(moved(used, motion), None, room, surface), motion)


def place(
    surface_1: Surface, surface_2: Surface, view: View, align: NDArray[np.float64] | None = None
) -> Placement:
    """Turn two surfaces so that the view runs along z, and keep what is seen of each.

    Parameters
    ----------
    surface_1, surface_2
        As they lie, in one unit.
    view
        One for both; any length.
    align : (4, 4) float64, optional
        Motion of surface 2 onto surface 1, before the view is taken.

    Returns
    -------
    Placement

    Raises
    ------
    InputError
        Unlike units or axes; a surface shows nothing in this view, or no view can be found.
    """
    check_together(surface_1, surface_2)
    for surface in (surface_1, surface_2):
        refuse_surface(surface, LARGEST_IN_SPACE)
    used_1, used_2 = (wound_alike(used_part(one)) for one in (surface_1, surface_2))
    second = used_2 if align is None else moved(used_2, align)
    refuse_surface(second, LARGEST_IN_SPACE)
    turn = frame(viewing_direction(used_1, second) if view == "auto" else view)
    motions = (turn, turn if align is None else composed(turn, align))
    seen_1, seen_2 = moved(used_1, motions[0]), moved(used_2, motions[1])
    behind_1, behind_2 = seen_from_behind(seen_1, seen_2)
    room_1, room_2 = rounded_off(used_1, motions[0]), rounded_off(used_2, motions[1])
    part_1, removed_1 = _seen(seen_1, behind_1, room_1, surface_1)
    part_2, removed_2 = _seen(seen_2, behind_2, room_2, surface_2)
    return Placement((part_1, part_2), (removed_1, removed_2), motions, view == "auto")


def _seen(
    used: Surface, behind: bool | None, room: float, whole: Surface
) -> tuple[Surface, Removed]:
    """Keep what is seen of a surface's used part; what is not, in the whole surface's numbers."""
    part, removed = schlicht_part(used, behind=behind, room=room)
    lost = len(whole.points) - len(used.points)
    if not lost:
        return part, removed
    number = nodes_in_use(whole)
    return part, replace(
        removed,
        faces=number[removed.faces].astype(np.int32),
        kept=number[removed.kept],
        nodes={UNUSED: lost, **removed.nodes},
    )
