"""Length units: how files state them, and their size in millimetres.

Which are converted is told at :func:`surfcmp_core.io.read_surface`.
"""

import re

MILLIMETRES = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "um": 0.001, "in": 25.4, "ft": 304.8}
"""Size in mm of each unit known."""

_NAMES = {
    "mm": r"mm|millimet(?:re|er)s?",
    "cm": r"cm|centimet(?:re|er)s?",
    "um": r"um|µm|μm|micromet(?:re|er)s?|microns?",
    "m": r"m|met(?:re|er)s?",
    "in": r"in|inch|inches",
    "ft": r"ft|foot|feet",
}
_NAME = "|".join(f"(?P<{unit}>{names})" for unit, names in _NAMES.items())
_STATEMENT = re.compile(rf"\bunits?\W+(?:(?:is|are|in)\W+)*(?:{_NAME})\W*$", re.IGNORECASE)
_LABEL = re.compile(rf"\W*(?:{_NAME})\b", re.IGNORECASE)


def unit_in(comments: tuple[str, ...]) -> str | None:
    """Find the unit in the first comment that ends like ``unit mm`` or ``Units: inches``."""
    for comment in comments:
        if found := _STATEMENT.search(comment):
            return found.lastgroup
    return None


def unit_named(label: str) -> str | None:
    """Find the unit a label such as ``mm``, ``m (as in file)`` or ``US survey foot`` means."""
    if re.search(r"survey|foot_us|us.ft", label, re.IGNORECASE):
        return "us-ft"
    found = _LABEL.match(label)
    return found.lastgroup if found else None
