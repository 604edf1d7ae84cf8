"""Read .off, with normals, colours or texture coordinates, which are ignored.

Ours, for a library believes what a header declares and merges or reorders nodes; no line of it may.
"""

import re

import numpy as np

from surfcmp_core.errors import InputError
from surfcmp_core.io.polygons import from_rows
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.text import decode, table
from surfcmp_core.names import quoted

_HEAD = re.compile(r"\s*((?:ST|st|C|c|N|n|4)*)(?:OFF|off)(?![A-Za-z])[ \t]*")
_DIMENSIONS = re.compile("4|n")
"""Marks of nodes of four coordinates and of any number of them (``nOFF``; ``NOFF`` has normals)."""


def read_off(data: bytes) -> Raw:
    """Nodes and polygons of a text .off file."""
    if re.match(rb"\S*OFF[ \t]+BINARY\b", data):
        raise InputError("it is a binary .off ('OFF BINARY'), which is not read")
    text = decode(data)
    comments = tuple(re.findall("#.*", text))
    if comments:
        text = re.sub("#.*", "", text)
    head = _HEAD.match(text)
    if not head:
        raise InputError("it does not begin with 'OFF'")
    if _DIMENSIONS.search(head[1]):
        raise InputError(
            f"it begins with {quoted(head[0].strip())}, not 'OFF': its nodes are not x, y, z"
        )
    rows = [row for row in text[head.end() :].split("\n") if row and not row.isspace()]
    counts = rows[0].split() if rows else []
    if not 2 <= len(counts) <= 3 or not all(one.isdecimal() and len(one) < 19 for one in counts):
        raise InputError(f"its counts are unreadable: {quoted(rows[0] if rows else '')}")
    nodes, faces = int(counts[0]), int(counts[1])
    if nodes + faces != len(rows) - 1:
        raise InputError(f"{nodes} nodes and {faces} faces declared, {len(rows) - 1} lines found")
    points = table(rows[1 : 1 + nodes], range(3), np.float64)
    return Raw(points, from_rows(rows[1 + nodes : 1 + nodes + faces]), comments)
