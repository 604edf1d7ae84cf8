"""Units of length as files write them: names, and statements in lines of comment.

Which are converted is told at :func:`surfcmp_core.io.read_surface`.
"""

import re
from dataclasses import dataclass
from fractions import Fraction

from surfcmp_core.names import quoted
from surfcmp_core.surface.units import SIZES, name_of

_NAMES = {
    "us-ft": r"us[-_ ]?(?:survey[-_ ]?)?(?:ft|foot|feet)|u\.s\. survey (?:ft|foot|feet)"
    r"|survey[-_ ](?:ft|foot|feet)|(?:ft|foot|feet)[-_ ]?us|(?:ft|foot|feet) ?\(us(?: survey)?\)",
    "nm": r"nm|nanomet(?:re|er)s?",
    # the letter µ as Latin-1, Mac Roman and UTF-8 have it, and what it looks like where it was
    # written in the code pages 1253 (ì) or 437 and 850 (æ), or in UTF-8 twice (Âµ, Î¼)
    "um": r"um|(?:µ|μ|ì|æ|Âµ|Î¼)m|(?:micro|µ|μ|Âµ|Î¼)-?met(?:re|er)s?|microns?",
    "mm": r"mm|milli-?met(?:re|er)s?",
    "cm": r"cm|centi-?met(?:re|er)s?",
    "dm": r"dm|decimet(?:re|er)s?",
    "km": r"km|kilomet(?:re|er)s?",
    "m": r"m|met(?:re|er)s?",
    "mil": r"mils?|thou",
    "in": r"in|inch|inches",
    "ft": r"ft|foot|feet",
    "yd": r"yds?|yards?",
}
_NAME = "(?:" + "|".join(f"(?P<{unit.replace('-', '_')}>{n})" for unit, n in _NAMES.items()) + ")"
_END = r"[\s.:!)\]>]*(?:[(\[][^()\[\]]*[)\]]\W*)?$"
"""What may follow a unit: a remark in brackets, but no power, no quotient, no other word."""
_BEFORE = r"(?P<before>(?:[^\s:]+:?\s+)*?)"
_NUMBER = r"(?P<number>\d+(?:[.,]\d*)?(?:e[-+]?\d+)?|[.,]\d+)\s*"

_EQUATIONS = (
    rf"{_BEFORE}(?:(?:1|1[.,]0+|one|a|each|the)\s+)?units?\s*(?:[=:]+|is|are|equals?)\s*"
    rf"{_NUMBER}{_NAME}{_END}",
    rf"{_BEFORE}(?:1|one)\s+unit\s*(?:[=:]+|is|equals?)\s*{_NAME}{_END}",
    rf"{_BEFORE}{_NUMBER}{_NAME}\s*(?:=+|is|equals?)\s*(?:1|one)\s+unit{_END}",
)
"""Such as ``1 unit = 1000 mm``, which is how large a unit of the coordinates is."""
_STATEMENTS = (
    rf"{_BEFORE}units?(?:\s+of\s+(?:length|measure(?:ment)?|(?:the\s+)?coordinates))?"
    rf"(?:[\s:=>-]|\b(?:is|are|in)\b)*[(\[]?(?<![^\W\d_]){_NAME}{_END}",
    rf"{_BEFORE}(?P<noun>coordinates?|coords?|xyz|vertices|vertex|points?|nodes?|positions?"
    rf"|dimensions?|lengths?|all|everything)\s*"
    rf"(?:(?:(?:is|are|all|given|measured|expressed|stored|specified)\s+)*in\s+|[(\[]\s*){_NAME}"
    rf"{_END}",
)
"""Such as ``units: mm``, ``coordinates are in m`` and ``coordinates [mm]``."""
_PATTERNS = [re.compile(one, re.IGNORECASE) for one in (*_EQUATIONS, *_STATEMENTS)]

_OF_COORDINATES = re.compile(
    r"""the|all|and|of|in|is|are|where|scale|default|length|linear|distance|spatial|cartesian
    |files?|model|mesh|object|scan|surface|cloud|geometry|scene|world|output|export|data|document
    |coordinates?|coords?|coordinate|vertex|vertices|points?|nodes?|positions?|dimensions?|xyz
    |measurement|system|\w+=\S*""",
    re.IGNORECASE | re.VERBOSE,
)
"""Words that may stand before "unit" where that of the coordinates is meant. Any other makes it
something else's: time unit, intensity unit, focal length unit, original unit."""

