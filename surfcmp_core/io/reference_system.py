"""Units of length in a survey's reference system: WKT (1 and 2, OGC's and ESRI's), GeoTIFF keys.

The grammar of WKT is read here: PROJ refuses the incomplete definitions that surveys carry (a
projection without its method, one axis of two), of which the units stand there all the same.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from surfcmp_core.io.stated_units import unit_named
from surfcmp_core.surface.units import SIZES

_NEAR = 2e-7
"""Relative: sizes of units are rounded to seven digits at worst; both feet differ by 2e-6."""

_LONGEST = 100_000
"""Characters of WKT; definitions with all their remarks take a tenth."""
_HORIZONTAL = {"PROJCS", "PROJCRS", "PROJECTEDCRS", "LOCAL_CS", "ENGCRS", "ENGINEERINGCRS"}
_GEOGRAPHIC = {"GEOGCS", "GEOGCRS", "GEOGRAPHICCRS", "GEODCRS", "GEODETICCRS"}
_VERTICAL = {"VERT_CS", "VERTCS", "VERTCRS", "VERTICALCRS"}
_TOKEN = re.compile(r'\s*(?:"((?:[^"]|"")*)"|([A-Za-z_]\w*)|([-+.\d][-+.\deE]*)|([\[(])|([\])])|,)')

_EPSG_UNITS = {9001: "m", 9002: "ft", 9003: "us-ft", 9036: "km", 9096: "yd", 1025: "mm", 1033: "cm"}
_EPSG_HEIGHTS = {5703: "m", 5701: "m", 5773: "m", 3855: "m", 6360: "us-ft", 8228: "ft"}
_METRES = [(25828, 25838), (26901, 26923), (32601, 32660), (32701, 32760)]
"""First and last number of systems (UTM) whose unit is the metre."""
_USER_DEFINED = 32767
_GEOGRAPHIC_MODEL = 2


@dataclass(slots=True)
class LengthUnits:
    """What a reference system says of its units.

    Attributes
    ----------
    horizontal, vertical : str or None
        Of x, y and of z, as keys of `surfcmp_core.surface.units.SIZES`; None where nothing is said.
    angles : bool
        Whether x and y are longitude and latitude.
    odd : list of str
        What is not understood or contradicts itself.
    """

    horizontal: str | None = None
    vertical: str | None = None
    angles: bool = False
    odd: list[str] = field(default_factory=list)

    @property
    def refused(self) -> str:
        """Why x, y and z are not lengths in one unit; empty where nothing says so."""
        if self.angles:
            return "its x and y are longitude and latitude, not lengths"
        if self.horizontal and self.vertical and self.horizontal != self.vertical:
            return f"its heights are in {self.vertical}, but its x and y in {self.horizontal}"
        return ""


@dataclass(slots=True)
class _Node:
    """``KEYWORD["name", number, ELEMENT[...], ...]``."""

    word: str
    values: list[str | float] = field(default_factory=list)
    parts: list["_Node"] = field(default_factory=list)


def units_of_wkt(text: str) -> LengthUnits:
    """Find the units of a reference system in WKT.

    References
    ----------
    OGC 01-009, section 7 (WKT 1); OGC 18-010r11 (WKT 2).
    """
    found = LengthUnits()
    try:
        todo = _parsed(text[: _LONGEST + 1])
    except ValueError:
        found.odd.append("its reference system is not well-formed WKT")
        return found
    while todo:
        element = todo.pop()
        if element.word in {"COMPD_CS", "COMPOUNDCRS", "BOUNDCRS", "SOURCECRS"}:
            todo += [part for part in element.parts if part.word != "TARGETCRS"]
        elif element.word in _GEOGRAPHIC:
            kinds = [str(v).lower() for p in element.parts if p.word == "CS" for v in p.values]
            found.angles |= "cartesian" not in kinds  # earth-centred
            _add_units(element, found)
        elif element.word in _HORIZONTAL | _VERTICAL | {"GEOCCS"}:
            _add_units(element, found)
    return found


def units_of_keys(keys: Mapping[int, int], doubles: Mapping[int, float]) -> LengthUnits:
    """Find the units of a reference system in GeoTIFF keys.

    Parameters
    ----------
    keys : mapping of int to int
        The short values by their keys.
    doubles : mapping of int to float
        The long ones.

    References
    ----------
    OGC 19-008r4, annexes B and C: 1024 GTModelType, 2048 GeodeticCRS, 3072 ProjectedCRS, 3076
    ProjLinearUnits, 3077 ProjLinearUnitSize, 4096 VerticalCRS, 4099 VerticalUnits.
    """
    found = LengthUnits()
    model, projected = keys.get(1024, 0), keys.get(3072, 0)
    found.angles = model == _GEOGRAPHIC_MODEL or (not model and not projected and 2048 in keys)
    if (code := keys.get(3076, 0)) == _USER_DEFINED:
        found.horizontal = _unit_of_size(doubles.get(3077, 0.0))
    else:
        found.horizontal = _EPSG_UNITS.get(code)
        if not code and any(low <= projected <= high for low, high in _METRES):
            found.horizontal = "m"
    if not found.horizontal and (code or projected):
        found.odd.append(
            f"its reference system says unit {code}, which is not known"
            if code
            else f"its reference system, EPSG {projected}, does not say its unit"
        )
    code, system = keys.get(4099, 0), keys.get(4096, 0)
    found.vertical = _EPSG_UNITS.get(code) or (None if code else _EPSG_HEIGHTS.get(system))
    if code and not found.vertical:
        found.odd.append(f"its reference system says unit {code} of heights, which is not known")
    return found


def _add_units(system: _Node, found: LengthUnits) -> None:
    """Take over the units of one system: its own, or each axis's."""
    for part in system.parts:
        axis = part.word == "AXIS"
        up = system.word in _VERTICAL or (
            axis and any(str(value).lower() == "up" for value in part.values)
        )
        for one in part.parts if axis else [part]:
            if one.word not in {"UNIT", "LENGTHUNIT"}:
                continue
            if found.angles and not up and not _is_length(one):
                continue
            name = _unit_of(one)
            which = "vertical" if up else "horizontal"
            before = getattr(found, which)
            if name is None or before not in (None, name):
                found.odd.append(f"unit of its reference system: {_said(one)}")
            else:
                setattr(found, which, name)


