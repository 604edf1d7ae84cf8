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
        elif path.suffix in (".txt", ".xyz", ".pcd"):
            sets[path.stem] = np.array(_of_text(path), np.float64)
    return {name: nodes.reshape(-1, 2) for name, nodes in sets.items()}
