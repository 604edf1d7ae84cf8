"""Scans that tests load by name: real ones, where they are at hand, and twins of our own making.

The twins are made from the built-in samples, which have a scanner's noise and holes, and are given
what else real scans have: faces that are not Delaunay, another density, overhangs, nodes at one
place, heights on a lattice, flight lines rounded to the centimetre.
"""

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import Delaunay

from surfcmp_core import read_surface
from surfcmp_core.io.samples import sample_pair
from surfcmp_core.surface import Surface

Faces = NDArray[np.int32]


def real_scan(folder: Path, name: str) -> Surface:
    """Load one of the real scans."""
    with np.load(folder / "data" / f"{name}.npz") as file:
        faces = file["faces"]
        return Surface(file["points"], faces if len(faces) else None, name)


@cache
def made_scan(name: str) -> Surface:
    """Make one of the twins."""
    return replace(MADE[name](), name=name)


def _sample(pair: str, which: int) -> Surface:
    return replace(read_surface(sample_pair(pair)[which]), sha256="", path=None)  # type: ignore[arg-type]


def flipped(surface: Surface, share: float, seed: int) -> Surface:
    """Exchange the diagonal of some pairs of triangles, as other programs' meshes have it."""
    assert surface.faces is not None
    faces, xy = surface.faces.copy(), surface.points[:, :2]
    across: dict[tuple[int, int], tuple[int, int]] = {
        (int(f[i]), int(f[(i + 1) % 3])): (t, int(f[(i + 2) % 3]))
        for t, f in enumerate(faces)
        for i in range(3)
    }

    def turn(a: int, b: int, c: int) -> float:
        (ux, uy), (vx, vy) = xy[b] - xy[a], xy[c] - xy[a]
        return float(ux * vy - uy * vx)

    rng = np.random.default_rng(seed)
    touched: set[int] = set()
    for (a, b), (t, c) in across.items():
        if a > b or (b, a) not in across or rng.random() > share:
            continue
        u, d = across[b, a]
        wide = 0.05 * abs(turn(a, b, c))
        if not touched & {t, u} and turn(c, d, b) > wide and turn(d, c, a) > wide:
            faces[t], faces[u] = (c, d, b), (d, c, a)
            touched |= {t, u}
    return replace(surface, faces=faces)


def _resampled(surface: Surface, cell: float, noise: float, seed: int) -> Surface:
    """Give one node for each cell, as a scanner's export at another density does."""
    assert surface.faces is not None
    rng = np.random.default_rng(seed)
    cells = np.floor(surface.points[:, :2] / cell + rng.random(2))
    _, first = np.unique(cells, axis=0, return_index=True)
    points = surface.points[np.sort(first)] + rng.normal(0.0, noise, (len(first), 3))
    faces = Delaunay(points[:, :2]).simplices.astype(np.int32)
    a, b, c = (points[faces[:, k], :2] for k in range(3))
    turn = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    faces = np.where(turn[:, None] < 0, faces[:, ::-1], faces)
    longest = np.max([np.hypot(*(p - q).T) for p, q in ((a, b), (b, c), (c, a))], axis=0)
    faces = faces[(longest < 3.0 * cell) & (np.abs(turn) > 0.05 * longest**2)]
    used, faces = np.unique(faces, return_inverse=True)
    return flipped(Surface(points[used], faces.reshape(-1, 3).astype(np.int32)), 0.5, seed)


def _bone(skin: Surface) -> Surface:
    """Lower a face by the thickness of its flesh, without eyes; one node stays where it is."""
    assert skin.faces is not None
    x, y, z = skin.points.T
    depth = 4.0 + 6.0 * np.exp(-(((np.abs(x) - 40.0) / 18.0) ** 2) - ((y + 30.0) / 25.0) ** 2)
    points = np.column_stack((0.96 * x + 0.31, 0.97 * y - 1.7, z - depth))
    shared = int(np.argmin(np.hypot(x - 3.0, y - 60.0)))
    points[shared, :2] = skin.points[shared, :2]
    eyes = np.hypot((np.abs(x) - 32.0) / 15.0, (y - 12.0) / 10.0) < 1.0
    faces = skin.faces[~eyes[skin.faces].any(axis=1)]
    used, faces = np.unique(faces, return_inverse=True)
    return Surface(points[used], faces.reshape(-1, 3).astype(np.int32))


