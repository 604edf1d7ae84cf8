"""Read .las and .laz, by laspy: points that are not withheld nor noise, and their unit."""

import logging
from io import BytesIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.reference_system import LengthUnits, units_of_keys, units_of_wkt
from surfcmp_core.io.unpacked import check_unpacked

_CHUNK_BYTES = 1 << 26
_DOUBLES, _WKT = 34736, 2112
"""Records: of the GeoTIFF keys that are no whole numbers, and of WKT."""
_LOW_NOISE, _HIGH_NOISE = 7, 18
"""Classes; the second is reserved in the point formats below 6."""
_EXTENDED = 6
_RECORDS = 1000
"""Records behind the points that are looked at."""


def read_las(data: bytes) -> Raw:
    """Points of a survey, with the linear unit of its reference system.

    Those withheld and those classified as noise are counted and left out, as the format asks for.
    """
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
            check_unpacked(header.point_count * size, room)
            _check_compressed(data, start, header)
        elif header.point_count * size > room:
            raise InputError(f"{header.point_count} points declared, room for {room // size}")
        chunks = reader.chunk_iterator(max(1, _CHUNK_BYTES // size))
        parts, found, dropped = [np.empty((0, 3))], 0, {"withheld": 0, "noise": 0}
        for part in chunks:
            points = np.stack((part.x, part.y, part.z), axis=1)
            withheld = np.asarray(part.withheld, np.bool_)
            noise = ~withheld & _noise(part, header)
            found += len(points)
            dropped["withheld"] += int(withheld.sum())
            dropped["noise"] += int(noise.sum())
            out = withheld | noise
            parts.append(points[~out] if out.any() else points)
    if found != header.point_count:
        raise InputError(f"{header.point_count} points declared, {found} found")
    units = _units(data, header)
    left_out = sum(dropped.values())
    if left_out == found and found:
        raise InputError(f"all of its {found} points are withheld or noise")
    return Raw(
        np.concatenate(parts),
        unit=units.horizontal,
        georeferenced=units.horizontal is not None,
        refused=units.refused,
        dropped={reason: count for reason, count in dropped.items() if count},
        changed=dict.fromkeys(units.odd, 1),
    )


def _noise(part: Any, header: Any) -> NDArray[np.bool_]:
    classes = np.asarray(part.classification)
    high = header.point_format.id >= _EXTENDED
    return np.isin(classes, [_LOW_NOISE, _HIGH_NOISE] if high else [_LOW_NOISE])


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


def _units(data: bytes, header: Any) -> LengthUnits:
    """Read the units of the reference system; where two are there, the header says which holds."""
    keys: dict[int, int] = {}
    doubles: dict[int, float] = {}
    numbers = [one for found in header.vlrs.get("GeoDoubleParamsVlr") for one in found.doubles]
    for directory in header.vlrs.get("GeoKeyDirectoryVlr"):
        for key in directory.geo_keys:
            if key.tiff_tag_location == 0:
                keys[key.id] = key.value_offset
            elif key.tiff_tag_location == _DOUBLES and key.value_offset < len(numbers):
                doubles[key.id] = numbers[key.value_offset].value
    wkt = [str(one.string) for one in header.vlrs.get("WktCoordinateSystemVlr")]
    wkt += _extended_wkt(data)
    text = next((one for one in wkt if one.strip("\0 \r\n\t")), "")
    if text and (header.global_encoding.wkt or not keys):
        return units_of_wkt(text)
    return units_of_keys(keys, doubles)


def _extended_wkt(data: bytes) -> list[str]:
    """WKT of the records behind the points, which version 1.4 allows for."""
    if data[25] < 4 or len(data) < 247:
        return []
    at = int.from_bytes(data[235:243], "little")
    found = []
    for _ in range(min(int.from_bytes(data[243:247], "little"), _RECORDS)):
        head = data[at : at + 60]
        if len(head) < 60:
            break
        length = int.from_bytes(head[20:28], "little")
        if head[2:17] == b"LASF_Projection" and int.from_bytes(head[18:20], "little") == _WKT:
            found.append(data[at + 60 : at + 60 + length].decode("utf-8", "replace"))
        at += 60 + length
    return found
