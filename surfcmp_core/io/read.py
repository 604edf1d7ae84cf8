"""From a file to a surface: reading, checking, hashing, converting."""

import hashlib
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from surfcmp_core.errors import InputError
from surfcmp_core.io.arrays import read_npy, read_npz
from surfcmp_core.io.checks import check_surface
from surfcmp_core.io.columns import read_columns
from surfcmp_core.io.las import read_las
from surfcmp_core.io.no_data import marked
from surfcmp_core.io.obj import read_obj
from surfcmp_core.io.off import read_off
from surfcmp_core.io.ply import read_ply
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.sniff import looks_like
from surfcmp_core.io.space import stated_space
from surfcmp_core.io.stated_units import stated_unit
from surfcmp_core.io.stl import read_stl
from surfcmp_core.io.triangles import triangulate
from surfcmp_core.io.vtk import read_vtk
from surfcmp_core.io.vtp import read_vtp
from surfcmp_core.surface import Surface
from surfcmp_core.surface.units import SIZES, UNITS, converted, name_of
from surfcmp_core.system.memory import need_memory

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
_TEXTS = (".obj", ".off", ".xyz", ".txt", ".csv")
_TAKES = dict.fromkeys(READERS, 4.0) | dict.fromkeys(_TEXTS, 6.0) | {".npy": 2.0, ".laz": 20.0}
"""Memory that reading takes at least, in sizes of the file; measured on 250 000 nodes."""

_MOST, _LONGEST = 1000, 300
"""Comments, and characters of each, that may state a unit and axes."""


def read_surface(
    path: str | Path,
    *,
    unit: str | None = None,
    no_data: Sequence[float] = (),
    weights: bool = False,
) -> Surface:
    """Read a cloud or a mesh.

    A file with triangles is a mesh, else a cloud; polygons are split into triangles. Every node
    of the file is kept, in float64 and in the file's order, but for .stl, whose equal corners
    become one node. A unit given is converted to mm, and so is one that a comment of a .ply,
    .obj, .off, .stl or .vtk states (``unit cm``, ``1 unit = 1000 mm``); the others, which may be
    surveys in metres, keep their bits, and the unit they state is only told.
    :func:`surfcmp_core.compare` brings two surfaces to one unit, whatever their formats. Axes that
    a comment states (``SPACE=LPS``) are told as well.

    Parameters
    ----------
    path : str or Path
        Its ending, in either case, says the format.
    unit : {"mm", "cm", "m", "um", "in", "ft", "us-ft"}, optional
        Unit of the file's coordinates, whatever the file says.
    no_data : sequence of float, optional
        Values of x, y or z, in the file's unit, that mean that there are no data; NaN: all that is
        not finite. Nodes with such a value, and faces at them, are left out.
    weights : bool, optional
        The heading of a table may name a weight in the place of z.

    Returns
    -------
    Surface
        With `dropped` counting the nodes left out, `changed` the faces left out or split, the
        nodes converted, and those whose value often means that there are no data.

    Raises
    ------
    InputError
        Where the file cannot be read or believed; one line that begins with its path.
    """
    path = Path(path)
    if unit is not None and unit not in UNITS:
        raise ValueError(f"unknown unit {unit!r}: {', '.join(UNITS)} are known")
    data = b""
    try:
        data = _bytes(path)
        with ThreadPoolExecutor(1) as beside, np.errstate(all="ignore"):
            sha256 = beside.submit(_sha256, data)
            reader = READERS[path.suffix.lower()]
            if weights and reader is read_columns:
                reader = partial(read_columns, weights=True)
            surface = _surface(marked(reader(data), no_data), unit)
    except InputError as error:
        raise error.at(str(path)).with_hints(*_mistaken(path, data)) from None
    except OSError as error:
        raise InputError(f"cannot be read: {error.strerror}", where=(str(path),)) from None
    except MemoryError:
        raise InputError("not enough memory to read it", where=(str(path),)) from None
    except Exception as error:  # what damage makes a reader meet is not foreseeable
        told = " ".join(str(error).split())[:120]
        fault = f"damaged or not a {path.suffix} file ({told})"
        raise InputError(fault, where=(str(path),), hints=_mistaken(path, data)) from error
    return replace(surface, name=path.name, path=path, sha256=sha256.result())


def _surface(raw: Raw, unit: str | None) -> Surface:
    surface = _told(Surface(np.ascontiguousarray(raw.points, np.float64)), raw, unit)
    faces, changed = triangulate(raw.polygons, surface.points)
    check_surface(surface.points, faces)
    changed = {**raw.changed, **changed, **surface.changed}
    return replace(surface, faces=faces, dropped=raw.dropped, changed=changed)


def _mistaken(path: Path, data: bytes) -> tuple[str, ...]:
    """Say what a file that could not be read looks like, where that is not what its name says."""
    like = looks_like(data)
    own = path.suffix.lower()
    return () if like is None or own in like else (f"it looks like {like}",)


def _sha256(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def _told(surface: Surface, raw: Raw, unit: str | None) -> Surface:
    """Tell the surface's unit and axes, in mm where its unit is given or to be converted."""
    if raw.refused and unit is None:
        raise InputError(f"{raw.refused} (--unit says the unit of x, y and z)")
    comments = tuple(one[:_LONGEST] for one in raw.comments[:_MOST])
    stated, axes = stated_unit(comments), stated_space(comments)
    odd = (*axes.odd, *(stated.odd if unit is None else ()))
    surface = replace(surface, space=axes.name, changed=dict.fromkeys(odd, 1))
    if unit is not None:
        return converted(surface, SIZES[unit], "mm")
    if stated.size is None or raw.unit is not None:
        return replace(surface, unit=raw.unit, georeferenced=raw.georeferenced)
    if raw.keeps_unit and (name := name_of(stated.size)) in SIZES:
        return replace(surface, unit=name)
    return converted(surface, stated.size, "mm")


def _bytes(path: Path) -> bytes:
    if path.suffix.lower() not in READERS:
        known = " ".join(READERS)
        raise InputError(f"unknown ending {path.suffix!r}; known are {known}")
    if not path.exists():
        raise InputError("no such file")
    if not path.is_file():
        raise InputError("it is a folder" if path.is_dir() else "it is not a regular file")
    need_memory(_TAKES[path.suffix.lower()] * path.stat().st_size)
    data = path.read_bytes()
    if not data:
        raise InputError("the file is empty")
    return data