_MAY_STATE = re.compile(r"unit|\bin\b|[\[(]", re.IGNORECASE)
_LABEL = re.compile(rf"[\s~'\"(\[]*{_NAME}(?:{_END}|\s*[,;])", re.IGNORECASE)
_SURVEY_FOOT = re.compile(
    r"(?:\bus|u\.s\.|survey)\W*(?:survey\W*)?(?:ft|foot|feet)|(?:ft|foot|feet)[\W_]*us",
    re.IGNORECASE,
)


@dataclass(frozen=True, slots=True)
class StatedUnit:
    """What lines of comment say of the unit of the coordinates.

    Attributes
    ----------
    size : Fraction or None
        What one unit of the coordinates is, in mm; None where nothing is said that is understood.
    odd : tuple of str
        Statements that are not understood, or contradict each other, quoted.
    """

    size: Fraction | None
    odd: tuple[str, ...] = ()


def stated_unit(comments: tuple[str, ...]) -> StatedUnit:
    """Find what comments such as ``unit mm``, ``Units: inches``, ``1 unit = 1000 mm`` say.

    Only a statement about the unit of length of the coordinates counts: not one of a time, an
    area or an intensity, nor of what they were converted from.
    """
    found: dict[Fraction, str] = {}
    odd: list[str] = []
    for comment in dict.fromkeys(comments):
        for clause in _clauses(comment) if _MAY_STATE.search(comment) else ():
            size = _size_in(clause)
            if size is not None:
                found.setdefault(size, comment)
            elif _unsettling(clause):
                odd.append(_told(comment))
    if len(found) > 1:
        return StatedUnit(None, tuple(_told(comment) for comment in found.values()))
    return StatedUnit(next(iter(found), None), tuple(dict.fromkeys(odd)))


def unit_in(comments: tuple[str, ...]) -> str | None:
    """Give the name of the unit that comments state, where it has one."""
    size = stated_unit(comments).size
    name = None if size is None else name_of(size)
    return name if name in SIZES else None


def unit_named(label: str) -> str | None:
    """Find the unit a label such as ``mm``, ``m (as in file)`` or ``US survey foot`` means."""
    if _SURVEY_FOOT.search(label):
        return "us-ft"
    found = _LABEL.match(label)
    return _unit_of(found) if found else None


def _unit_of(found: re.Match[str]) -> str:
    [name] = (unit for unit in _NAMES if found.group(unit.replace("-", "_")))
    return name


def _clauses(comment: str) -> list[str]:
    """Split a comment into statements, its own sign and quotes left out."""
    text = re.sub(r"^\W*(?:comment|obj_info|solid)\b", "", comment.strip(), flags=re.IGNORECASE)
    text = re.sub(r"[\"'{}#%*]|//+", " ", text).replace("_", " ")
    text = re.sub(r"\bx\W+y\W+(?:and\W+)?z\b", "xyz", text, flags=re.IGNORECASE)
    text = re.sub(r"\b(length|file|model)units?\b", r"\1 unit", text, flags=re.IGNORECASE)
    return [part.strip() for part in re.split(r"[;|]|,\s|\.\s|\s[-–—]\s", text) if part.strip()]


def _size_in(clause: str) -> Fraction | None:
    for pattern in _PATTERNS:
        found = pattern.match(clause)
        if not found or not _is_of_coordinates(found["before"]):
            continue
        number = _number(found.groupdict().get("number") or "1")
        return None if number is None else number * SIZES[_unit_of(found)]
    return None


def _is_of_coordinates(before: str) -> bool:
    words = before.replace(":", " ").split()
    return all(
        _OF_COORDINATES.fullmatch(word) or re.fullmatch(_NAME, word, re.IGNORECASE)
        for word in words
    )


def _number(text: str) -> Fraction | None:
    """Read a decimal; None where a comma may separate thousands, and for zero."""
    if re.fullmatch(r"\d+,\d{3}", text) or len(text) > 40:
        return None
    mantissa, _, exponent = text.lower().replace(",", ".").partition("e")
    if exponent and abs(int(exponent)) > 12:
        return None
    return Fraction(mantissa.rstrip(".") or "0") * Fraction(10) ** int(exponent or 0) or None


def _unsettling(clause: str) -> bool:
    """Whether a clause seems to state a unit of length, but not in a way that is understood."""
    found = re.search(r"\bunits?\b\W*(.*)$", clause, re.IGNORECASE)
    if not found:
        return False
    named = re.search(rf"(?<![^\W\d_]){_NAME}{_END}", found[1], re.IGNORECASE)
    ours = _is_of_coordinates(clause[: found.start()])
    assigned = re.search(r"units?\s*[:=]\s*\S", clause, re.IGNORECASE)
    return bool(named or not found[1].isascii() or (ours and assigned))


def _told(comment: str) -> str:
    return f"statement of a unit that is not understood: {quoted(comment.strip())}"
