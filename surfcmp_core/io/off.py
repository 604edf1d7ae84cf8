"""Read .off, with normals, colours or texture coordinates, which are ignored."""

import re

import numpy as np

from surfcmp_core.errors import InputError
from surfcmp_core.io.polygons import from_rows
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.text import decode, quoted, table


def read_off(data: bytes) -> Raw:
    """Nodes and polygons of a text .off file."""
    text = decode(data)
    comments = tuple(re.findall("#.*", text))
    if comments:
        text = re.sub("#.*", "", text)
    head = re.match(r"\s*(?:ST)?C?N?OFF\b[ \t]*", text)
    if not head:
        raise InputError("it does not begin with 'OFF'")
    rows = [row for row in text[head.end() :].split("\n") if row and not row.isspace()]
    counts = rows[0].split() if rows else []
    if not 2 <= len(counts) <= 3 or not all(one.isdecimal() and len(one) < 19 for one in counts):
        raise InputError(f"its counts are unreadable: {quoted(rows[0] if rows else '')}")
    nodes, faces = int(counts[0]), int(counts[1])
    if nodes + faces != len(rows) - 1:
        raise InputError(f"{nodes} nodes and {faces} faces declared, {len(rows) - 1} lines found")
    points = table(rows[1 : 1 + nodes], range(3), np.float64)
    return Raw(points, from_rows(rows[1 + nodes : 1 + nodes + faces]), comments)
