"""Write the built-in samples and what is true of them: ``python resources/make_samples.py``.

Everything is computed from formulas and seeds; running it again writes the same bytes. Heights are
given noise as a scanner would; truth.json speaks of the noise-free heights.
"""

import json
import sys
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from face_shape import face, outline
from numpy.typing import NDArray
from sampling import Box, Height, Inside, mesh, roughness, rounded, scatter
from teeth_shape import face_with_teeth, teeth
from terrain_shape import SIZE, inside, terrain

Array = NDArray[np.float64]

FACE_BOX: Box = (-78, 78, -112, 110)
FACE_NOISE = 0.06
FACE_QUANTUM = 2.0**-9
SWELLING = {"x": 39.0, "y": -26.0, "radius": 22.0, "height": 6.0}

SCAN_NOISE = (0.08, 0.02)
JAW_BOX: Box = (-30, 30, -71, -38)

TERRAIN_NOISE = 0.05
TERRAIN_QUANTUM = 2.0**-7
QUARRY = {"x": 830.0, "y": 620.0, "radius": 95.0, "height": -18.0}
HEAP = {"x": 330.0, "y": 240.0, "radius": 70.0, "height": 9.0}
LAKES_2020 = ((560.0, 690.0, 75.0), (1010.0, 190.0, 55.0))
LAKES_2024 = ((562.0, 686.0, 82.0), (150.0, 700.0, 45.0))


def dome(x: Array, y: Array, at: dict[str, float]) -> Array:
    """Height of a smooth round mound, h (1 - r²/R²)³; its volume is π R² h / 4."""
    r2 = ((x - at["x"]) ** 2 + (y - at["y"]) ** 2) / at["radius"] ** 2
    return at["height"] * np.maximum(1 - r2, 0) ** 3


def change(what: str, at: dict[str, float]) -> dict[str, Any]:
    """Tell what F1 - F2 is where the second surface has a dome."""
    return {
        "what": what,
        "centre": [at["x"], at["y"]],
        "half_axes": [at["radius"], at["radius"]],
        "signed_volume": -np.pi * at["radius"] ** 2 * at["height"] / 4,
        "mean_signed": -at["height"] / 4,
        "extreme": -at["height"],
    }


def swollen(x: Array, y: Array) -> Array:
    """Height of the face with its swelling."""
    return face(x, y) + dome(x, y, SWELLING)


def dug(x: Array, y: Array) -> Array:
    """Height of the land with its quarry and its heap."""
    return terrain(x, y) + dome(x, y, QUARRY) + dome(x, y, HEAP)


def in_before(x: Array, y: Array) -> NDArray[np.bool_]:
    """Where the first face was scanned."""
    return outline(x, y, np.array([0.3, 2.0, 4.1])) > 0


def in_after(x: Array, y: Array) -> NDArray[np.bool_]:
    """Where the second face was scanned: a patch of the right eyebrow was lost."""
    hair = ((x + 44) / 8.5) ** 2 + ((y - 38.6 - 0.1 * (x + 44)) / 3.6) ** 2 < 1
    return (outline(x, y, np.array([3.2, 0.4, 1.1])) > 0) & ~hair


def in_face_scan(x: Array, y: Array) -> NDArray[np.bool_]:
    """Where the face with bared teeth was scanned."""
    return outline(x, y, np.array([1.7, 5.0, 2.6])) > 0


def in_jaw_scan(x: Array, y: Array) -> NDArray[np.bool_]:
    """Where the teeth were scanned: beyond the lips, and the gums under them."""
    return np.asarray(np.abs(x / 28.5) ** 3.5 + np.abs((y + 54.5) / 15.5) ** 3 < 1)


