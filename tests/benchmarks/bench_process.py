"""`surfcmp compare` as a whole process, beside CloudCompare where it is installed."""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import trimesh
from triangular import delaunay

from tests.benchmarks.surfaces import uniform_surface
from tests.benchmarks.timing import seconds


def _write(path: Path, count: int, seed: int) -> Path:
    points = uniform_surface(count, seed).points * (200.0, 200.0, 20.0)
    trimesh.Trimesh(points, delaunay(np.ascontiguousarray(points[:, :2])), process=False).export(
        path
    )
    return path


def _run(*command: str | Path) -> None:
    subprocess.run([str(word) for word in command], check=True, capture_output=True)


if __name__ == "__main__":
    surfcmp = (sys.executable, "-m", "app", "compare")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        small = [_write(folder / f"small{i}.ply", 1000, i) for i in (1, 2)]
        large = [_write(folder / f"large{i}.ply", n, i) for i, n in ((1, 200_000), (2, 150_000))]
        tiny, ours = seconds(
            lambda: _run(*surfcmp, *small, "--json"), lambda: _run(*surfcmp, *large, "--json")
        )
        print(f"1000 + 1000 nodes: {tiny:.2f} s whole process")
        line = f"200 k + 150 k nodes, PLY meshes: {ours:.2f} s whole process"
        cloud_compare = shutil.which("CloudCompare") or shutil.which("cloudcompare.CloudCompare")
        if cloud_compare and shutil.which("xvfb-run"):
            peer = ["xvfb-run", "-a", cloud_compare, "-SILENT", "-AUTO_SAVE", "OFF"]
            (theirs,) = seconds(
                lambda: _run(*peer, "-O", large[1], "-O", large[0], "-C2M_DIST"), repeats=3
            )
            line += f", CloudCompare -C2M_DIST {theirs:.2f} s: {theirs / ours:.1f} times faster"
        else:
            line += " (CloudCompare is not installed)"
        print(line)
