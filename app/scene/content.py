"""A comparison together with the arrays it is drawn from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from app.scene.geometry import Geometry, geometry_of

if TYPE_CHECKING:  # the window is on the screen before the core is loaded
    from surfcmp_core.comparison import Comparison


@dataclass(frozen=True, slots=True, eq=False)
class Content:
    """What the views show."""

    comparison: Comparison
    geometry: Geometry


def content_of(comparison: Comparison) -> Content:
    """Return the comparison ready to be drawn."""
    return Content(comparison, geometry_of(comparison))
