"""Polygons of any size, as files hold them."""

from collections import defaultdict
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.io.text import table

Polygons = list[NDArray[np.integer]]
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
    polygons: Polygons = []
    for size, group in groups.items():
        if not (size.isascii() and size.isdecimal()) or int(size[:18]) > len(group[0]):
            raise InputError("a polygon expected", row=group[0])
        polygons.append(table(group, range(skip + 1, skip + 1 + int(size)), np.int64))
    return polygons


def from_strips(strips: Polygons) -> Polygons:
    """Triangles of triangle strips, each turned as the first of its strip."""
    triangles = []
    for group in strips:
        if group.shape[1] > 2:
            three = np.stack((group[:, :-2], group[:, 1:-1], group[:, 2:]), axis=2)
            three[:, 1::2, :2] = three[:, 1::2, 1::-1].copy()
            triangles.append(three.reshape(-1, 3))
    return triangles
