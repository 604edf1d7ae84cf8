"""Sets of nodes from the test files of other triangulators, each in its own little format."""

import json
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from tests.pairs import Nodes

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"


def _of_json(value: object) -> Iterator[list[float]]:
    """Every list of two or three numbers, however deep."""
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list):
        if len(value) in (2, 3) and all(isinstance(v, int | float) for v in value):
            yield value[:2]
        else:
            for item in value:
                yield from _of_json(item)
    elif isinstance(value, str):
        for x, y in re.findall(rf"({NUMBER})\s+({NUMBER})", value):
            yield [float(x), float(y)]


def _of_text(path: Path) -> list[list[float]]:
    """Rows of two or more numbers; what stands before them may say how many there are."""
    lines = path.read_text().splitlines()
    count = len(lines)
    if path.suffix == ".txt":
        count, lines = int(lines[0].split()[0]), lines[1:]
    rows = [line.split() for line in lines[:count]]
    return [
        [float(row[0]), float(row[1])]
        for row in rows
        if len(row) >= 2 and all(re.fullmatch(NUMBER, word) for word in row[:2])
    ]


def _of_polygons(path: Path) -> Iterator[tuple[str, Nodes]]:
    """Name, numbers and polygons of each set, each polygon behind the count of its nodes."""
    head = re.compile(r"^([A-Za-z]\w*) \S+ \S+ \d+$", re.MULTILINE)
    _, *parts = head.split(path.read_text())
    for name, text in zip(parts[::2], parts[1::2], strict=True):
        rows = [line.split() for line in text.splitlines()]
        yield name, np.array([row for row in rows if len(row) == 2], np.float64)


def _of_predicates(path: Path) -> Nodes:
    """Places whose sides are asked for: the first two coordinates of each."""
    rows = np.loadtxt(path)[:, 1:-1]
    size = 3 if path.stem in ("orient3d", "insphere") else 2
    return rows.reshape(-1, size)[:, :2]


def node_sets(folder: Path) -> dict[str, Nodes]:
    """All sets under a folder, by file and name, repetitions included."""
    sets: dict[str, Nodes] = {}
    for path in sorted(folder.rglob("*")):
        if path.suffix in (".json", ".geojson"):
            document = json.loads(path.read_text())
            if isinstance(document, dict) and "type" not in document:
                for name, value in document.items():
                    sets[f"{path.stem}/{name}"] = np.array(list(_of_json(value)), np.float64)
            else:
                sets[path.stem] = np.array(list(_of_json(document)), np.float64)
        elif path.suffix == ".xml" or path.parent.name.endswith("_seed_corpus"):
            sets[path.stem] = np.array(list(_of_json(path.read_text())), np.float64)
        elif folder.name == "manifold":
            sets |= {f"{path.stem}/{name}": nodes for name, nodes in _of_polygons(path)}
        elif folder.name == "robust-predicates":
            sets[path.stem] = _of_predicates(path)
        elif path.suffix in (".txt", ".xyz", ".pcd"):
            sets[path.stem] = np.array(_of_text(path), np.float64)
    return {name: nodes.reshape(-1, 2) for name, nodes in sets.items()}
