"""Axes as medical programs state them in lines of comment."""

import re
from dataclasses import dataclass

from surfcmp_core.names import quoted

_STATEMENT = re.compile(
    r"\b(?:space|coordinate[ _-]?system)\s*[=:]+\s*(?P<name>[a-z]{3}\b|\w+-\w+-\w+)", re.IGNORECASE
)
_NAMES = {
    "ras": "RAS",
    "right-anterior-superior": "RAS",
    "lps": "LPS",
    "left-posterior-superior": "LPS",
}


@dataclass(frozen=True, slots=True)
class StatedSpace:
    """What lines of comment say of the axes.

    Attributes
    ----------
    name : {"RAS", "LPS"} or None
        None where nothing is said that is understood.
    odd : tuple of str
        Statements that are not understood, or contradict each other, quoted.
    """

    name: str | None
    odd: tuple[str, ...] = ()


def stated_space(comments: tuple[str, ...]) -> StatedSpace:
    """Find the axes in comments such as 3D Slicer's ``SPACE=LPS``."""
    said = {
        found["name"].lower(): comment.strip()
        for comment in comments
        for found in _STATEMENT.finditer(comment)
    }
    names = {_NAMES.get(word) for word in said}
    if len(names) > 1 or names == {None}:
        odd = (f"statement of axes that is not understood: {quoted(one)}" for one in said.values())
        return StatedSpace(None, tuple(dict.fromkeys(odd)))
    return StatedSpace(next(iter(names), None))
