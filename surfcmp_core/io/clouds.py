"""Writing nodes: .ply, .npz and .xyz, every bit kept, as our readers read them."""

from collections.abc import Callable
from typing import Any, BinaryIO

import numpy as np

from surfcmp_core.surface import Surface


def _write_ply(surface: Surface, stream: BinaryIO) -> None:
    header = [
        "ply",
        "format binary_little_endian 1.0",
        *(f"comment {statement}" for statement in _statements(surface)),
        f"element vertex {len(surface.points)}",
        *(f"property double {axis}" for axis in "xyz"),
        "end_header\n",
    ]
    stream.write("\n".join(header).encode())
    stream.write(surface.points.astype("<f8").tobytes())


def _statements(surface: Surface) -> list[str]:
    unit = [f"unit {surface.unit}"] if surface.unit else []
    return [*unit, f"SPACE={surface.space}"] if surface.space else unit


def _write_npz(surface: Surface, stream: BinaryIO) -> None:
    stated = {"unit": surface.unit, "space": surface.space}
    arrays: dict[str, Any] = {key: np.array(word) for key, word in stated.items() if word}
    np.savez(stream, points=surface.points, **arrays)


def _write_xyz(surface: Surface, stream: BinaryIO) -> None:
    for statement in _statements(surface):
        stream.write(f"# {statement}\n".encode())
    np.savetxt(stream, surface.points, fmt="%.17g")


CLOUD_WRITERS: dict[str, Callable[[Surface, BinaryIO], None]] = {
    ".ply": _write_ply,
    ".npz": _write_npz,
    ".xyz": _write_xyz,
}
"""Writers of a surface's nodes, unit and axes, by the ending of the file's name."""
