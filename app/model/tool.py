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
        """Whether dragging draws a path; the right button turns the views meanwhile."""
        return self in {Tool.LASSO, Tool.BRUSH, Tool.SECTION}
