"""Which columns of a table are x, y and z, and in which unit: what its heading says."""

import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass

from surfcmp_core.errors import InputError
from surfcmp_core.io.stated_units import unit_named

_LENGTHS = (
    r"[mckdnuµμ]?m|(?:milli|centi|deci|kilo|micro)?met(?:re|er)s?|microns?|in|inch(?:es)?"
    r"|(?:us)?[\s._-]*(?:survey)?[\s._-]*(?:ft|feet|foot)|(?:ft|feet|foot)[\s._-]*us"
    r"|yd|yards?|miles?"
)
_OTHERS = r"°|deg|degrees?|grad|gon|rad|radians?|px|pixels?|vox|voxels?|count|counts"
_UNIT = rf"(?:in[\s_]+)?(?P<unit>{_LENGTHS}|{_OTHERS})\.?"
_ANGLES = re.compile(r"°|deg|degrees?|grad|gon|rad|radians?", re.IGNORECASE)
_BRACKETED = re.compile(r"(?P<name>.*?)[\s_]*[(\[{<](?P<inside>[^()\[\]{}<>]*)[)\]}>]\W*")
_DATUM = r"(?:\s+(?:[üua]\b|ue\b|über|above|over|[am]?msl|asl|n[nha]).*)?"
"""What a height may be counted from."""
_TRAILED = re.compile(rf"(?P<name>.+?)[\s_,./-]+{_UNIT}{_DATUM}", re.IGNORECASE)
_ALONE = re.compile(rf"[(\[{{<]?\s*{_UNIT}{_DATUM}\s*[)\]}}>]?", re.IGNORECASE)
_NOTHING = re.compile("[-–—/.]?")
_AROUND = " \t\"'"
_LONGEST = 200

_KIND = r"(?:points?|pts?|pos|positions?|coords?|coordinates?|koordinaten?|vert(?:ex|ices)|nodes?)"
_BEFORE = rf"(?:{_KIND}|world|local|location|loc|utm|gk|grid|map|values?|cent(?:er|re))?"
_AFTER = rf"(?:{_KIND}|koord|values?|werte?|ax[ie]s|achse|world|local|location|loc|utm|[01])?"
_SYSTEM = r"(?:utm|gk|grid|map|mga|mgi|osgb|local|lokal|survey|world|etrs89|lv95)?"
_COORDINATE = r"(?:coords?|coordinates?|koordinate|wert)?"
_PLANES: tuple[tuple[str, str], ...] = (
    ("x", "y"),
    (f"{_BEFORE}x{_AFTER}", f"{_BEFORE}y{_AFTER}"),
    (f"(?:{_KIND}|xyz)0", f"(?:{_KIND}|xyz)1"),
    (
        f"{_SYSTEM}(?:eastings?|east|este|est|ost|oost){_COORDINATE}|e",
        f"{_SYSTEM}(?:northings?|north|norte|nord|noord){_COORDINATE}|n",
    ),
    (f"{_SYSTEM}rechts(?:wert)?|rw|r", f"{_SYSTEM}hoch(?:wert)?|hw|h"),
)
"""Names of x and y, without blanks and marks: the first pair that is there counts."""
HEIGHTS: tuple[str, ...] = (
    "z",
    f"{_BEFORE}z{_AFTER}",
    f"(?:{_KIND}|xyz)2",
    (
        r"(?:ortho(?:metric)?|ellips(?:oid(?:al|ic)?)?|utm|grid|map|local|survey|ground|gps|nh?n"
        r"|gel(?:ä|ae)nde)?(?:elevations?|elev|ele|heights?|hgt|ht|altitudes?|alt|h.{0,2}he|hohe"
        r"|cota|quota|hauteur|hoogte|altura|höjd)(?:ellips(?:oidal)?|ortho(?:metric)?|values?|wert"
        r"|(?:ü|ue|a|)nh?n|[am]?msl|asl)?|h|u|up|rl|reducedlevel"
    ),
)
"""Names of z, likewise; ``h.{0,2}he`` is a German height in an encoding nobody tells."""
WEIGHTS: tuple[str, ...] = (r"µ|μ|mu|w|weights?|gewichte?|poids", *HEIGHTS)
"""Names of a weight at x and y, which a table may hold in the place of z."""
_LATITUDE = r"lat(?:itude|itud)?|(?:geogr.*)?breite(?:ngrad)?|φ|phi"
_LONGITUDE = r"lon(?:g|gitude|gitud)?|lng|(?:geogr.*)?l.{1,2}nge(?:ngrad)?|λ|lambda"


