"""Read .stl, text and binary; it repeats the nodes of every triangle, so equal ones are merged."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.text import decode, table

_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_START = 84


def read_stl(data: bytes) -> Raw:
    """Triangles of all solids on distinct nodes."""
    declared = int.from_bytes(data[_START - 4 : _START], "little")
    if len(data) == _START + declared * _RECORD.itemsize:
        records = np.frombuffer(data, _RECORD, declared, _START)
        return _merged(records["corners"].reshape(-1, 3), decode(data[: _START - 4]))
    if data.lstrip()[:5].lower() == b"solid" and b"\0" not in data:
        return _read_text(decode(data))
    raise InputError(
        f"{declared} triangles declared in its binary header, which take "
        f"{_START + declared * _RECORD.itemsize} bytes; the file has {len(data)}"
    )


def _read_text(text: str) -> Raw:
    rows = [row for row in text.split("\n") if row.lstrip()[:6].lower() == "vertex"]
    facets = sum(row.lstrip()[:5].lower() == "facet" for row in text.split("\n"))
    if len(rows) != 3 * facets:
        raise InputError(f"{facets} facets with {len(rows)} corners, not three each")
    return _merged(table(rows, (1, 2, 3), np.float64), text[: text.find("\n")])


def _merged(corners: NDArray[np.floating], header: str) -> Raw:
    order = np.lexsort(corners.T)
    in_order = corners[order]
    new = np.ones(len(corners), np.bool_)
    new[1:] = (in_order[1:] != in_order[:-1]).any(axis=1)
    node = np.empty(len(corners), np.int64)
    node[order] = np.cumsum(new) - 1
    return Raw(in_order[new].astype(np.float64), [node.reshape(-1, 3)], (header.strip("\0 "),))
