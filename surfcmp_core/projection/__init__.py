"""From scans as they lie to z = F(x, y): the viewing direction and the part that it shows."""

from surfcmp_core.projection.direction import viewing_direction
from surfcmp_core.projection.frame import direction_of_landmarks, frame, moved, rounded_off
from surfcmp_core.projection.outer_side import seen_from_behind
from surfcmp_core.projection.removed import Fate, Removed
from surfcmp_core.projection.schlicht import schlicht_part
from surfcmp_core.projection.winding import wound_alike

__all__ = [
    "Fate",
    "Removed",
    "direction_of_landmarks",
    "frame",
    "moved",
    "rounded_off",
    "schlicht_part",
    "seen_from_behind",
    "viewing_direction",
    "wound_alike",
]
