"""Polygons of any size, as files hold them, and the triangles made of them."""

from collections import defaultdict
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.io.text import quoted, table

Polygons = list[NDArray[np.int64]]
"""Grouped by size: each (k, c) node numbers, k polygons of c corners."""


def from_ranges(
    corners: NDArray[np.int64], starts: NDArray[np.int64], ends: NDArray[np.int64]
) -> Polygons:
    """Group polygons, polygon i being ``corners[starts[i]:ends[i]]``."""
    sizes = ends - starts
    if len(sizes) and (starts.min() < 0 or sizes.min() < 0 or ends.max() > len(corners)):
        raise InputError("its polygons reach beyond the corners given")
    return [
        corners[starts[sizes == size, None] + np.arange(size)] for size in np.unique(sizes).tolist()
    ]


def ranges_in_stream(
    stream: NDArray[np.int64], count: int
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Where in ``c i1 ... ic c i1 ...`` the corners of each of `count` polygons start and end."""
    width = int(stream[0]) + 1 if len(stream) else 0
    if width > 0 and len(stream) == count * width and (stream[::width] == width - 1).all():
        starts = np.arange(count) * width + 1
        return starts, starts + (width - 1)
    values, at, found = stream.tolist(), 0, []
    for i in range(count):
        if at >= len(values) or values[at] < 0:
            raise InputError(f"{count} polygons declared, {i} found")
        found.append(at + 1)
        at += 1 + values[at]
    starts = np.array(found, np.int64)
    return starts, starts + stream[starts - 1]


def from_rows(rows: Sequence[str], skip: int = 0) -> Polygons:
    """Group polygons written one a row as ``c i1 ... ic``, after `skip` other columns."""
    groups: dict[str, list[str]] = defaultdict(list)
    for row in rows:
        columns = row.split(maxsplit=skip + 1)
        groups[columns[skip] if len(columns) > skip else ""].append(row)
    polygons = []
    for size, group in groups.items():
        if not (size.isascii() and size.isdecimal()) or int(size[:18]) > len(group[0]):
            raise InputError(f"a polygon expected in the row {quoted(group[0])}")
        polygons.append(table(group, range(skip + 1, skip + 1 + int(size)), np.int64))
    return polygons


def from_strips(strips: Polygons) -> Polygons:
    """Triangles of triangle strips, each turned as the first of its strip."""
    triangles = []
    for group in strips:
        for i in range(group.shape[1] - 2):
            corners = (i, i + 1, i + 2) if i % 2 == 0 else (i + 1, i, i + 2)
            triangles.append(group[:, corners])
    return triangles


def triangulate(polygons: Polygons, nodes: int) -> tuple[NDArray[np.int32] | None, dict[str, int]]:
    """Fan every polygon from its first corner.

    Parameters
    ----------
    polygons : list of (k, c) int64
    nodes : int
        How many nodes there are.

    Returns
    -------
    faces : (m, 3) int32 or None
        None where no triangle is left.
    changed : dict of str to int
        Polygons split and faces left out, counted by reason.

    Raises
    ------
    InputError
        Where a corner names a node that is not there.
    """
    changed = {"faces with fewer than three corners": 0, "polygons split into triangles": 0}
    fans = []
    for group in polygons:
        if group.size == 0 or group.shape[1] < 3:
            changed["faces with fewer than three corners"] += len(group)
            continue
        low, high = int(group.min()), int(group.max())
        if low < 0 or high >= nodes:
            odd = low if low < 0 else high
            raise InputError(f"a face names node {odd}, but the nodes are 0 to {nodes - 1}")
        if group.shape[1] > 3:
            changed["polygons split into triangles"] += len(group)
        fans += [group[:, (0, i, i + 1)] for i in range(1, group.shape[1] - 1)]
    faces = np.concatenate(fans).astype(np.int32) if fans else np.empty((0, 3), np.int32)
    a, b, c = faces.T
    flat = (a == b) | (b == c) | (c == a)
    changed["faces that name a node twice"] = int(flat.sum())
    if changed["faces that name a node twice"]:
        faces = faces[~flat]
    return faces if len(faces) else None, {why: count for why, count in changed.items() if count}
