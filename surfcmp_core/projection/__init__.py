"""From scans as they lie to z = F(x, y): the viewing direction and the part that it shows."""

from surfcmp_core.projection.direction import viewing_direction
from surfcmp_core.projection.frame import direction_of_landmarks, frame, moved

__all__ = ["direction_of_landmarks", "frame", "moved", "viewing_direction"]
