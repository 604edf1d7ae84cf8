"""Read .ply: text and both binary orders, any properties, in the file's own precision.

Ours, for VTK's reader rounds to float32 and takes damage for an empty mesh, and others believe what
a header declares, merge nodes or lose the unit. Nothing but NumPy is behind it.
"""

import re
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.io.polygons import Polygons, from_rows
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.text import decode, table
from surfcmp_core.names import quoted

_TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
    "float": "f4", "double": "f8", "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2",
    "int32": "i4", "uint32": "u4", "float32": "f4", "float64": "f8", "int64": "i8", "uint64": "u8",
}  # fmt: skip
_LENGTHS = ("i1", "u1", "i2", "u2", "i4", "u4")
_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}


@dataclass(frozen=True, slots=True)
class _Property:
    name: str
    type: str
    length: str | None
    """Type of the number before a list; None for a scalar."""


@dataclass(frozen=True, slots=True)
class _Element:
    name: str
    count: int
    properties: list[_Property] = field(default_factory=list)

    def wanted(self) -> list[int]:
        """Find what we are after: x, y, z of a vertex, the corners of a face."""
        names = [one.name for one in self.properties]
        if self.name == "vertex":
            if not {"x", "y", "z"} <= set(names):
                raise InputError("its vertices have no x, y, z")
            return [names.index(axis) for axis in "xyz"]
        if self.name == "face":
            for i, one in enumerate(self.properties):
                if one.name in ("vertex_indices", "vertex_index") and one.length:
                    return [i]
            if self.count:
                raise InputError("its faces have no list vertex_indices")
        return []


def read_ply(data: bytes) -> Raw:
    """Nodes of the vertex element and polygons of the face element."""
    if not data.startswith(b"ply"):
        raise InputError("it does not begin with 'ply'")
    end = re.search(rb"[\r\n][ \t]*end_header[ \t]*(\r\n|\n|\r|\Z)", data)
    if end is None:
        raise InputError("its header has no end")
    order, elements, comments = _header(decode(data[: end.start()]))
    if order:
        points, polygons = _read_binary(data, end.end(), elements, order)
    else:
        points, polygons = _read_text(data[end.end() :], elements)
    return Raw(points, polygons, comments)


def _header(text: str) -> tuple[str, list[_Element], tuple[str, ...]]:
    order, elements, comments = None, [], []
    for line in text.split("\n")[1:]:
        match line.split():
            case ["format", name, *_] if name in _ORDERS:
                order = _ORDERS[name]
            case ["comment" | "obj_info", *_]:
                comments.append(line)
            case ["element", name, count] if count.isdecimal() and len(count) < 19:
                elements.append(_Element(name, int(count)))
            case ["property", "list", length, kind, name] if elements:
                if kind not in _TYPES or _TYPES.get(length) not in _LENGTHS:
                    raise InputError(f"unknown type in its header: {quoted(line)}")
                elements[-1].properties.append(_Property(name, _TYPES[kind], _TYPES[length]))
            case ["property", kind, name] if elements and kind in _TYPES:
                elements[-1].properties.append(_Property(name, _TYPES[kind], None))
            case []:
                pass
            case _:
                raise InputError(f"not understood in its header: {quoted(line)}")
    names = [element.name for element in elements]
    if order is None:
        raise InputError("its header names no format")
    if names.count("vertex") != 1 or names.count("face") > 1:
        raise InputError("its header must name vertices once, and faces at most once")
    if "tristrips" in names:
        raise InputError("its triangles are strips, which are not read")
    return order, elements, tuple(comments)


def _read_text(data: bytes, elements: list[_Element]) -> tuple[NDArray[np.float64], Polygons]:
    rows = [row for row in decode(data).split("\n") if row and not row.isspace()]
    points, polygons, at = np.empty((0, 3)), [], 0
    for element in elements:
        block = rows[at : at + element.count]
        at += element.count
        if len(block) < element.count:
            raise InputError(f"{element.count} of {element.name} declared, {len(block)} found")
        wanted = element.wanted()
        before = element.properties[: max(wanted, default=0)]
        if any(one.length for one in before):
            block = [_with_lists_shortened(row, before) for row in block]
        if element.name == "vertex":
            points = table(block, wanted, np.float64)
        elif wanted:
            polygons = from_rows(block, skip=wanted[0])
    if at < len(rows):
        raise InputError(f"its header declares {at} lines of data, {len(rows)} found")
    return points, polygons


def _with_lists_shortened(row: str, properties: list[_Property]) -> str:
    """Put one word in the place of each list, so that every property has its column."""
    words, at, columns = row.split(), 0, []
    for one in properties:
        columns.append(words[at])
        at += 1 + (int(words[at]) if one.length else 0)
    return " ".join(columns + words[at:])


def _read_binary(
    data: bytes, at: int, elements: list[_Element], order: str
) -> tuple[NDArray[np.float64], Polygons]:
    points, polygons = np.empty((0, 3)), []
    for element in elements:
        if not element.count or not element.properties:
            continue
        wanted = element.wanted()
        groups, at = _records(data, at, element, order)
        if element.name == "vertex":
            points = np.empty((element.count, 3))
            for rows, records in groups:
                for axis, i in enumerate(wanted):
                    points[rows, axis] = records[f"{i}"]
        elif wanted:
            polygons = [_corners(records, f"{wanted[0]}") for _, records in groups]
    if data[at:].strip(b"\0\r\n "):
        raise InputError(f"{len(data) - at} bytes found after all that its header declares")
    return points, polygons


