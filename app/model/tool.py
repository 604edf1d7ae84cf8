"""What the left mouse button does over the views."""

from enum import StrEnum


class Tool(StrEnum):
    """Look is the usual one; the others draw or pick."""

    LOOK = "look"
    LASSO = "lasso"
    BRUSH = "brush"
    SECTION = "section"
    LANDMARK = "landmark"

    @property
    def draws(self) -> bool:
        """Whether dragging draws a path; it is drawn on the map, where the plane is seen."""
        return self in {Tool.LASSO, Tool.BRUSH, Tool.SECTION}
