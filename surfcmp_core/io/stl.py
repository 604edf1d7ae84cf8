"""Read .stl, text and binary; it repeats the nodes of every triangle, so equal ones are merged.

Ours, for a library merges what is merely near, takes the word of a damaged header, and tells
neither the unit nor what it left out.
"""

import re

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.text import decode, table

_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_START = 84
_PADDING = b"\0\r\n\t "


def read_stl(data: bytes) -> Raw:
    """Triangles of all solids on distinct nodes."""
    declared = int.from_bytes(data[_START - 4 : _START], "little")
    end = _START + declared * _RECORD.itemsize
    if end <= len(data) and not data[end:].strip(_PADDING):
        records = np.frombuffer(data, _RECORD, declared, _START)
        return _merged(records["corners"].reshape(-1, 3), decode(data[: _START - 4]))
    # many a binary header begins with "solid" too, but the next line of a text is a facet
    start = decode(data[:4096]).lstrip()
    if re.match(r"solid\b[^\n]*(\n\s*(facet|endsolid)\b|\Z)", start, re.IGNORECASE):
        return _read_text(decode(data.rstrip(b"\0")))
    but = "no facet follows its first line; read as binary, " if start[:5] == "solid" else ""
    raise InputError(
        f"{but}{declared} triangles declared in its binary header, which take {end} bytes; "
        f"the file has {len(data)}"
    )


def _read_text(text: str) -> Raw:
    lines = text.split("\n")
    rows = [row for row in lines if row.lstrip()[:6].lower() == "vertex"]
    facets = sum(row.lstrip()[:5].lower() == "facet" for row in lines)
    if len(rows) != 3 * facets:
        raise InputError(f"{facets} facets with {len(rows)} corners, not three each")
    return _merged(table(rows, (1, 2, 3), np.float64), lines[0])


def _merged(corners: NDArray[np.floating], header: str) -> Raw:
    order = np.lexsort(corners.T)
    in_order = corners[order]
    new = np.ones(len(corners), np.bool_)
    new[1:] = (in_order[1:] != in_order[:-1]).any(axis=1)
    node = np.empty(len(corners), np.int64)
    node[order] = np.cumsum(new) - 1
    return Raw(in_order[new].astype(np.float64), [node.reshape(-1, 3)], (header.strip("\0 "),))
