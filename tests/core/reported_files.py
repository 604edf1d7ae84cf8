"""Files with what was reported of them."""

from pathlib import Path
from typing import Any

import numpy as np

from surfcmp_core.surface.units import SIZES
from tests.core import surface_files as files

REPORTS = Path(__file__).parent / "fixtures" / "reports"


def written(folder: Path, name: str, unit: str, height: float) -> Path:
    """Write a plane of 9 m², `height` metres high, in the unit and the format of the name."""
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(4.0), np.arange(4.0)))
    size = float(SIZES[unit or "mm"] / SIZES["m"])
    points = np.column_stack((x, y, np.full(16, height))) / size
    corners = (0, 1, 2, 4, 5, 6, 8, 9, 10)
    faces = np.array([[a, a + 1, a + 5] for a in corners] + [[a, a + 5, a + 4] for a in corners])
    ending = name.rpartition(".")[2]
    comment = f"unit {unit}" if unit else "no word of it"
    units: dict[str, Any] = {"unit": unit} if unit else {}
    content = {
        "ply": lambda: files.ply_text(points, faces, comment=comment),
        "obj": lambda: files.obj(points, faces, comment=comment),
        "xyz": lambda: f"# {comment}\n".encode() + files.xyz(points),
        "npz": lambda: files.npz(points, faces, **units),
    }[ending]()
    path = folder / name
    path.write_bytes(content)
    return path