def _corners(records: NDArray[np.void], name: str) -> NDArray[np.integer]:
    """Copy the lists of some records, in whole numbers that hold them, as narrow as kernels use."""
    assert records.dtype.fields is not None
    kind, offset, *_ = records.dtype.fields[name]
    if not kind.itemsize:
        return np.empty((len(records), 0), np.int32)
    whole = np.dtype(
        {
            "names": ["list"],
            "formats": [f"V{kind.itemsize}"],
            "offsets": [offset],
            "itemsize": records.dtype.itemsize,
        }
    )
    # as one lump each: six times as quick as number by number
    lumps = np.ascontiguousarray(records.view(whole)["list"])
    number = kind.base.newbyteorder("=")
    corners = lumps.view(kind.base).reshape(len(records), -1)
    fits = number.kind in "iu" and np.iinfo(number).max <= np.iinfo(np.int32).max
    return corners.astype(np.int32 if fits else np.int64, copy=False)


_Rows = slice | NDArray[np.int64]


def _records(
    data: bytes, at: int, element: _Element, order: str
) -> tuple[list[tuple[_Rows, NDArray[np.void]]], int]:
    """Group an element's records by the lengths of their lists; also where they end."""
    smallest = sum(np.dtype(one.length or one.type).itemsize for one in element.properties)
    if element.count * smallest > len(data) - at:
        raise InputError(
            f"{element.count} of {element.name} declared, more than the file has room for"
        )
    lengths, _ = _lengths(data, at, element, order)
    dtype = _dtype(element, order, lengths)
    end = at + element.count * dtype.itemsize
    if end <= len(data):
        records = np.frombuffer(data, dtype, element.count, at)
        if all((records[name] == n).all() for name, n in lengths.items()):
            return [(slice(None), records)], end

    names, found, starts, at = _walk(data, at, element, order)
    kinds, kind_of = np.unique(found, axis=0, return_inverse=True)
    groups: list[tuple[_Rows, NDArray[np.void]]] = []
    for k, kind in enumerate(kinds.tolist()):
        rows = np.flatnonzero(kind_of.reshape(-1) == k)
        dtype = _dtype(element, order, dict(zip(names, kind, strict=True)))
        # one record at each byte, of which those that begin there are taken
        anywhere = np.ndarray(len(data) - dtype.itemsize + 1, dtype, data, strides=(1,))
        groups.append((rows, anywhere[starts[rows]]))
    return groups, at


def _walk(
    data: bytes, at: int, element: _Element, order: str
) -> tuple[list[str], NDArray[np.int64], NDArray[np.int64], int]:
    """Names and (n, lists) lengths of the lists in n records, where each starts, and the end."""
    names = list(_lengths(data, at, element, order)[0])
    steps, ahead = [], 0  # for each list: bytes ahead of it, of its length, of one entry
    for one in element.properties:
        if one.length:
            steps.append((ahead, int(one.length[1]), one.length[0] == "i", int(one.type[1])))
            ahead = 0
        else:
            ahead += int(one.type[1])
    endian: Literal["little", "big"] = "little" if order == "<" else "big"
    starts, found = [], []
    for _ in range(element.count):
        starts.append(at)
        for skipped, size, signed, width in steps:
            at += skipped
            if size == 1 and not signed and at < len(data):  # as in nearly all files
                n = data[at]
            else:
                n = int.from_bytes(data[at : at + size], endian, signed=signed)
            found.append(n)
            at += size + n * width
            if n < 0:
                at = len(data) + 1
        at += ahead
        if at > len(data):
            raise InputError(f"its {element.name} element reaches beyond the end of the file")
    lengths = np.array(found, np.int64).reshape(element.count, len(steps))
    return names, lengths, np.array(starts, np.int64), at


def _lengths(data: bytes, at: int, element: _Element, order: str) -> tuple[dict[str, int], int]:
    """Lengths of the lists in the record at `at`, and where it ends."""
    lengths = {}
    for i, one in enumerate(element.properties):
        n = 1
        if one.length:
            size = int(one.length[1])
            n = int.from_bytes(
                data[at : at + size],
                "little" if order == "<" else "big",
                signed=one.length[0] == "i",
            )
            lengths[f"{i} length"] = n
            at += size
        at += n * int(one.type[1])
        if n < 0 or at > len(data):
            raise InputError(f"its {element.name} element reaches beyond the end of the file")
    return lengths, at


def _dtype(element: _Element, order: str, lengths: dict[str, int]) -> np.dtype[np.void]:
    fields: list[tuple[str, str] | tuple[str, str, tuple[int]]] = []
    for i, one in enumerate(element.properties):
        if one.length is None:
            fields.append((f"{i}", order + one.type))
        else:
            length = f"{i} length"
            fields += [(length, order + one.length), (f"{i}", order + one.type, (lengths[length],))]
    return np.dtype(fields)
