"""The built-in samples are what their truth file says."""

import subprocess
import sys
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray
from scipy.interpolate import LinearNDInterpolator
from scipy.spatial import cKDTree

from surfcmp_core import compare, read_surface
from surfcmp_core.io.samples import SAMPLES, Sample, sample_pair, truth

Array = NDArray[np.float64]
RESOURCES = Path(__file__).parents[2] / "resources"
FILES = [file for pair in SAMPLES.values() for file in pair]
MESHES = [file for file in FILES if file.endswith(".ply")]
NODES = {
    "face_before.ply": (9000, 0.85, 2.7),
    "face_after.ply": (4000, 1.25, 3.9),
    "face_scan.ply": (5000, 1.15, 3.7),
    "jaw_scan.ply": (9000, 0.27, 0.65),
    "terrain_2020.npz": (6000, 9.0, 18.5),
    "terrain_2024.npz": (10000, 6.8, 14.5),
}
"""Nodes of each file, and the spacings between which all but a tenth of them stand apart."""


def read(file: str) -> tuple[Array, NDArray[np.int64] | None]:
    if file.endswith(".npz"):
        return np.load(RESOURCES / file)["points"].astype(float), None
    mesh: Any = trimesh.load(RESOURCES / file, process=False)
    return np.asarray(mesh.vertices, dtype=np.float64), np.asarray(mesh.faces)


def ellipse(change: dict[str, Any], cells: int) -> tuple[Array, Array, float]:
    """Midpoints of the cells inside a change's ellipse, and the area of a cell."""
    (cx, cy), (a, b) = change["centre"], change["half_axes"]
    u, v = np.meshgrid(*2 * [(np.arange(cells) + 0.5) * 2 / cells - 1])
    inside = u**2 + v**2 < 1
    return cx + a * u[inside], cy + b * v[inside], 4 * a * b / cells**2


@pytest.fixture
def shapes(monkeypatch: pytest.MonkeyPatch) -> dict[Sample, tuple[Any, Any]]:
    """The noise-free heights behind each pair."""
    monkeypatch.syspath_prepend(str(RESOURCES))
    made = import_module("make_samples")
    return {
        "face": (made.face, made.swollen),
        "jaw": (made.face_with_teeth, made.teeth),
        "terrain": (made.terrain, made.dug),
    }


def test_the_script_writes_the_same_bytes_again(tmp_path: Path) -> None:
    subprocess.run([sys.executable, RESOURCES / "make_samples.py", tmp_path], check=True)
    written = sorted(path.name for path in tmp_path.iterdir())
    assert written == sorted([*FILES, "truth.json"])
    for name in written:
        assert (tmp_path / name).read_bytes() == (RESOURCES / name).read_bytes(), name


def test_each_pair_is_found() -> None:
    for name in SAMPLES:
        assert [path.name for path in sample_pair(name)] == truth(name)["files"]
        assert [read_surface(path).unit for path in sample_pair(name)] == 2 * [truth(name)["unit"]]


def test_samples_are_small() -> None:
    assert sum((RESOURCES / file).stat().st_size for file in FILES) < 2_000_000


@pytest.mark.parametrize("file", FILES)
def test_nodes_are_one_valued_finite_and_as_dense_as_declared(file: str) -> None:
    points, _ = read(file)
    count, near, far = NODES[file]
    assert count - 20 <= len(points) <= count
    assert np.isfinite(points).all()
    assert len(np.unique(points[:, :2], axis=0)) == len(points)
    apart = cKDTree(points[:, :2]).query(points[:, :2], 5)[0][:, 1:].mean(axis=1)
    assert near <= np.percentile(apart, 5)
    assert np.percentile(apart, 95) <= far


