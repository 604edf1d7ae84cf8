"""Random pairs of grids, family by family: what has broken triangulators and mergers.

The same family and seed give the same pair on every machine.
"""

import json
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Nodes = NDArray[np.float64]
Random = np.random.Generator
Family = Callable[[Random, int, int], tuple[Nodes, Nodes]]


@dataclass(frozen=True, slots=True, eq=False)
class Pair:
    """Two sets of distinct nodes, neither of them on one line; the sets may share nodes."""

    name: str
    first: Nodes
    second: Nodes

    def save(self, path: Path) -> None:
        document = {
            "name": self.name,
            "first": self.first.tolist(),
            "second": self.second.tolist(),
        }
        path.write_text(json.dumps(document) + "\n")


def load(path: Path) -> Pair:
    document = json.loads(path.read_text())
    return Pair(
        document["name"],
        np.array(document["first"], np.float64),
        np.array(document["second"], np.float64),
    )


def distinct(nodes: Nodes) -> Nodes:
    """Return rows without repetitions, in no particular order."""
    nodes = np.asarray(nodes, np.float64).reshape(-1, 2)
    order = np.lexsort((nodes[:, 1], nodes[:, 0]))
    placed = nodes[order]
    fresh = np.ones(len(placed), bool)
    fresh[1:] = (placed[1:] != placed[:-1]).any(axis=1)
    return nodes[np.sort(order[fresh])]


def _cells(rng: Random, count: int, columns: int, rows: int) -> Nodes:
    cells = (rng.integers(0, columns, count), rng.integers(0, rows, count))
    return np.column_stack(cells).astype(np.float64)


def _full_lattice(columns: int, rows: int) -> Nodes:
    x, y = np.meshgrid(np.arange(columns), np.arange(rows))
    return np.column_stack((x.ravel(), y.ravel())).astype(np.float64)


def _turned(nodes: Nodes, angle: float) -> Nodes:
    c, s = np.cos(angle), np.sin(angle)
    return np.asarray(nodes @ np.array([[c, s], [-s, c]]))


