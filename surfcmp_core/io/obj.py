"""Read .obj: its nodes, in their order, and its polygons; textures, groups and lines are ignored.

Ours, for a library parts nodes at the seams of textures, loses those of clouds, and hides what it
did not understand.
"""

import re
from collections import defaultdict

import numpy as np

from surfcmp_core.errors import InputError
from surfcmp_core.io.polygons import Polygons
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.text import decode, table

_FREE_FORM = re.compile(r"^[ \t]*(cstype|surf|curv2?|bzp|bsp|cdp)\b", re.MULTILINE)
"""Statements of free-form surfaces and curves, also those of the format's second version."""


def read_obj(data: bytes) -> Raw:
    """Nodes and polygons; corners counted from the end (negative) are resolved."""
    text = decode(data)
    if "\\\n" in text:
        text = text.replace("\\\n", " ")
    if found := _FREE_FORM.search(text):
        raise InputError(
            f"it holds a free-form surface ({found[1]!r}), which is not read; its control nodes "
            "do not lie on it"
        )
    nodes: list[str] = []
    faces: list[str] = []
    before: list[int] = []  # nodes defined before each face
    comments: list[str] = []
    for line in text.split("\n"):
        match line.lstrip()[:2]:
            case "v " | "v\t":
                nodes.append(line)
            case "f " | "f\t":
                faces.append(line)
                before.append(len(nodes))
            case start if start.startswith("#"):
                comments.append(line)
    points = table(nodes, (1, 2, 3), np.float64)

    text = "\n".join(faces)
    if "#" in text:
        text = re.sub("#.*", "", text)
    text = re.sub(r"/\S*", "", text)  # corner/texture/normal
    groups: dict[int, tuple[list[str], list[int]]] = defaultdict(lambda: ([], []))
    for row, defined in zip(text.split("\n") if faces else (), before, strict=True):
        rows, defineds = groups[len(row.split())]
        rows.append(row)
        defineds.append(defined)
    polygons: Polygons = []
    for columns, (rows, defineds) in groups.items():
        corners = table(rows, range(1, columns), np.int64)
        counted_back = corners < 0
        corners += np.where(counted_back, np.array(defineds)[:, None], -1)
        polygons.append(corners)
    return Raw(points, polygons, tuple(comments))
