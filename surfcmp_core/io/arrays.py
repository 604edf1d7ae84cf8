"""Read .npy and .npz, without pickles and without believing a header's size."""

import json
import warnings
import zipfile
from contextlib import suppress
from io import BytesIO
from typing import Any

import numpy as np
from numpy.lib import format as npy
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.io.polygons import Polygons
from surfcmp_core.io.raw import Raw
from surfcmp_core.io.stated_units import unit_named
from surfcmp_core.io.unpacked import check_unpacked
from surfcmp_core.names import quoted


def read_npy(data: bytes) -> Raw:
    """Nodes of an (n, 3) array."""
    return Raw(_points(_array(data, "the array")))


def read_npz(data: bytes) -> Raw:
    """`points` (n, 3), optionally `faces` (m, 3).

    A unit may stand in `unit` or in the JSON of `meta`, the name of its axes in `space`.
    """
    try:
        archive = zipfile.ZipFile(BytesIO(data))
    except zipfile.BadZipFile:
        raise InputError("not an .npz archive") from None
    with archive:
        arrays = {name.removesuffix(".npy"): name for name in archive.namelist()}
        if "points" not in arrays:
            raise InputError(f"it holds no 'points', only {', '.join(arrays)[:80] or 'nothing'}")
        found: dict[str, NDArray[Any]] = {
            key: _array(_unpacked(archive, arrays[key]), key)
            for key in ("points", "faces")
            if key in arrays
        }
        for key in ("unit", "meta", "space"):
            with suppress(KeyError, InputError):  # of any shape; not what was asked for
                found[key] = _array(_unpacked(archive, arrays[key]), key)
    polygons: Polygons = []
    if (faces := found.get("faces")) is not None:
        if faces.ndim != 2 or faces.shape[1] != 3 or faces.dtype.kind not in "iu":
            raise InputError(f"faces must be (m, 3) whole numbers, not {_describe(faces)}")
        polygons = [faces.astype(np.int64)]
    stated = _stated_unit(found)
    unit = unit_named(stated)
    odd = f"statement of a unit that is not understood: {quoted(stated)}"
    return Raw(
        _points(found["points"]),
        polygons,
        (f"SPACE={found['space']}",) if "space" in found else (),
        unit,
        changed={odd: 1} if stated and unit is None else {},
    )


def _unpacked(archive: zipfile.ZipFile, name: str) -> bytes:
    """Octets of a member, no more than it declares, and that within reason."""
    member = archive.getinfo(name)
    if member.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise InputError(f"{name} is packed in a way that NumPy does not write")
    check_unpacked(member.file_size, member.compress_size)
    with archive.open(member) as stream:
        return stream.read(member.file_size)


def _array(data: bytes, key: str) -> NDArray[Any]:
    """Do what `numpy.load` does, after comparing the size declared with the size there."""
    stream = BytesIO(data)
    version = npy.read_magic(stream)
    header = npy.read_array_header_1_0 if version == (1, 0) else npy.read_array_header_2_0
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # at a header by Python 2, which is read all the same
        shape, by_columns, dtype = header(stream)
    if dtype.hasobject:
        raise InputError(f"{key} holds pickled objects, which are not read")
    count = 1
    for length in shape:
        count *= length
    if count < 0 or count * dtype.itemsize > len(data) - stream.tell():
        raise InputError(f"{key} declares the shape {shape}, more than the file has room for")
    values = np.frombuffer(data, dtype, count, stream.tell())
    return values.reshape(shape, order="F" if by_columns else "C")


def _points(array: NDArray[Any]) -> NDArray[np.float64]:
    if array.ndim != 2 or array.shape[1] != 3 or array.dtype.kind not in "fiu":
        raise InputError(f"points must be (n, 3) numbers, not {_describe(array)}")
    return array.astype(np.float64)


def _describe(array: NDArray[Any]) -> str:
    return f"{array.shape} {array.dtype}"


def _stated_unit(found: dict[str, NDArray[Any]]) -> str:
    if "unit" in found:
        return str(found["unit"])
    try:
        meta = json.loads(str(found["meta"]))
        return str(meta.get("unit", meta.get("units", "")))
    except (KeyError, ValueError, AttributeError, RecursionError):
        return ""
