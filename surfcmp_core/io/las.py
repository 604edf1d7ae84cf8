"""Read .las and .laz, by laspy."""

import logging
import re
from io import BytesIO
from typing import Any

import numpy as np

from surfcmp_core.errors import InputError
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.units import unit_named

_CHUNK_BYTES = 1 << 26
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
    # one thread: the many-threaded decompressor allocates whatever a damaged file asks for
    single = laspy.LazBackend.Lazrs
    with laspy.open(BytesIO(data), read_evlrs=False, laz_backend=single) as reader:
        header = reader.header
        size, room = header.point_format.size, len(data) - start
        if header.are_points_compressed:
            _check_compressed(data, start, header)
        elif header.point_count * size > room:
            raise InputError(f"{header.point_count} points declared, room for {room // size}")
        chunks = reader.chunk_iterator(max(1, _CHUNK_BYTES // size))
        parts = [np.stack((part.x, part.y, part.z), axis=1) for part in chunks]
    points = np.concatenate([np.empty((0, 3)), *parts])
    if len(points) != header.point_count:
        raise InputError(f"{header.point_count} points declared, {len(points)} found")
    return Raw(points, unit=_unit(header.vlrs))


def _check_compressed(data: bytes, start: int, header: Any) -> None:
    """Refuse what the decompressor, which is not Python's, would abort the process for."""
    [record] = header.vlrs.get("LasZipVlr") or [None]
    if record is None or record.record_data[32:34] in (b"", b"\0\0"):  # its number of items
        raise InputError("it does not say how its points are compressed")
    table = int.from_bytes(data[start : start + 8], "little", signed=True)
    if not start <= table <= len(data) - 8:
        raise InputError("its compressed points are cut off")
    if int.from_bytes(data[table + 4 : table + 8], "little") * header.point_format.size > len(data):
        raise InputError("it declares more compressed chunks than it has room for")


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
