"""From a file to a surface: reading, checking, hashing, converting."""

import hashlib
from collections.abc import Callable
from pathlib import Path

import numpy as np

from surfcmp_core.errors import InputError
from surfcmp_core.io.arrays import read_npy, read_npz
from surfcmp_core.io.checks import check_nodes
from surfcmp_core.io.columns import read_columns
from surfcmp_core.io.las import read_las
from surfcmp_core.io.obj import read_obj
from surfcmp_core.io.off import read_off
from surfcmp_core.io.ply import read_ply
from surfcmp_core.io.polygons import triangulate
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.stl import read_stl
from surfcmp_core.io.units import MILLIMETRES, unit_in
from surfcmp_core.io.vtk import read_vtk
from surfcmp_core.io.vtp import read_vtp
from surfcmp_core.surface import Surface

READERS: dict[str, Callable[[bytes], Raw]] = {
    ".ply": read_ply,
    ".obj": read_obj,
    ".stl": read_stl,
    ".off": read_off,
    ".vtp": read_vtp,
    ".vtk": read_vtk,
    ".xyz": read_columns,
    ".txt": read_columns,
    ".csv": read_columns,
    ".npy": read_npy,
    ".npz": read_npz,
    ".las": read_las,
    ".laz": read_las,
}
"""The reader of each ending known."""


def read_surface(path: str | Path, *, unit: str | None = None) -> Surface:
    """Read a cloud or a mesh.

    A file with triangles is a mesh, else a cloud; polygons are fanned into triangles. Every node
    of the file is kept, in float64 and in the file's order, but for .stl, whose equal corners
    become one node. A unit given is converted to mm, and so is one that a comment of a .ply,
    .obj, .off, .stl or .vtk states; the others, which may be surveys in metres, keep their bits,
    and the unit they state is only told.

    Parameters
    ----------
    path : str or Path
        Its ending, in either case, says the format.
    unit : {"mm", "cm", "m", "um", "in", "ft"}, optional
        Unit of the file's coordinates, whatever the file says.

    Returns
    -------
    Surface
        With `changed` counting the faces left out or split, and the nodes converted.

    Raises
    ------
    InputError
        Where the file cannot be read or believed; one line that begins with its path.
    """
    path = Path(path)
    if unit is not None and unit not in MILLIMETRES:
        raise ValueError(f"unknown unit {unit!r}: {', '.join(MILLIMETRES)} are known")
    try:
        data = _bytes(path)
        with np.errstate(all="ignore"):  # what overflows is found not finite below
            raw = READERS[path.suffix.lower()](data)
            stated = raw.unit or unit_in(raw.comments)
            converted = unit or (None if raw.unit else stated)
            points = np.ascontiguousarray(raw.points) * MILLIMETRES[converted or "mm"]
        check_nodes(points)
        faces, changed = triangulate(raw.polygons, len(points))
    except InputError as error:
        raise InputError(f"{path}: {error}") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except Exception as error:  # what damage makes a reader meet is not foreseeable
        told = " ".join(str(error).split())[:120]
        raise InputError(f"{path}: damaged or not a {path.suffix} file ({told})") from error

    changed = {**raw.changed, **changed}
    if converted and converted != "mm":
        changed[f"nodes converted from {converted} to mm"] = len(points)
    return Surface(
        points,
        faces,
        name=path.name,
        path=path,
        sha256=hashlib.sha256(data).hexdigest(),
        unit="mm" if converted else stated,
        changed=changed,
    )


def _bytes(path: Path) -> bytes:
    if path.suffix.lower() not in READERS:
        known = " ".join(READERS)
        raise InputError(f"unknown ending {path.suffix!r}; known are {known}")
    if not path.exists():
        raise InputError("no such file")
    if not path.is_file():
        raise InputError("it is a folder" if path.is_dir() else "it is not a regular file")
    data = path.read_bytes()
    if not data:
        raise InputError("the file is empty")
    return data
