"""Reading of a mesh of a million triangles, beside trimesh, which checks and hashes nothing."""

import hashlib
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import trimesh

from surfcmp_core.io import read_surface
from tests.benchmarks.timing import seconds
from tests.core import surface_files as files

_SIDE = 700
FORMS: dict[str, tuple[str, Callable[[Any, Any], bytes]]] = {
    "binary .ply of doubles": (".ply", files.ply_binary),
    "binary .ply of floats": (".ply", lambda p, f: files.ply_binary(p, f, real="f4")),
    "binary .ply, big-endian": (".ply", lambda p, f: files.ply_binary(p, f, order=">")),
}


def _mesh() -> tuple[files.Points, files.Faces]:
    x, y = np.meshgrid(np.arange(_SIDE) * 0.1, np.arange(_SIDE) * 0.1)
    points = np.column_stack((x.ravel(), y.ravel(), np.sin(x.ravel()) * np.cos(y.ravel())))
    a = (np.arange(_SIDE - 1)[:, None] * _SIDE + np.arange(_SIDE - 1)).ravel()
    lower = np.column_stack((a, a + 1, a + _SIDE + 1))
    upper = np.column_stack((a, a + _SIDE + 1, a + _SIDE))
    return points, np.concatenate((lower, upper)).astype(np.int32)


def main() -> None:
    """Print seconds of both and their ratio, and what hashing alone takes."""
    points, faces = _mesh()
    with TemporaryDirectory() as folder:
        for name, (ending, written) in FORMS.items():
            path = Path(folder) / f"mesh{ending}"
            path.write_bytes(written(points, faces))
            data = path.read_bytes()
            ours, theirs, hashing = seconds(
                lambda path=path: read_surface(path),  # type: ignore[misc]
                lambda path=path: trimesh.load(path, process=False),  # type: ignore[misc]
                lambda data=data: hashlib.sha256(data).digest(),  # type: ignore[misc]
                repeats=11,
            )
            print(
                f"{name}, {len(data) / 1e6:.1f} MB: {1e3 * ours:.0f} ms, trimesh "
                f"{1e3 * theirs:.0f} ms, ratio {ours / theirs:.2f}; "
                f"SHA-256 alone {1e3 * hashing:.0f} ms"
            )


if __name__ == "__main__":
    main()
