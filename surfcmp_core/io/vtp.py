"""Read .vtp, VTK's PolyData in XML: text, base64 and appended arrays, compressed or not.

The arrays are decoded here, for no small library does it safely: vtkio unpacks without a bound and
keeps what it cannot unpack for numbers, meshio knows no PolyData, VTK itself, which the core does
without, answers damage with an empty mesh.
"""

import lzma
import re
import zlib
from base64 import b64decode
from contextlib import suppress
from dataclasses import dataclass
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.io.polygons import Polygons, from_ranges, from_strips
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.text import decode
from surfcmp_core.io.unpacked import check_unpacked
from surfcmp_core.names import quoted

_TYPES = {
    "Int8": "i1", "UInt8": "u1", "Int16": "i2", "UInt16": "u2", "Int32": "i4", "UInt32": "u4",
    "Int64": "i8", "UInt64": "u8", "Float32": "f4", "Float64": "f8", "String": "u1",
}  # fmt: skip
_LONGEST = 300
"""Bytes of a string that are looked at."""
_DICTIONARY = 1 << 27
"""Memory for what LZMA looks back on: more than its highest level asks for."""
_ELEMENTS = 100_000
"""Elements of the XML that are looked at; a piece has some thirty."""
_INFLATE = {
    "vtkZLibDataCompressor": lambda block, size: zlib.decompressobj().decompress(block, size),
    "vtkLZMADataCompressor": lambda block, size: lzma.LZMADecompressor(
        memlimit=_DICTIONARY
    ).decompress(block, size),
}


def read_vtp(data: bytes) -> Raw:
    """Nodes, polygons and strips of all pieces, and what strings say of unit and axes."""
    xml, appended, is_base64 = data, b"", False
    if start := re.search(rb"<AppendedData([^<>]*)>\s*_", data):
        xml = data[: start.start()] + b"</VTKFile>"
        is_base64 = b"base64" in start[1]
        appended = data[start.end() :]
    if xml.count(b"<") > 2 * _ELEMENTS:
        raise InputError(f"its XML has more than {_ELEMENTS} elements")
    try:
        root = ElementTree.fromstring(xml, ElementTree.XMLParser(target=_Tree()))
    except ElementTree.ParseError as error:
        raise InputError(f"its XML is damaged: {error}") from None
    if root.tag != "VTKFile" or root.get("type") != "PolyData":
        raise InputError(f"it holds {quoted(root.get('type', root.tag))}, not PolyData")
    compressor = root.get("compressor")
    if compressor and compressor not in _INFLATE:
        raise InputError(f"it is compressed by {quoted(compressor)}, which is not read")
    order = ">" if root.get("byte_order") == "BigEndian" else "<"
    length = np.dtype(order + _TYPES[root.get("header_type", "UInt32")])
    arrays = _Arrays(memoryview(appended), is_base64, order, length, compressor, len(data))

    points = [np.empty((0, 3))]
    before = 0
    polygons: Polygons = []
    for piece in root.iter("Piece"):
        found = piece.find("Points/DataArray")
        if found is None:
            continue
        before += len(points[-1])
        points.append(arrays.read(found).astype(np.float64).reshape(-1, 3))
        declared = piece.get("NumberOfPoints")
        if declared != f"{len(points[-1])}":
            raise InputError(f"{declared} points declared, {len(points[-1])} found")
        polygons += [group + before for group in _polygons(piece, "Polys", arrays)]
        strips = from_strips(_polygons(piece, "Strips", arrays))
        polygons += [group + before for group in strips]
    return Raw(np.concatenate(points), polygons, tuple(_statements(root, arrays)))


def _statements(root: ElementTree.Element, arrays: "_Arrays") -> list[str]:
    """Read the strings of the file, such as SPACE with the value LPS, as comments would say them.

    3D Slicer states the axes so (vtkMRMLModelStorageNode).
    """
    found = []
    for element in root.iterfind(".//FieldData/Array[@type='String']"):
        with suppress(Exception):  # of whatever kind: nodes and polygons do not need it
            octets = arrays.read(element).astype(np.uint8).tobytes()
            found.append(f"{element.get('Name')}={decode(octets[:_LONGEST].rstrip(bytes(1)))}")
    return found


