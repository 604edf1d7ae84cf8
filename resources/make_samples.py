"""Write the built-in samples and what is true of them: ``python resources/make_samples.py``.

Everything is computed from formulas and seeds; running it again writes the same bytes. Heights are
given noise as a scanner would; truth.json speaks of the noise-free heights.
"""

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
from face_shape import EYEBROW_HOLE, face, outline
from numpy.typing import NDArray
from sampling import Box, mesh, rounded, roughness, scatter
from terrain_shape import SIZE, inside, terrain

Array = NDArray[np.float64]

FACE_BOX: Box = (-78, 78, -112, 110)
FACE_NOISE = 0.06
FACE_QUANTUM = 2.0**-9
SWELLING = {"x": 39.0, "y": -26.0, "radius": 22.0, "height": 6.0}

TERRAIN_NOISE = 0.05
TERRAIN_QUANTUM = 2.0**-7
QUARRY = {"x": 830.0, "y": 620.0, "radius": 95.0, "height": -18.0}
HEAP = {"x": 330.0, "y": 240.0, "radius": 70.0, "height": 9.0}
LAKES_2020 = ((560.0, 690.0, 75.0), (1010.0, 190.0, 55.0))
LAKES_2024 = ((562.0, 686.0, 82.0), (150.0, 700.0, 45.0))


def dome(x: Array, y: Array, at: dict[str, float]) -> Array:
    """A smooth round mound, h (1 - r²/R²)³; its volume is π R² h / 4."""
    r2 = ((x - at["x"]) ** 2 + (y - at["y"]) ** 2) / at["radius"] ** 2
    return at["height"] * np.maximum(1 - r2, 0) ** 3


def dome_volume(at: dict[str, float]) -> float:
    """Its volume, signed as its height."""
    return float(np.pi * at["radius"] ** 2 * at["height"] / 4)


def swollen(x: Array, y: Array) -> Array:
    """The face with its swelling."""
    return face(x, y) + dome(x, y, SWELLING)


def dug(x: Array, y: Array) -> Array:
    """The land with its quarry and the heap beside it."""
    return terrain(x, y) + dome(x, y, QUARRY) + dome(x, y, HEAP)


def in_before(x: Array, y: Array) -> NDArray[np.bool_]:
    """Where the first face was scanned."""
    return outline(x, y, np.array([0.3, 2.0, 4.1])) > 0


def in_after(x: Array, y: Array) -> NDArray[np.bool_]:
    """Where the second face was scanned."""
    cx, cy, rx, ry = EYEBROW_HOLE
    hair = ((x - cx) / rx) ** 2 + ((y - cy - 0.1 * (x - cx)) / ry) ** 2 < 1
    return (outline(x, y, np.array([3.2, 0.4, 1.1])) > 0) & ~hair


def write_ply(path: Path, points: Array, faces: NDArray[np.int32]) -> None:
    """Binary little-endian, float32."""
    head = (
        "ply\nformat binary_little_endian 1.0\ncomment surfcmp sample, MIT licence\n"
        f"element vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    record = np.empty(len(faces), dtype=[("n", "u1"), ("v", "<i4", 3)])
    record["n"], record["v"] = 3, faces
    path.write_bytes(head.encode() + points.astype("<f4").tobytes() + record.tobytes())


def face_pair(folder: Path) -> dict[str, Any]:
    """Face before and after a swelling of the left cheek."""
    scans = (
        ("face_before", face, in_before, 9000, 101),
        ("face_after", swollen, in_after, 4000, 202),
    )
    for name, height, within, count, seed in scans:
        rng = np.random.default_rng(seed)
        density = roughness(height, FACE_BOX, 1.0, 6.0)
        nodes = scatter(count, FACE_BOX, within, density, rng, 8)
        nodes, faces = mesh(rounded(nodes, FACE_QUANTUM), within)
        z = height(*nodes.T) + rng.normal(0, FACE_NOISE, len(nodes))
        write_ply(folder / f"{name}.ply", np.column_stack([nodes, rounded(z, FACE_QUANTUM)]), faces)
    return {
        "files": ["face_before.ply", "face_after.ply"],
        "unit": "mm",
        "noise_sigma": FACE_NOISE,
        "seeds": [101, 202],
        "sign": "d = F1 - F2: negative where the second face is swollen",
        "changes": [
            {
                "what": "swelling of the left cheek (+x)",
                "centre": [SWELLING["x"], SWELLING["y"]],
                "radius": SWELLING["radius"],
                "signed_volume": -dome_volume(SWELLING),
                "mean_signed": -SWELLING["height"] / 4,
                "extreme": -SWELLING["height"],
            }
        ],
    }


def terrain_pair(folder: Path) -> dict[str, Any]:
    """Land before and after digging."""
    box = (0.0, SIZE[0], 0.0, SIZE[1])
    surveys = (
        ("terrain_2020", terrain, LAKES_2020, 6000, 303),
        ("terrain_2024", dug, LAKES_2024, 10000, 404),
    )
    for name, height, lakes, count, seed in surveys:
        rng = np.random.default_rng(seed)
        density = roughness(height, box, 10.0, 2.0)
        nodes = scatter(count, box, lambda x, y, lakes=lakes: inside(x, y, lakes), density, rng, 3)
        nodes = rounded(nodes, TERRAIN_QUANTUM)
        z = rounded(height(*nodes.T) + rng.normal(0, TERRAIN_NOISE, len(nodes)), TERRAIN_QUANTUM)
        np.savez(folder / f"{name}.npz", points=np.column_stack([nodes, z]).astype("<f4"))
    return {
        "files": ["terrain_2020.npz", "terrain_2024.npz"],
        "unit": "m",
        "noise_sigma": TERRAIN_NOISE,
        "seeds": [303, 404],
        "sign": "d = F1 - F2: positive where earth was taken away by 2024",
        "changes": [
            {
                "what": what,
                "centre": [at["x"], at["y"]],
                "radius": at["radius"],
                "signed_volume": -dome_volume(at),
                "mean_signed": -at["height"] / 4,
                "extreme": -at["height"],
            }
            for what, at in (("quarry", QUARRY), ("heap", HEAP))
        ],
    }


def main(folder: Path) -> None:
    """Write all samples and truth.json into a folder."""
    truth = {"face": face_pair(folder), "terrain": terrain_pair(folder)}
    (folder / "truth.json").write_text(json.dumps(truth, indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)