def _grid_survey(columns: int, rows: int, shift: tuple[int, int], seed: int) -> Surface:
    """Heights on a lattice of one metre, cocircular everywhere."""
    rng = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(columns) + shift[0], np.arange(rows) + shift[1])
    x, y = x.ravel() * 1.0, y.ravel() * 1.0
    z = 4.0 * np.sin(x / 17.0) + 3.0 * np.cos(y / 11.0) + 0.02 * x
    z += 1.5 * np.exp(-(((x - 60.0) / 12.0) ** 2) - ((y - 50.0) / 9.0) ** 2) * (seed % 2)
    sea = np.hypot(x - 20.0, y - 70.0) < 9.0
    points = np.column_stack((x, y, np.round(z + rng.normal(0.0, 0.03, len(x)), 2)))
    return Surface(points[~sea])


def _flight_line(angle: float, seed: int) -> Surface:
    """Points of an airborne scanner, rounded to the centimetre: some nodes lie in both lines."""
    rng = np.random.default_rng(seed)
    along, across = np.meshgrid(np.arange(0.0, 90.0, 0.5), np.linspace(-30.0, 30.0, 110))
    u = along.ravel() + rng.normal(0.0, 0.08, along.size)
    v = across.ravel() + rng.normal(0.0, 0.05, along.size)
    c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    x, y = np.round(45.0 + c * (u - 45.0) - s * v, 2), np.round(s * (u - 45.0) + c * v, 2)
    common = np.random.default_rng(0).integers(-1500, 1500, (41, 2)) / 100.0 + [45.0, 0.0]
    x, y = np.r_[x, common[:, 0].round(2)], np.r_[y, common[:, 1].round(2)]
    trees = 6.0 * (np.sin(x / 3.0) * np.cos(y / 4.0) > 0.8)
    z = 0.1 * x + 2.0 * np.sin(y / 9.0) + trees + rng.normal(0.0, 0.03, len(x))
    _, first = np.unique(np.column_stack((x, y)), axis=0, return_index=True)
    return Surface(np.round(np.column_stack((x, y, z)), 2)[np.sort(first)])


MADE: dict[str, Callable[[], Surface]] = {
    "made_face": lambda: flipped(_sample("face", 0), 0.5, 1),
    "made_face_later": lambda: flipped(_sample("face", 1), 0.5, 2),
    "made_face_coarse": lambda: _resampled(_sample("face", 0), 7.0, 0.2, 3),
    "made_face_fine": lambda: _resampled(_sample("face", 1), 3.0, 0.05, 4),
    "made_jaw": lambda: flipped(_sample("jaw", 1), 0.4, 5),
    "made_jaw_later": lambda: _resampled(_sample("jaw", 1), 0.9, 0.02, 6),
    "made_skin": lambda: _sample("face", 0),
    "made_bone": lambda: flipped(_bone(_sample("face", 0)), 0.3, 7),
    "made_survey": lambda: _sample("terrain", 0),
    "made_survey_later": lambda: _sample("terrain", 1),
    "made_beach": lambda: _grid_survey(120, 90, (0, 0), 8),
    "made_beach_later": lambda: _grid_survey(110, 100, (7, -4), 9),
    "made_flight": lambda: _flight_line(4.0, 10),
    "made_flight_across": lambda: _flight_line(71.0, 11),
}
"""Twins of our own making, by name."""

MADE_PAIRS = [
    ("made_face", "made_face_later"),
    ("made_face_fine", "made_face_coarse"),
    ("made_jaw", "made_jaw_later"),
    ("made_skin", "made_bone"),
    ("made_survey", "made_survey_later"),
    ("made_beach", "made_beach_later"),
    ("made_flight", "made_flight_across"),
]
"""Which of them are compared."""