@dataclass(frozen=True, slots=True)
class Heading:
    """What the heading of a table says."""

    columns: tuple[int, int, int]
    """Which are x, y and z, counted from 0."""
    unit: str | None
    """Of all three; None where it does not say."""


def heading_of(
    fields: Sequence[str], units: Sequence[str] = (), heights: Sequence[str] = HEIGHTS
) -> Heading | None:
    """Find x, y and z among the names of columns.

    Parameters
    ----------
    fields : sequence of str
        The names, each of which a unit may follow: ``x``, ``X [m]``, ``y_mm``, ``Rechtswert``.
    units : sequence of str
        A second row, with the unit of each column.
    heights : sequence of str
        Patterns of names of z, the best ones first.

    Returns
    -------
    Heading or None
        None where not each of the three is named, and only once.

    Raises
    ------
    InputError
        The units differ, or are none of length; the message goes on where "its header" ends.
    """
    parts = [_parts(field) for field in fields]
    exact = [field.strip(_AROUND).lower() for field in fields]
    names = [name for name, _ in parts]
    plane = _plane(exact, names)
    height = None if plane is None else _height(exact, names, plane, heights)
    if plane is None or height is None:
        if _place(_LATITUDE, names) is not None and _place(_LONGITUDE, names) is not None:
            raise InputError("names latitude and longitude, angles where lengths are needed")
        return None
    columns = (*plane, height)
    below = [_unit_alone(units[c]) if c < len(units) else None for c in columns]
    return Heading(columns, _one_unit([*(parts[c][1] for c in columns), *below]))


def are_units(fields: Sequence[str]) -> bool:
    """Tell a row of units, of which some columns may have none."""
    alone = [_unit_alone(field) for field in fields]
    return None not in alone and any(alone)


def axes_among(fields: Sequence[str]) -> int:
    """Count how many of x, y and z, by these very letters, are among some words."""
    return len({name for name, _ in map(_parts, fields)} & {"x", "y", "z"})


def _parts(field: str) -> tuple[str, str]:
    """Part a name, in lower case without blanks and marks, from the unit that follows it."""
    text = unicodedata.normalize("NFC", field[:_LONGEST]).strip(_AROUND)
    unit = ""
    if (found := _BRACKETED.fullmatch(text)) and not found["inside"].strip().isdigit():
        text, unit = found["name"], _unit_alone(found["inside"]) or ""
    elif found := _TRAILED.fullmatch(text):
        text, unit = found["name"], found["unit"]
    return re.sub(r"[\W_]+", "", text).lower(), unit


def _unit_alone(field: str) -> str | None:
    """Return the unit where a field holds nothing else, "" for a dash or nothing; else None."""
    field = field.strip(_AROUND)
    if found := _ALONE.fullmatch(field):
        return found["unit"]
    return "" if _NOTHING.fullmatch(field) else None


def _place(pattern: str, names: Sequence[str], taken: Sequence[int] = ()) -> int | None:
    """Find the name that a pattern fits; None where there is none, −1 for more than one."""
    found = [i for i, name in enumerate(names) if i not in taken and re.fullmatch(pattern, name)]
    return None if not found else found[0] if len(found) == 1 else -1


def _plane(exact: Sequence[str], names: Sequence[str]) -> tuple[int, int] | None:
    for among, (x, y) in ((exact, _PLANES[0]), *((names, plane) for plane in _PLANES)):
        column, row = _place(x, among), _place(y, among)
        if column is not None and row is not None:
            return None if -1 in (column, row) else (column, row)
    return None


def _height(
    exact: Sequence[str], names: Sequence[str], plane: tuple[int, int], heights: Sequence[str]
) -> int | None:
    for among, z in ((exact, heights[0]), *((names, height) for height in heights)):
        found = _place(z, among, plane)
        if found is not None:
            return None if found == -1 else found
    return None


def _one_unit(stated: Sequence[str | None]) -> str | None:
    """Find the unit on which all agree that state one."""
    units = set()
    for text in filter(None, stated):
        unit = None if _ANGLES.fullmatch(text) else unit_named(text)
        if unit is None:
            raise InputError(f"gives coordinates in {text!r}, which is no length known")
        units.add(unit)
    if len(units) > 1:
        raise InputError(f"gives coordinates in {' and '.join(sorted(units))}")
    return units.pop() if units else None