def write_ply(path: Path, points: Array, faces: NDArray[np.int32]) -> None:
    """Write a mesh in mm, binary little-endian, float32."""
    head = (
        "ply\nformat binary_little_endian 1.0\n"
        "comment surfcmp sample, MIT licence\ncomment unit mm\n"
        f"element vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    record = np.empty(len(faces), dtype=[("n", "u1"), ("v", "<i4", 3)])
    record["n"], record["v"] = 3, faces
    path.write_bytes(head.encode() + points.astype("<f4").tobytes() + record.tobytes())


def write_scan(
    path: Path, height: Height, within: Inside, box: Box, count: int, seed: int, noise: float
) -> None:
    """Sample a height field more densely where it bends, add noise, write it as a mesh."""
    rng = np.random.default_rng(seed)
    density = roughness(height, box, (box[1] - box[0]) / 156, 6.0)
    nodes = scatter(count, box, within, density, rng, 8)
    nodes, faces = mesh(rounded(nodes, FACE_QUANTUM), within)
    z = height(*nodes.T) + rng.normal(0, noise, len(nodes))
    write_ply(path, np.column_stack([nodes, rounded(z, FACE_QUANTUM)]), faces)


def face_pair(folder: Path) -> dict[str, Any]:
    """Face before and after a swelling of the left cheek."""
    before, after = folder / "face_before.ply", folder / "face_after.ply"
    write_scan(before, face, in_before, FACE_BOX, 9000, 101, FACE_NOISE)
    write_scan(after, swollen, in_after, FACE_BOX, 4000, 202, FACE_NOISE)
    return {
        "files": [before.name, after.name],
        "unit": "mm",
        "noise_sigma": [FACE_NOISE, FACE_NOISE],
        "seeds": [101, 202],
        "sign": "d = F1 - F2: negative where the second face is swollen",
        "changes": [change("swelling of the left cheek (+x)", SWELLING)],
    }


def jaw_pair(folder: Path) -> dict[str, Any]:
    """Face with bared teeth, and a dense scan of those teeth."""
    scan, jaw = folder / "face_scan.ply", folder / "jaw_scan.ply"
    write_scan(scan, face_with_teeth, in_face_scan, FACE_BOX, 5000, 505, SCAN_NOISE[0])
    write_scan(jaw, teeth, in_jaw_scan, JAW_BOX, 9000, 606, SCAN_NOISE[1])
    return {
        "files": [scan.name, jaw.name],
        "unit": "mm",
        "noise_sigma": list(SCAN_NOISE),
        "seeds": [505, 606],
        "sign": "d = F1 - F2: 0 on the bared teeth, positive where a lip covers the gum",
        "changes": [
            lips_over_gums("bared teeth", (0.0, -54.2), (24.0, 9.0)),
            lips_over_gums("teeth, gums and the lips over them", (0.0, -54.5), (27.5, 14.8)),
        ],
    }


def lips_over_gums(
    what: str, centre: tuple[float, float], half_axes: tuple[float, float]
) -> dict[str, Any]:
    """Tell what F1 - F2 of the jaw pair is within an ellipse, by the midpoint rule."""
    cells = 600
    u, v = np.meshgrid(*2 * [(np.arange(cells) + 0.5) * 2 / cells - 1])
    inside = u**2 + v**2 < 1
    x, y = centre[0] + half_axes[0] * u[inside], centre[1] + half_axes[1] * v[inside]
    d = face_with_teeth(x, y) - teeth(x, y)
    return {
        "what": what,
        "centre": list(centre),
        "half_axes": list(half_axes),
        "signed_volume": round(float(d.mean() * np.pi * half_axes[0] * half_axes[1]), 2),
        "mean_signed": round(float(d.mean()), 4),
        "extreme": round(float(d.max()), 3),
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
        nodes = scatter(count, box, partial(inside, lakes=lakes), density, rng, 3)
        nodes = rounded(nodes, TERRAIN_QUANTUM)
        z = rounded(height(*nodes.T) + rng.normal(0, TERRAIN_NOISE, len(nodes)), TERRAIN_QUANTUM)
        points = np.column_stack([nodes, z]).astype("<f4")
        np.savez(folder / f"{name}.npz", points=points, unit=np.array("m"))
    return {
        "files": ["terrain_2020.npz", "terrain_2024.npz"],
        "unit": "m",
        "noise_sigma": [TERRAIN_NOISE, TERRAIN_NOISE],
        "seeds": [303, 404],
        "sign": "d = F1 - F2: positive where earth was taken away by 2024",
        "changes": [change("quarry", QUARRY), change("heap", HEAP)],
    }


def main(folder: Path) -> None:
    """Write all samples and truth.json into a folder."""
    truth = {"face": face_pair(folder), "jaw": jaw_pair(folder), "terrain": terrain_pair(folder)}
    (folder / "truth.json").write_text(json.dumps(truth, indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)
