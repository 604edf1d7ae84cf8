"""Random trials of the whole program: two surfaces, how their files are written, options."""

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from tests.fuzz.shrinking import fewer
from tests.pairs import FAMILIES, Nodes, distinct, is_flat, pair_of

Random = np.random.Generator

MESHES = ("ply", "ply binary", "obj", "off", "vtk", "vtk binary", "vtp", "vtp base64", "npz")
CLOUDS = ("xyz", "txt", "csv", "npy", "npz", "ply", "obj", "off", "vtk")
POLYGONS = {"ply", "obj", "off"}
"""Forms that are written with quadrangles too."""
FAR = {"nested", "strip", "noisy_lattice", "lattice_decimal"}
"""Families whose nodes lie too close together for random motions of space."""


@dataclass(frozen=True, slots=True)
class Model:
    """A surface and the file it is written to.

    Attributes
    ----------
    points : list of [x, y, z]
    polygons : list of lists of node numbers, or None
        None for a cloud. Some nodes may be in no polygon.
    form : str
        Of `MESHES` or `CLOUDS`.
    style : dict
        How the file is written; see `tests.fuzz.writing`.
    """

    points: list[list[float]]
    polygons: list[list[int]] | None
    form: str
    style: dict[str, Any]


@dataclass(frozen=True, slots=True)
class Trial:
    """What is compared, and how.

    Attributes
    ----------
    options : dict
        Fields of `Options` that are not as by default; "weight" and "align" are the contents of
        those files.
    """

    name: str
    models: tuple[Model, Model]
    options: dict[str, Any]

    def save(self, path: Path) -> None:
        path.write_text(json.dumps(asdict(self)) + "\n")


def load(path: Path) -> Trial:
    document = json.loads(path.read_text())
    one, two = (Model(**model) for model in document["models"])
    return Trial(document["name"], (one, two), document["options"])


def random_trial(seed: int) -> Trial:
    """Make the trial of a seed."""
    rng = np.random.default_rng([7, seed])
    family = str(rng.choice(list(FAMILIES)))
    pair = pair_of(family, seed, most=int(rng.choice([6, 15, 60])))
    sets = [pair.first, pair.second]
    largest = max(float(np.abs(nodes).max()) for nodes in sets)
    if not 1e-6 < largest < 1e12:
        sets = [distinct(nodes / largest * 10.0) for nodes in sets]
        if any(is_flat(nodes) for nodes in sets):
            return random_trial(seed + 10**9)
    size = max(float(np.ptp(nodes, axis=0).max()) for nodes in sets)
    models = [_model(rng, nodes, size) for nodes in sets]
    return Trial(f"{family} {seed}", (models[0], models[1]), _options(rng, sets, size, family))


def _model(rng: Random, nodes: Nodes, size: float) -> Model:
    kind = rng.integers(0, 5)
    z = {
        0: np.zeros(len(nodes)),
        1: rng.integers(-3, 4, len(nodes)) * 1.0,
        2: nodes @ [0.25, -0.5],
        3: rng.normal(size=len(nodes)) * size * 0.1,
        4: size * np.sin(3.0 * nodes[:, 0] / size),
    }[int(kind)]
    points = np.column_stack((nodes, z))
    mesh = bool(rng.random() < 0.6)
    style: dict[str, Any] = {
        "end": str(rng.choice(["\n", "\r\n"])),
        "separator": str(rng.choice([" ", "\t", ",", ";", ", "])),
        "heading": str(rng.choice(["", "x y z", "X Y Z", "# x y z", "x [mm] y [mm] z [mm]"])),
        "comment": str(rng.choice(["", "made by a test", "unit mm"])),
        "long": bool(rng.random() < 0.5),
    }
    if not mesh:
        if rng.random() < 0.2:  # again, at another height
            again = points[rng.random(len(points)) < 0.3]
            points = np.concatenate((points, again + np.array([0.0, 0.0, 1.0])))
        order = rng.permutation(len(points))
        return Model(points[order].tolist(), None, str(rng.choice(CLOUDS)), style)
    form = str(rng.choice(MESHES))
    polygons = _triangles(rng, nodes)
    if form in POLYGONS and rng.random() < 0.3:
        polygons = _joined(polygons)
    if rng.random() < 0.5:
        polygons = [one[::-1] for one in polygons]
    turns = rng.integers(0, 3, len(polygons)).tolist()
    polygons = [one[k:] + one[:k] for one, k in zip(polygons, turns, strict=True)]
    if rng.random() < 0.3:  # nodes in no polygon: near, far and above
        stray = np.column_stack((rng.normal(size=(4, 2)) * 3.0 * size, rng.normal(size=4) * size))
        stray[0, :2] = points[0, :2]
        points = np.concatenate((points, stray))
    order = rng.permutation(len(points))
    place = np.argsort(order)
    polygons = [[int(place[v]) for v in one] for one in polygons]
    return Model(points[order].tolist(), polygons, form, style)