def _uniform(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    return rng.random((n1, 2)), rng.random((n2, 2))


def _clustered(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    centres = rng.random((6, 2)) * 10.0
    of_1, of_2 = rng.integers(0, 6, n1), rng.integers(0, 6, n2)
    return (
        centres[of_1] + rng.normal(size=(n1, 2)) * 0.3,
        centres[of_2] + rng.normal(size=(n2, 2)) * 0.3,
    )


def _clusters_apart(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    """Clusters of either grid alone, side by side: many clouts, many bridges."""
    places = rng.permutation(16)
    centres = np.column_stack((places % 4, places // 4)) * 1.0
    of_1, of_2 = rng.integers(0, 8, n1), rng.integers(8, 16, n2)
    return (
        centres[of_1] + rng.normal(size=(n1, 2)) * 0.12,
        centres[of_2] + rng.normal(size=(n2, 2)) * 0.12,
    )


def _nested(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    scale = 10.0 ** -rng.integers(1, 7)
    second = rng.normal(size=(n2, 2)) * scale
    if rng.random() < 0.5:  # the dense part in a corner of a triangle, not in the middle
        second += rng.normal(size=2)
    return rng.normal(size=(n1, 2)), second


def _lattice(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    columns, rows = rng.integers(2, 9, 2)
    return _cells(rng, n1, columns, rows), _cells(rng, n2, columns, rows)


def _half_cell(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    columns, rows = rng.integers(2, 9, 2)
    shift = rng.choice([0.0, 0.5], 2)
    return _cells(rng, n1, columns, rows), _cells(rng, n2, columns, rows) + shift


def _full_lattices(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    c1, c2 = rng.integers(2, 9, 2)
    first = _full_lattice(c1, max(2, n1 // c1))
    second = _full_lattice(c2, max(2, n2 // c2)) * rng.choice([0.5, 1.0, 2.0])
    return first, second + rng.choice([0.0, 0.25, 0.5, 1.0, -3.0], 2)


def _lattice_turned(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    angle = float(rng.choice([np.pi / 6, np.pi / 4, rng.random()]))
    columns, rows = rng.integers(2, 7, 2)
    first, second = _cells(rng, n1, columns, rows), _cells(rng, n2, columns, rows)
    if rng.random() < 0.5:
        first = _turned(first, angle)
    return first, _turned(second, angle)


def _lattice_decimal(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    """Steps of 0.1 far from the origin: collinear and cocircular but for the last bits."""
    offset = rng.choice([0.0, 5e5])
    columns, rows = rng.integers(2, 9, 2)
    first = offset + 0.1 * _cells(rng, n1, columns, rows)
    second = offset + 0.1 * (_cells(rng, n2, columns, rows) + rng.choice([0.0, 0.5], 2))
    return first, second


def _combs(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    """Teeth of one between those of the other."""
    height = int(rng.integers(3, 40))
    first, second = _cells(rng, n1, 5, height), _cells(rng, n2, 5, height)
    second += np.array([0.5, rng.choice([0.0, 0.5, 0.25])])
    return first * [height, 1.0], second * [height, 1.0]


def _rings(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    parts: list[Nodes] = []
    for n, radii in ((n1, [1.0, 2.0, 0.5]), (n2, [1.5, 0.7, 1.0])):
        angle = rng.random(n) * 2.0 * np.pi
        if rng.random() < 0.5:
            angle = np.round(angle * 12.0 / np.pi) * np.pi / 12.0
        parts.append(np.column_stack((np.cos(angle), np.sin(angle))) * rng.choice(radii, (n, 1)))
    return parts[0], parts[1]


def _circle_of_integers(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    """Whole-numbered nodes on circles, exactly."""
    x, y = np.meshgrid(np.arange(-65, 66), np.arange(-65, 66))
    square = x * x + y * y
    parts = []
    for n in (n1, n2):
        on = np.isin(square, rng.choice([325, 1105, 4225, 65, 25], 2))
        circle = np.column_stack((x[on], y[on])).astype(np.float64)
        parts.append(circle[rng.permutation(len(circle))[:n]])
        if rng.random() < 0.5:
            parts[-1][0] = 0.0
    return parts[0], parts[1]


def _runs(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    """Collinear runs with a node or two off them."""
    direction = rng.choice([[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [2.0, -1.0]])
    parts = []
    for n in (n1, n2):
        run = rng.integers(-20, 20, (n, 1)) * direction
        if rng.random() < 0.5:
            run = run + rng.integers(-2, 3, 2)
        off = rng.integers(-9, 10, (rng.integers(1, 4), 2))
        parts.append(np.concatenate((run, off)))
    return parts[0], parts[1]


def _runs_parallel(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    step = 0.5 * rng.integers(0, 2)
    return _cells(rng, n1, 30, 3), _cells(rng, n2, 30, 5) * [1.0, 0.5] + [step, 0.0]


def _in_one_triangle(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    first = np.concatenate(([[0.0, 0.0], [100.0, 0.0], [0.0, 100.0]], rng.random((n1, 2)) - 101.0))
    if rng.random() < 0.5:
        return first[:3], rng.random((n2, 2)) * 10.0 + 20.0
    return first, _cells(rng, n2, 5, 5) + 20.0


def _apart(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    shift = rng.integers(-3, 4, 2) * 4.0
    if rng.random() < 0.5:
        return _cells(rng, n1, 5, 5), _cells(rng, n2, 5, 5) + shift
    return rng.random((n1, 2)) * 4.0, rng.random((n2, 2)) * 4.0 + shift


def _common_left(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    """Both grids begin on one vertical line: the first starter has no circle."""
    parts = []
    for n in (n1, n2):
        nodes = _cells(rng, n, 4, 50)
        nodes[: 1 + n // 4, 0] = 0.0
        parts.append(nodes)
    return parts[0], parts[1] + [0.0, rng.choice([0.5, 60.0, -60.0])]


def _strip(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    thin = 10.0 ** -rng.integers(2, 7)
    return rng.random((n1, 2)) * [1.0, thin], rng.random((n2, 2)) * [1.0, thin]


def _noisy_lattice(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    """A lattice whose nodes are a few last bits off."""
    side = int(rng.integers(2, 7))
    first = _cells(rng, n1, side, side) + 1.0
    second = _cells(rng, n2, side, side) + 1.0
    for nodes in (first, second):
        nodes += rng.integers(-2, 3, nodes.shape) * 2.0**-50
    return first, second


def _equal(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    nodes = _cells(rng, n1, 7, 7) if rng.random() < 0.5 else rng.random((n1, 2))
    return nodes, nodes[rng.permutation(n1)]


def _subset(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    nodes = _cells(rng, n1, 9, 9) if rng.random() < 0.5 else rng.random((n1, 2))
    return nodes, nodes[rng.random(n1) < rng.random()]


def _half_shared(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    first = _cells(rng, n1, 9, 9) * 2.0 if rng.random() < 0.5 else rng.random((n1, 2))
    second = _cells(rng, n2, 9, 9) * 2.0 + 1.0 if rng.random() < 0.5 else rng.random((n2, 2))
    return first, np.concatenate((first[rng.random(n1) < 0.5], second))


def _few_left(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    """All nodes shared but one or two in either grid."""
    nodes = _cells(rng, n1, 6, 6) if rng.random() < 0.5 else rng.random((n1, 2))
    parts = [np.concatenate((nodes, rng.random((rng.integers(0, 3), 2)) * 3.0)) for _ in range(2)]
    return parts[0], parts[1]


def _left_collinear(rng: Random, n1: int, n2: int) -> tuple[Nodes, Nodes]:
    """What is not shared lies on one line, in one grid or in both."""
    nodes = rng.integers(0, 6, (n1, 2)) * 1.0 if rng.random() < 0.5 else rng.random((n1, 2)) * 5.0
    lines = [rng.integers(0, 12, (rng.integers(0, 6), 1)) * 0.5 * [[1.0, k]] for k in (0.0, 1.0)]
    if rng.random() < 0.5:
        lines[0] = rng.random((n2, 2)) * 5.0
    return np.concatenate((nodes, lines[0])), np.concatenate((nodes, lines[1]))


FAMILIES: dict[str, Family] = {
    function.__name__[1:]: function
    for function in (
        _uniform,
        _clustered,
        _clusters_apart,
        _nested,
        _lattice,
        _half_cell,
        _full_lattices,
        _lattice_turned,
        _lattice_decimal,
        _combs,
        _rings,
        _circle_of_integers,
        _runs,
        _runs_parallel,
        _in_one_triangle,
        _apart,
        _common_left,
        _strip,
        _noisy_lattice,
        _equal,
        _subset,
        _half_shared,
        _few_left,
        _left_collinear,
    )
}


def is_flat(nodes: Nodes) -> bool:
    """Whether distinct nodes lie on one line, by fractions."""
    if len(nodes) < 3:
        return True
    (ax, ay), (bx, by) = ((Fraction(x), Fraction(y)) for x, y in nodes[:2].tolist())
    return all(
        (bx - ax) * (Fraction(y) - ay) == (by - ay) * (Fraction(x) - ax)
        for x, y in nodes[2:].tolist()
    )


def _placed(rng: Random, first: Nodes, second: Nodes) -> tuple[Nodes, Nodes]:
    """Move, turn over and scale both alike, two times in five."""
    kind = rng.integers(0, 10)
    if kind == 0:  # near 1e9 only the coarsest structure survives the rounding
        offset = rng.choice([-1.0, 1.0], 2) * 10.0 ** rng.integers(1, 10, 2)
        return first + offset, second + offset
    if kind == 1:
        factor = rng.choice([2.0**-60, 2.0**60, 1e-100, 1e100, 1e-7, 1e7])
        return first * factor, second * factor
    if kind == 2:
        return first[:, ::-1], second[:, ::-1]
    if kind == 3:
        return -first, -second
    return first, second


def pair_of(family: str, seed: int, *, most: int = 40) -> Pair:
    """Make the pair of a family and a seed, of up to `most` nodes a grid or a few more."""
    number = list(FAMILIES).index(family)
    rng = np.random.default_rng([number, seed])
    while True:
        n1, n2 = (int(n) for n in rng.integers(3, most + 1, 2))
        first, second = FAMILIES[family](rng, n1, n2)
        first, second = _placed(rng, first, second)
        first, second = distinct(first), distinct(second)
        if not is_flat(first) and not is_flat(second):
            break
    if rng.random() < 0.5:
        first, second = second, first
    return Pair(f"{family} {seed}", np.ascontiguousarray(first), np.ascontiguousarray(second))
