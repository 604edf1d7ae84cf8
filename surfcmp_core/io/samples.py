"""The built-in pairs of surfaces whose differences are known."""

import json
from importlib import metadata
from pathlib import Path
from typing import Any, Literal

Sample = Literal["face", "jaw", "terrain"]

SAMPLES: dict[Sample, tuple[str, str]] = {
    "face": ("face_before.ply", "face_after.ply"),
    "jaw": ("face_scan.ply", "jaw_scan.ply"),
    "terrain": ("terrain_2020.npz", "terrain_2024.npz"),
}
"""The two files of each pair."""


def sample_pair(name: Sample = "face") -> tuple[Path, Path]:
    """Files of a built-in pair.

    Parameters
    ----------
    name : {"face", "jaw", "terrain"}
        A face before and after a swelling of one cheek (mm); a face with its teeth bared and a
        dense scan of those teeth (mm); land before and after digging (m).

    Returns
    -------
    (Path, Path)
        Surface 1 and surface 2.

    Raises
    ------
    FileNotFoundError
        If the program was installed without its samples.
    """
    first, second = SAMPLES[name]
    return _find(first), _find(second)


def truth(name: Sample = "face") -> dict[str, Any]:
    """Tell what is true of a built-in pair: unit, noise, volume and place of each change."""
    every = json.loads(_find("truth.json").read_text(encoding="utf-8"))
    return dict(every[name])


def _find(file: str) -> Path:
    """Beside the packages in a checkout; else where the installer put the data files."""
    path = Path(__file__).parents[2] / "resources" / file
    if path.is_file():
        return path
    for entry in metadata.files("surfcmp") or ():
        if entry.match(f"share/surfcmp/{file}"):
            return Path(str(entry.locate())).resolve()
    raise FileNotFoundError(f"{file}: the samples are not installed")
