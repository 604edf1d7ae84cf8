"""Sheets of A4 that fill from top to bottom, a new one where one is full."""

from textwrap import wrap
from typing import TYPE_CHECKING, Any

from surfcmp_core.report.figures import QUIET, sheet
from surfcmp_core.report.provenance import Rows

if TYPE_CHECKING:
    from matplotlib.figure import Figure

WIDTH, HEIGHT = 8.27, 11.69
"""Inches."""
LEFT, TOP, BOTTOM = 0.8, 0.8, 0.9
"""Margins, inches."""
_LETTER = 0.071
"""Mean width of a letter of running text, inches."""


class Paper:
    """Sheets and the place where the next line goes.

    Attributes
    ----------
    pages : list of matplotlib.figure.Figure
        The sheets so far.
    down : float
        Base line of the next line, inches below the top of the last sheet.
    """

    def __init__(self) -> None:
        self.pages: list[Figure] = []
        self.turn()

    def turn(self) -> None:
        """Begin a new sheet."""
        self.pages.append(sheet(WIDTH, HEIGHT))
        self.down = TOP

    def need(self, height: float) -> None:
        """Begin a new sheet unless so much fits on this one."""
        if self.down + height > HEIGHT - BOTTOM:
            self.turn()

    def write(self, right: float, text: str, **style: Any) -> None:
        """Set one line, `right` inches from the left margin, without moving on."""
        write(self.pages[-1], LEFT + right, self.down, text, **style)

    def heading(self, text: str) -> None:
        """Set a heading that keeps a few lines below it on its sheet."""
        self.need(1.0)
        self.write(0.0, text, fontsize=11, fontweight="bold")
        self.down += 0.26

    def paragraph(self, text: str, indent: float = 0.0, **style: Any) -> None:
        """Set text in lines that fit."""
        for line in wrap(text, int((WIDTH - 2 * LEFT - indent) / _LETTER)) or [""]:
            self.need(0.0)
            self.write(indent, line, **style)
            self.down += 0.18

    def table(self, rows: Rows) -> None:
        """Set rows of a name and a text that may be long."""
        for name, text in rows:
            self.need(0.0)
            self.write(0.0, name, color=QUIET)
            self.paragraph(text, indent=1.75)
        self.down += 0.18


def write(page: "Figure", right: float, down: float, text: str, **style: Any) -> None:
    """Set one line at a place of a sheet, its base line `down` inches below the top."""
    style = {"fontsize": 8.0, **style}
    page.text(right / WIDTH, 1 - down / HEIGHT, text, parse_math=False, **style)
