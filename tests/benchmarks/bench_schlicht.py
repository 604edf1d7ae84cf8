"""From a file of a million nodes to its schlicht part, in times of reading it; CPU time."""

import gc
import tempfile
from collections.abc import Callable
from pathlib import Path
from statistics import median
from time import process_time

import numpy as np
import trimesh
from numpy.typing import NDArray

from surfcmp_core.io import read_surface
from surfcmp_core.projection import (
    frame,
    moved,
    schlicht_part,
    viewing_direction,
    wound_alike,
)
from surfcmp_core.surface import Surface
from tests.benchmarks.timing import REPEATS

_NODES = 1_000_000


def _faces(number: NDArray[np.int32]) -> NDArray[np.int32]:
    a, b, c, d = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
    return np.concatenate([np.stack(t, -1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))])


def sheet(count: int = _NODES) -> Surface:
    """Return hills seen from above: nothing of them is hidden."""
    side = round(count**0.5)
    x, y = (part.ravel() for part in np.meshgrid(*[np.linspace(-100.0, 100.0, side)] * 2))
    z = 20.0 * np.sin(x / 17.0) * np.cos(y / 13.0)
    number = np.arange(side * side, dtype=np.int32).reshape(side, side)
    return Surface(np.column_stack((x, y, z)), _faces(number))


def head(count: int = _NODES) -> Surface:
    """Return a closed ball with a nose, brows and a chin that hide a little: half of it shows."""
    side = round((count / 6) ** 0.5) + 1
    u, v = (part.ravel() for part in np.meshgrid(*[np.linspace(-1.0, 1.0, side)] * 2))
    one = np.ones_like(u)
    sides = [np.roll(np.column_stack((u, v, one)), k, axis=1) for k in range(3)]
    cube = np.concatenate([*sides, *[-part[:, ::-1] for part in sides]])
    number = np.arange(side * side, dtype=np.int32).reshape(side, side)
    faces = np.concatenate([_faces(number) + np.int32(k * side * side) for k in range(6)])
    _, first, where = np.unique(
        np.round(cube * 1e6).astype(np.int64), axis=0, return_index=True, return_inverse=True
    )
    ball = cube[np.sort(first)]
    rank = np.argsort(np.argsort(first)).astype(np.int32)
    faces = rank[where.ravel()][faces]
    ball /= np.linalg.norm(ball, axis=1)[:, None]
    x, y, z = ball.T
    nose = 0.35 * np.exp(-25.0 * (x**2 + (y + 0.1) ** 2)) * (z > 0.0)
    chin = 0.2 * np.exp(-15.0 * (x**2 + (y + 0.7) ** 2)) * (z > 0.0)
    waves = 0.02 * np.sin(15.0 * y) + 0.01 * np.sin(20.0 * x)
    radius = 1.0 + nose + chin + waves
    return Surface(ball * radius[:, None] * [75.0, 110.0, 95.0], faces)


def _cpu_seconds(*works: Callable[[], object]) -> list[float]:
    times: list[list[float]] = [[] for _ in works]
    for _ in range(REPEATS + 1):
        for work, taken in zip(works, times, strict=True):
            gc.collect()
            begin = process_time()
            work()
            taken.append(process_time() - begin)
    return [median(taken[1:]) for taken in times]


def _measure(name: str, surface: Surface, path: Path) -> str:
    trimesh.Trimesh(surface.points, surface.faces, process=False).export(path)
    scan = read_surface(path)
    turn = frame(viewing_direction(scan))
    turned = moved(scan, turn)
    _, removed = schlicht_part(turned)
    share = 100.0 * removed.area_kept / (removed.area_kept + sum(removed.area.values()))
    reading, winding, search, moving, cutting = _cpu_seconds(
        lambda: read_surface(path),
        lambda: wound_alike(scan),
        lambda: viewing_direction(scan),
        lambda: moved(scan, turn),
        lambda: schlicht_part(turned),
    )
    given = (reading + winding + moving + cutting) / reading
    return (
        f"{name}, {len(scan.points)} nodes, PLY: read {reading:.3f} s, winding {winding:.3f} s, "
        f"direction {search:.3f} s, move {moving:.3f} s, schlicht part ({share:.0f} % of the area) "
        f"{cutting:.3f} s: "
        f"{given:.2f} times reading where the direction is given, "
        f"{given + search / reading:.2f} where it is sought"
    )


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        print(_measure("sheet", sheet(), Path(folder) / "sheet.ply"))
        print(_measure("closed head", head(), Path(folder) / "head.ply"))
