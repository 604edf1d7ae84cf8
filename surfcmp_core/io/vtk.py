"""Read legacy .vtk files, text and binary, versions 1 to 5.1: PolyData and unstructured grids."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.io.polygons import Polygons, from_ranges, from_strips, ranges_in_stream
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.text import decode
from surfcmp_core.names import quoted

_TYPES = {
    "char": "i1", "unsigned_char": "u1", "short": "i2", "unsigned_short": "u2", "int": "i4",
    "unsigned_int": "u4", "long": "i8", "unsigned_long": "u8", "float": "f4", "double": "f8",
    "signed_char": "i1", "vtktypeint8": "i1", "vtktypeuint8": "u1", "vtktypeint16": "i2",
    "vtktypeuint16": "u2", "vtktypeint32": "i4", "vtktypeuint32": "u4", "vtktypeint64": "i8",
    "vtktypeuint64": "u8", "long_long": "i8", "unsigned_long_long": "u8",
    "vtkidtype": "i4",  # whatever its size in memory
}  # fmt: skip
_STRINGS = ("string", "utf8_string", "unicode_string")
_POINT_CELLS, _STRIP, _PIXEL = (1, 2, 3, 4), 6, 8
_POLYGONS = (5, 7, 9)  # triangle, polygon, quadrilateral


def read_vtk(data: bytes) -> Raw:
    """Nodes, polygons and strips; lines, single points and all data on them are ignored."""
    head = decode(data[:1024]).split("\n")
    if not head[0].startswith("# vtk DataFile Version") or len(head) < 4:
        raise InputError("it does not begin with a legacy VTK header")
    encoding = head[2].strip().upper()
    if encoding not in ("ASCII", "BINARY"):
        raise InputError(f"its encoding is unknown: {quoted(head[2])}")
    file = _Cursor(data, encoding == "BINARY", with_offsets=head[0].split()[-1] >= "5")
    points = np.empty((0, 3))
    polygons: Polygons = []
    cells, types = None, np.empty(0, np.int64)
    while (words := file.line()) and words[0].upper() not in ("POINT_DATA", "CELL_DATA"):
        match [words[0].upper(), *words[1:]]:
            case ["DATASET", kind]:
                if kind.upper() not in ("POLYDATA", "UNSTRUCTURED_GRID"):
                    raise InputError(f"it holds {quoted(kind)}, not a surface")
            case ["POINTS", count, kind]:
                points = file.numbers(3 * _count(count), kind).astype(np.float64).reshape(-1, 3)
            case ["VERTICES" | "LINES", count, size]:
                file.ranges(count, size)
            case ["POLYGONS", count, size]:
                polygons += from_ranges(*file.ranges(count, size))
            case ["TRIANGLE_STRIPS", count, size]:
                polygons += from_strips(from_ranges(*file.ranges(count, size)))
            case ["CELLS", count, size]:
                cells = file.ranges(count, size)
            case ["CELL_TYPES", count]:
                types = file.numbers(_count(count), "int").astype(np.int64)
            case ["FIELD", _, count]:
                file.skip_arrays(_count(count))
            case _:
                raise InputError(f"not understood: {quoted(' '.join(words))}")
    changed: dict[str, int] = {}
    if cells:
        corners, starts, ends = cells
        if len(types) != len(starts):
            raise InputError(f"{len(starts)} cells but {len(types)} cell types")
        for kind in np.unique(types).tolist():
            chosen = types == kind
            found = from_ranges(corners, starts[chosen], ends[chosen])
            if kind in _POLYGONS:
                polygons += found
            elif kind == _STRIP:
                polygons += from_strips(found)
            elif kind == _PIXEL:
                polygons += [group[:, (0, 1, 3, 2)] for group in found]
            elif kind not in _POINT_CELLS:
                changed["cells that are not flat polygons"] = changed.get(
                    "cells that are not flat polygons", 0
                ) + int(chosen.sum())
    return Raw(points, polygons, (head[1],), changed=changed)


def _count(word: str) -> int:
    if not word.isdecimal() or len(word) > 15:
        raise InputError(f"not a count: {quoted(word)}")
    return int(word)


class _Cursor:
    """Walks through the lines and the numbers of the file."""

    def __init__(self, data: bytes, binary: bool, with_offsets: bool) -> None:
        self.data = data
        self.binary = binary
        self.with_offsets = with_offsets
        self.at = 0
        for _ in range(3):
            self.raw_line()

    def raw_line(self) -> list[str]:
        end = self.data.find(b"\n", self.at)
        end = len(self.data) if end < 0 else end
        words = decode(self.data[self.at : min(end, self.at + 1000)]).split()
        self.at = end + 1
        return words

    def line(self) -> list[str]:
        """Words of the next line that has any, metadata skipped; none at the end."""
        while self.at < len(self.data):
            words = self.raw_line()
            if words == ["METADATA"]:
                while self.raw_line():
                    pass
            elif words:
                return words
        return []

    def numbers(self, count: int, type_name: str) -> NDArray[np.generic]:
        kind = np.dtype(_TYPES.get(type_name.lower(), "V")).newbyteorder(">")
        if kind.itemsize == 0:
            raise InputError(f"its type is unknown: {quoted(type_name)}")
        if not self.binary:
            words = self.words(count)
        elif count * kind.itemsize > len(self.data) - self.at:
            raise InputError(f"{count} numbers declared, more than the file has room for")
        else:
            values = np.frombuffer(self.data, kind, count, self.at)
            self.at += values.nbytes
            return values
        if kind.kind == "f":
            return np.fromiter(map(float, words), np.float64, count)
        return np.fromiter(map(int, words), np.int64, count)

    def words(self, count: int) -> list[bytes]:
        if 2 * count > len(self.data) - self.at + 1:
            raise InputError(f"{count} numbers declared, more than the file has room for")
        size = 32 * count + 64  # all at once would copy the rest of the file for each small array
        while True:
            part = self.data[self.at : self.at + size]
            words = part.split(None, count)
            if len(words) > count or self.at + size >= len(self.data):
                break
            size *= 4
        self.at += len(part) - (len(words.pop()) if len(words) > count else 0)
        if len(words) < count:
            raise InputError(f"{count} numbers declared, {len(words)} found")
        return words

    def ranges(
        self, count: str, size: str
    ) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
        """Corners of all polygons, and where each starts and ends among them."""
        if not self.with_offsets:
            stream = self.numbers(_count(size), "int").astype(np.int64)
            return stream, *ranges_in_stream(stream, _count(count))
        arrays = []
        for name, length in (("OFFSETS", count), ("CONNECTIVITY", size)):
            words = self.line()
            if len(words) != 2 or words[0].upper() != name:
                raise InputError(f"{name} expected, not {quoted(' '.join(words))}")
            arrays.append(self.numbers(_count(length), words[1]).astype(np.int64))
        offsets, corners = arrays
        return corners, offsets[:-1], offsets[1:]

    def skip_arrays(self, count: int) -> None:
        """Pass the arrays of a field, of whatever type: nothing in them is looked for."""
        for _ in range(count):
            match self.line():
                case [_, components, tuples, kind]:
                    self.skip(_count(components) * _count(tuples), kind.lower())
                case words:
                    raise InputError(f"not understood: {quoted(' '.join(words))}")

    def skip(self, count: int, kind: str) -> None:
        if kind == "variant" or (kind in _STRINGS and not self.binary):  # one a line, of any words
            self._check_room(count)
            for _ in range(count):
                self.raw_line()
        elif not self.binary:
            self.words(count)
        elif kind in _STRINGS:
            self._check_room(count)
            for _ in range(count):
                self.skip_string()
        elif kind == "bit":
            self.numbers(-(-count // 8), "char")
        else:
            self.numbers(count, kind)

    def skip_string(self) -> None:
        """Pass one string; the first two bits say how many bytes hold its length."""
        size = {3: 1, 2: 2, 1: 4, 0: 8}[self.data[self.at] >> 6]
        length = int.from_bytes(self.data[self.at : self.at + size], "big")
        self.at += size + (length & ((1 << (8 * size - 2)) - 1))
        self._check_room(0)

    def _check_room(self, octets: int) -> None:
        if octets > len(self.data) - self.at + 1:
            raise InputError(f"{octets} values declared, more than the file has room for")