def _is_length(unit: _Node) -> bool:
    return unit.word == "LENGTHUNIT" or unit_named(str((unit.values or [""])[0])) is not None


def _unit_of(unit: _Node) -> str | None:
    """Name a unit by its size in metres; None where its name says another."""
    label = next((value for value in unit.values if isinstance(value, str)), "")
    size = next((value for value in unit.values if isinstance(value, float)), None)
    named = unit_named(label.replace("_", " "))
    if size is None:
        return named
    sized = _unit_of_size(size)
    return sized if named in (None, sized) else None


def _unit_of_size(metres: float) -> str | None:
    for name, size in SIZES.items():
        if abs(metres * 1000.0 - float(size)) <= _NEAR * float(size):
            return name
    return None


def _said(unit: _Node) -> str:
    return " ".join(str(value)[:40] for value in unit.values[:2])


def _parsed(text: str) -> list[_Node]:
    """Read WKT; ValueError where it is not well-formed."""
    roots: list[_Node] = []
    open_ones = [_Node("", parts=roots)]
    word, at = "", 0
    text = text.strip("\0 \t\r\n")
    if len(text) > _LONGEST:
        raise ValueError("length")
    while at < len(text):
        token = _TOKEN.match(text, at)
        if token is None or len(open_ones) > 100:
            raise ValueError(text[at : at + 20])
        at = token.end()
        quote, name, number, opening, closing = token.groups()
        if opening:
            element = _Node(word.upper())
            open_ones[-1].parts.append(element)
            open_ones.append(element)
            word = ""
            continue
        if word:  # a keyword without brackets, such as an axis's direction
            open_ones[-1].values.append(word)
            word = ""
        if name:
            word = name
        elif quote is not None:
            open_ones[-1].values.append(quote)
        elif number:
            open_ones[-1].values.append(float(number))
        elif closing:
            if len(open_ones) == 1:
                raise ValueError("brackets")
            open_ones.pop()
    if len(open_ones) > 1:
        raise ValueError("brackets")
    return roots