def _polygons(piece: ElementTree.Element, kind: str, arrays: "_Arrays") -> Polygons:
    corners = piece.find(f"{kind}/DataArray[@Name='connectivity']")
    offsets = piece.find(f"{kind}/DataArray[@Name='offsets']")
    if corners is None or offsets is None:
        return []
    ends = arrays.read(offsets).astype(np.int64)
    if piece.get(f"NumberOf{kind}", f"{len(ends)}") != f"{len(ends)}":
        raise InputError(f"{piece.get(f'NumberOf{kind}')} {kind} declared, {len(ends)} found")
    return from_ranges(arrays.read(corners).astype(np.int64), np.r_[0, ends][:-1], ends)


class _Tree(ElementTree.TreeBuilder):
    """Builds the tree of a document without entities, which might be endless."""

    def doctype(self, _name: str, _public: str | None, _system: str | None) -> None:
        """Refuse it before its entities are read, in whatever encoding."""
        raise InputError("it declares a document type, which is not read")


@dataclass(slots=True)
class _Arrays:
    """Decodes the numbers of DataArray elements."""

    appended: memoryview
    is_base64: bool
    """Whether the appended data are."""
    order: str
    length: np.dtype[np.integer]
    """Type of the byte counts ahead of each array."""
    compressor: str | None
    size: int
    """Octets of the file."""
    unpacked: int = 0
    """Octets of all arrays so far."""

    def read(self, element: ElementTree.Element) -> NDArray[np.generic]:
        kind = np.dtype(self.order + _TYPES[element.get("type", "")])
        match element.get("format", "ascii"):
            case "ascii":
                words = (element.text or "").split()
                if kind.kind == "f":
                    return np.fromiter(map(float, words), np.float64, len(words))
                return np.fromiter(map(int, words), np.int64, len(words))
            case "binary":
                text = "".join((element.text or "").split()).encode()
                octets = self._unpack(memoryview(text), True)
            case _:
                at = int(element.get("offset", ""))
                if not 0 <= at <= len(self.appended):
                    raise InputError(f"an array is said to stand at {at}, beyond the file's end")
                octets = self._unpack(self.appended[at:], self.is_base64)
        return np.frombuffer(octets, kind)

    def _count(self, octets: int) -> None:
        """Refuse arrays that are larger together than the file, or than what it may pack."""
        self.unpacked += octets
        if self.compressor:
            check_unpacked(self.unpacked, self.size)
        elif self.unpacked > self.size:
            raise InputError("its arrays overlap: they are larger together than the file")

    def _unpack(self, blob: memoryview, is_base64: bool) -> bytes:
        """Octets of one array out of the blob that begins with its byte counts."""

        def take(at: int, size: int) -> tuple[bytes, int]:
            """`size` octets that were encoded from `at` on, and where the encoding ends."""
            end = at + (-(-size // 3) * 4 if is_base64 else size)
            if end > len(blob):
                raise InputError("an array reaches beyond the file's end")
            return (b64decode(blob[at:end])[:size] if is_base64 else bytes(blob[at:end])), end

        wide = self.length.itemsize
        head, after = take(0, wide)
        first = int(np.frombuffer(head, self.length)[0])
        if self.compressor is None:
            padded = b"=" in bytes(blob[:after])  # else count and data are encoded as one
            as_one = is_base64 and not padded
            octets = take(0, wide + first)[0][wide:] if as_one else take(after, first)[0]
            self._count(first)
            return octets
        if first == 0:
            return b""
        head, at = take(0, (3 + first) * wide)
        _, whole, last, *packed = np.frombuffer(head, self.length).tolist()
        self._count(whole * (first - 1) + (last or whole))
        blocks, _ = take(at, sum(packed))
        parts, at = [], 0
        for i, size in enumerate(packed):
            full = last if last and i == len(packed) - 1 else whole
            parts.append(_INFLATE[self.compressor](blocks[at : at + size], full))
            if len(parts[-1]) != full:
                raise InputError("a compressed array is damaged")
            at += size
        return b"".join(parts)
