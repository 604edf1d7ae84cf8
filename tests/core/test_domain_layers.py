"""A cloud of more than one layer is told; steps, slopes, noise and trees are no layers."""

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from app.__main__ import main
from surfcmp_core import Surface, compare
from surfcmp_core.domain.layers import MIXED, share_among_layers
from surfcmp_core.grid import grid_of
from surfcmp_core.io import read_surface
from surfcmp_core.io.samples import SAMPLES, Sample, sample_pair
from surfcmp_core.triangulation import triangulate

Points = NDArray[np.float64]


def _share(points: Points) -> float:
    grid = grid_of(Surface(points), duplicates="max")
    return share_among_layers(triangulate(grid.nodes), grid.z)


def _ball(count: int = 4000, seed: int = 0) -> Points:
    points = np.random.default_rng(seed).normal(size=(count, 3))
    return np.asarray(points / np.linalg.norm(points, axis=1)[:, None])


def _lattice(count: int = 60) -> Points:
    x, y = np.meshgrid(np.arange(float(count)), np.arange(float(count)))
    return np.column_stack((x.ravel(), y.ravel(), np.zeros(count * count)))


def _head(density_behind: float = 1.0) -> Points:
    """Closed: higher than wide, with a nose and hollows for the eyes."""
    points = _ball(8000)
    keep = np.random.default_rng(1).random(len(points)) < density_behind
    points = points[(points[:, 2] > 0) | keep]
    x, y, z = points.T
    nose = 0.3 * np.exp(-30 * (x**2 + (y + 0.1) ** 2)) * (z > 0)
    eyes = 0.1 * np.exp(-60 * ((np.abs(x) - 0.35) ** 2 + (y - 0.2) ** 2)) * (z > 0)
    return np.column_stack((80 * x, 110 * y, 90 * (z + nose - eyes)))


LAYERED = {
    "ball": _ball(),
    "flat ball": _ball() * np.array([1, 1, 0.1]),
    "head": _head(),
    "head with a sparse back": _head(0.35),
    "head far from the origin": _head() + np.array([4e5, 5e6, 0]),
    "head in metres": _head() / 1000,
    "two lattices": np.vstack((_lattice(), _lattice() + np.array([0.37, 0.37, 20]))),
    "front and back scan of one lattice": np.vstack(
        (_lattice(), _lattice() + np.array([0.01, 0.02, 9]))
    ),
}


@pytest.mark.parametrize("case", LAYERED)
def test_layers_are_told(case: str) -> None:
    points = LAYERED[case]
    share = _share(points)
    assert share > 1.5 * MIXED
    assert _share(np.random.default_rng(3).permutation(points)) == share


def _noise(scale: float) -> Points:
    points = _lattice()
    points[:, 2] = np.random.default_rng(5).normal(scale=scale, size=len(points))
    return points


def _land() -> Points:
    """Terraces with walls of 30 between them, and trees on a twentieth of the places."""
    rng = np.random.default_rng(8)
    points = _lattice(80)
    points[:, :2] += rng.uniform(-0.4, 0.4, (6400, 2))
    points[:, 2] = 30 * np.floor((points[:, 0] + 9 * np.sin(points[:, 1] / 9)) / 16)
    points[rng.random(6400) < 0.05, 2] += 12
    return points


x, y, _ = _lattice().T
ONE_VALUED = {
    "front of a head": _head()[_head()[:, 2] > 0],
    "plane": _lattice(),
    "noise": _noise(0.2),
    "noise steeper than any scan": _noise(20.0),
    "noise in whole steps": np.round(_noise(0.7)),
    "step": _lattice() + np.column_stack((0 * x, 0 * x, 50 * (x > 30))),
    "stairs": _lattice() + np.column_stack((0 * x, 0 * x, 10 * np.floor((x + y) / 5))),
    "blocks": _lattice() + np.column_stack((0 * x, 0 * x, 90 * ((x // 12 + y // 12) % 2))),
    "one stray in fifty": _lattice() + np.column_stack((0 * x, 0 * x, 500 * (x * y % 50 == 7))),
    "terraces with trees": _land(),
    "steep wall": _lattice() + np.column_stack((0 * x, 0 * x, 400 / (1 + np.exp(30 - x)))),
}


@pytest.mark.parametrize("case", ONE_VALUED)
def test_what_is_one_valued_is_not_doubted(case: str) -> None:
    assert _share(ONE_VALUED[case]) < 0.5 * MIXED


@pytest.mark.parametrize("name", SAMPLES)
def test_samples_are_not_doubted(name: Sample) -> None:
    for path in sample_pair(name):
        assert _share(read_surface(path).points) < 0.5 * MIXED


def test_real_scans_are_not_doubted(shared: Path) -> None:
    for path in sorted((shared / "data").glob("*.npz")):
        assert _share(read_surface(path).points) < 0.5 * MIXED, path.name


def test_comparison_and_info_tell_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    head = Surface(_head(), name="head", unit="mm")
    front = Surface(_head()[_head()[:, 2] > 0] + np.array([0, 0, 1]), name="front", unit="mm")
    [told] = [one for one in compare(head, front).warnings if "one-valued" in one]
    assert told.startswith("head: not one-valued: seen along z, ")
    assert "--project auto" in told
    np.savetxt(tmp_path / "head.xyz", head.points)
    assert main(["info", str(tmp_path / "head.xyz")]) == 0
    assert "no: " in (said := capsys.readouterr().out)
    assert "of the nodes lie among nodes of another layer" in said
    np.savetxt(tmp_path / "front.xyz", front.points)
    assert main(["info", str(tmp_path / "front.xyz")]) == 0
    assert "yes, seen along z" in capsys.readouterr().out
