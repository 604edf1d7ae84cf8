"""Read .las and .laz, by laspy."""

import logging
import re
from io import BytesIO
from typing import Any

import numpy as np

from surfcmp_core.errors import InputError
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.units import unit_named

_CHUNK = 1_000_000
_LINEAR_UNITS_KEY = 3076  # GeoTIFF: ProjLinearUnits
_LINEAR_UNITS = {9001: "m", 9002: "ft", 9003: "us-ft"}


def read_las(data: bytes) -> Raw:
    """All points of a survey, with the linear unit of its reference system."""
    import laspy

    logging.getLogger("laspy").addHandler(logging.NullHandler())  # it would print
    if data[:4] != b"LASF" or len(data) < 227:
        raise InputError("it does not begin with a LAS header")
    start, records = (int.from_bytes(data[at : at + 4], "little") for at in (96, 100))
    if start > len(data) or records * 54 > start:
        raise InputError("its header declares more than the file has room for")
    with laspy.open(BytesIO(data), read_evlrs=False) as reader:
        header = reader.header
        # in chunks: no more is allocated than the file yields
        chunks = [np.empty((0, 3))]
        chunks += [np.stack((c.x, c.y, c.z), axis=1) for c in reader.chunk_iterator(_CHUNK)]
    points = np.concatenate(chunks)
    if len(points) != header.point_count:
        raise InputError(f"{header.point_count} points declared, {len(points)} found")
    return Raw(points, unit=_unit(header.vlrs))


def _unit(records: list[Any]) -> str | None:
    """Find the one linear unit that the records name; None where they name two."""
    units = set()
    for record in records:
        for key in getattr(record, "geo_keys", ()):
            if key.id == _LINEAR_UNITS_KEY:
                units.add(_LINEAR_UNITS.get(key.value_offset))
        wkt = getattr(record, "string", "")
        units |= {unit_named(name) for name in re.findall(r'UNIT\["([^"]+)"', str(wkt))}
    units.discard(None)
    return units.pop() if len(units) == 1 else None
