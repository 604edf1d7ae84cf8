"""One comparison of each kind, in a process: ``python -m tests.program.every_machine``."""

import sys
from pathlib import Path

import numpy as np

from tests.core.sheets import sheet
from tests.core.turning import any_motion, mirrored_back

COMPARISONS = {
    "clouds": ("layers.npz", "cloud.npz", "--project", "auto"),
    "sheets": (
        *("sheet.npz", "moved.npz", "--align", "icp"),
        *("--project", "view:0.3,-0.2,1", "--exact"),
    ),
    "closed": ("head.npz", "head_moved.npz", "--project", "auto"),
    "landmarks": ("sheet.npz", "moved.npz", "--align", "landmarks.npy", "--project", "auto"),
    "weighed": ("sheet.npz", "thinned.npz", "--weight", "weight.xyz", "--domain", "plane"),
}


def write_inputs(folder: Path) -> None:
    """Write files to compare: clouds, sheets with noise, closed heads, all turned somehow."""
    rng = np.random.default_rng(7)
    motion = any_motion(rng, 40.0, 300.0, np.zeros(3))
    x, y = (part.ravel() for part in np.meshgrid(np.arange(24.0), np.arange(24.0)))
    layer = np.column_stack((x, y, 0.0 * x))
    layers = np.concatenate((layer, layer + np.array([0.0, 0.0, 1.5])))
    x, y = (part.ravel() for part in np.meshgrid(*[np.linspace(0.0, 23.0, 27)] * 2))
    cloud = np.column_stack((x, y, 1.75 + 0.0 * x))
    np.savez(folder / "layers.npz", points=_moved(layers, motion))
    np.savez(folder / "cloud.npz", points=_moved(cloud, motion))

    def hills(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return 0.4 * np.exp(-3.0 * (x - 0.2) ** 2 - 2.0 * y**2) + 0.2 * np.sin(3.0 * x * y)

    for name, n, turned in (("sheet", 36, 0.0), ("moved", 31, 4.0)):
        surface = sheet(hills, n=n)
        points = 100.0 * (surface.points + rng.normal(scale=1e-3, size=surface.points.shape))
        small = any_motion(rng, turned, turned, np.zeros(3))
        np.savez(folder / f"{name}.npz", points=_moved(points, small), faces=surface.faces)
        np.save(folder / f"{name}_places.npy", _moved(points[:: len(points) // 5], small))
        closed = mirrored_back(sheet(hills, n=n, wide=1.3), 0.3)
        np.savez(
            folder / ("head.npz" if not turned else "head_moved.npz"),
            points=_moved(80.0 * closed.points, motion),
            faces=closed.faces,
        )
    weights = 200.0 * rng.random((50, 3)) - np.array([100.0, 100.0, 0.0])
    np.savetxt(folder / "weight.xyz", weights)


def _moved(points: np.ndarray, motion: np.ndarray) -> np.ndarray:
    return points @ motion[:3, :3].T + motion[:3, 3]


def compare_everything(inputs: Path, out: Path, threads: str) -> None:
    """Run all comparisons; results and what they are made from go to `out`."""
    from surfcmp_core.alignment import fit_landmarks
    from surfcmp_core.cli.commands import run_command

    def path(word: str) -> str:
        if Path(word).suffix not in {".npz", ".npy", ".xyz"}:
            return word
        return str((out if word in {"landmarks.npy", "thinned.npz"} else inputs) / word)

    places = [np.load(inputs / f"{name}_places.npy") for name in ("sheet", "moved")]
    n = min(map(len, places))
    np.save(out / "landmarks.npy", fit_landmarks(places[0][:n], places[1][:n]).matrix)
    thin = ["thin", path("moved.npz"), "--spacing", "9", "--out", path("thinned.npz"), "--quiet"]
    assert run_command(thin) == 0
    for name, words in COMPARISONS.items():
        files = [str(out / f"{name}.{end}") for end in ("npz", "json")]
        command = ["compare", *map(path, words), "--quiet", "--threads", threads]
        assert run_command([*command, "--out", files[0], "--out", files[1]]) == 0, name


if __name__ == "__main__":
    compare_everything(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3])