def _triangles(rng: Random, nodes: Nodes) -> list[list[int]]:
    """Triangulate the nodes and leave out some triangles; their order is any."""
    from surfcmp_core.grid import safe_scale
    from surfcmp_core.triangulation import triangulate

    faces = rng.permutation(triangulate(nodes * safe_scale(nodes)).triangles)
    some: list[list[int]] = faces[rng.random(len(faces)) < rng.choice([0.7, 0.9, 1.0])].tolist()
    return some or faces.tolist()


def _joined(triangles: list[list[int]]) -> list[list[int]]:
    """Make quadrangles of neighbouring triangles, convex or not."""
    of_edge = {(t[i], t[i - 2]): k for k, t in enumerate(triangles) for i in range(3)}
    used: set[int] = set()
    polygons = []
    for k, (a, b, c) in enumerate(triangles):
        other = of_edge.get((b, a), -1)
        if k in used or other in used or other == -1:
            continue
        (d,) = set(triangles[other]) - {a, b}
        used |= {k, other}
        polygons.append([a, d, b, c])
    return polygons + [t for k, t in enumerate(triangles) if k not in used]


def _options(rng: Random, sets: list[Nodes], size: float, family: str) -> dict[str, Any]:
    found: dict[str, Any] = {
        "domain": str(rng.choice(["data", "hull", "plane"])),
        "exact": bool(rng.random() < 0.5),
        "threads": int(rng.integers(1, 3)),
        "duplicates": str(rng.choice(["refuse", "mean", "max", "min"])),
        "tolerances": sorted((rng.random(2) * size * 0.2).tolist()),
    }
    if rng.random() < 0.3:
        found["max_edge"] = float(rng.choice([np.inf, size * rng.random() + 1e-9]))
    if rng.random() < 0.2:
        found["unit"] = str(rng.choice(["mm", "cm", "in"]))
    if rng.random() < 0.3:
        low, high = sets[0].min(axis=0), sets[0].max(axis=0)
        places = low + rng.random((9, 2)) * (high - low)
        found["weight"] = np.column_stack((places, rng.integers(0, 3, 9))).tolist()
    if family not in FAR and rng.random() < 0.3:
        angle = rng.normal() * 0.1
        matrix = np.eye(4)
        matrix[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
        matrix[:3, 3] = rng.normal(size=3) * size * 0.05
        found["align"] = matrix.tolist()
    if family not in FAR and rng.random() < 0.3:
        found["project"] = str(rng.choice(["auto", "view:0.2,-0.1,1", "view:0,0,-1"]))
    return found


def smaller(trial: Trial, is_bad: Callable[[Trial], bool]) -> Trial:
    """Drop options, polygons and nodes as long as the trial stays bad."""
    for name in list(trial.options):
        without = replace(trial, options={k: v for k, v in trial.options.items() if k != name})
        trial = without if is_bad(without) else trial
    for side in (0, 1):
        trial = _smaller_model(trial, side, is_bad)
    return trial


def _smaller_model(trial: Trial, side: int, is_bad: Callable[[Trial], bool]) -> Trial:
    def put(points: list[list[float]], polygons: list[list[int]] | None) -> Trial:
        model = replace(trial.models[side], points=points, polygons=polygons)
        models = (model, trial.models[1]) if side == 0 else (trial.models[0], model)
        return replace(trial, models=models)

    points, polygons = trial.models[side].points, trial.models[side].polygons
    if polygons is None:
        return put(fewer(points, lambda some: is_bad(put(some, None))), None)
    polygons = fewer(polygons, lambda some: bool(some) and is_bad(put(points, some)))
    used = {v for one in polygons for v in one}

    def with_some(stray: list[int]) -> Trial:
        kept = sorted(used | set(stray))
        place = {v: k for k, v in enumerate(kept)}
        return put([points[v] for v in kept], [[place[v] for v in one] for one in polygons])

    stray = [v for v in range(len(points)) if v not in used]
    return with_some(fewer(stray, lambda some: is_bad(with_some(some))))