@pytest.mark.parametrize("file", MESHES)
def test_meshes_do_not_fold_and_have_no_slivers(file: str) -> None:
    points, faces = read(file)
    assert faces is not None
    assert np.array_equal(np.unique(faces), np.arange(len(points)))
    a, b, c = (points[faces[:, k], :2] for k in range(3))
    turn = np.cross(np.c_[b - a, np.zeros(len(a))], np.c_[c - a, np.zeros(len(a))])[:, 2]
    assert (turn > 0).all()
    edges = np.stack([np.hypot(*(p - q).T) for p, q in ((a, b), (b, c), (c, a))])
    assert np.percentile(turn / edges.max(axis=0) ** 2, 0.1) > 0.1  # height by length
    pairs, shared = np.unique(
        np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1),
        axis=0,
        return_counts=True,
    )
    assert shared.max() == 2
    # Not folded: the triangles fill what the border encloses, holes apart, exactly once.
    border = pairs[shared == 1]
    assert len(np.unique(border)) == len(border), "the border touches itself"
    assert len(points) - len(pairs) + len(faces) == (0 if file == "face_after.ply" else 1)


@pytest.mark.parametrize("name", SAMPLES)
def test_truth_is_the_integral_of_the_formulas(
    name: Sample, shapes: dict[Sample, tuple[Any, Any]]
) -> None:
    first, second = shapes[name]
    for change in truth(name)["changes"]:
        x, y, cell = ellipse(change, 901)
        d = first(x, y) - second(x, y)
        assert d.sum() * cell == pytest.approx(change["signed_volume"], rel=1e-3, abs=1e-6)
        assert d.mean() == pytest.approx(change["mean_signed"], rel=1e-3, abs=1e-9)
        extreme = d[np.abs(d).argmax()]
        assert extreme == pytest.approx(change["extreme"], rel=0.01, abs=1e-9)


@pytest.mark.parametrize("name", SAMPLES)
def test_files_carry_the_stated_noise(name: Sample, shapes: dict[Sample, tuple[Any, Any]]) -> None:
    told = truth(name)
    for file, height, sigma in zip(told["files"], shapes[name], told["noise_sigma"], strict=True):
        points, _ = read(file)
        noise = points[:, 2] - height(points[:, 0], points[:, 1])
        assert noise.std() == pytest.approx(sigma, rel=0.05)
        assert abs(noise.mean()) < 4 * sigma / np.sqrt(len(points))


@pytest.mark.parametrize("name", SAMPLES)
def test_files_show_the_true_volume(name: Sample) -> None:
    told = truth(name)
    first, second = (
        LinearNDInterpolator(points[:, :2], points[:, 2])
        for points, _ in (read(file) for file in told["files"])
    )
    for change in told["changes"]:
        x, y, cell = ellipse(change, 400)
        seen = float((first(x, y) - second(x, y)).sum() * cell)
        area = len(x) * cell
        assert seen == pytest.approx(change["signed_volume"], rel=0.02, abs=0.02 * area)


def test_compare_finds_the_swelling() -> None:
    before, after = sample_pair("face")
    result = compare(read_surface(before), read_surface(after))
    change = truth("face")["changes"][0]
    nodes, triangles = result.united.nodes, result.united.triangles
    away = np.hypot(*(nodes[triangles].mean(axis=1) - change["centre"]).T)
    near = result.compared & (away < change["half_axes"][0] + 1)
    volume = (result.mean_signed[near] * result.area[near]).sum()
    assert volume == pytest.approx(change["signed_volume"], rel=0.03)
    largest = np.nanargmax(result.mean_abs)
    assert away[largest] < 4
    assert result.mean_signed[largest] == pytest.approx(change["extreme"], abs=0.3)
    assert result.measures.max_abs == pytest.approx(abs(change["extreme"]), abs=0.3)
    hole = (nodes[triangles].mean(axis=1) - (-44.0, 38.6)) @ np.diag((1 / 6, 1 / 2.5))
    assert not result.compared[np.hypot(*hole.T) < 1].any()


def test_compare_finds_quarry_and_heap() -> None:
    result = compare(*map(read_surface, sample_pair("terrain")))
    middle = result.united.nodes[result.united.triangles].mean(axis=1)
    for change in truth("terrain")["changes"]:
        away = np.hypot(*(middle - change["centre"]).T)
        near = result.compared & (away < change["half_axes"][0] + 5)
        volume = (result.mean_signed[near] * result.area[near]).sum()
        assert volume == pytest.approx(change["signed_volume"], rel=0.03)
    for lake in ((560.0, 690.0), (1010.0, 190.0), (150.0, 700.0)):
        assert not result.compared[np.hypot(*(middle - lake).T) < 15].any()
