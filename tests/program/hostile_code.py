"""Files that would run code."""

import io
import pickle
import struct
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from tests.core import surface_files as files
from tests.program.hostile_bombs import packed
from tests.program.sound_files import FACES, POINTS, Made


class _Armed:
    """Once unpickled, it makes a file."""

    def __init__(self, marker: Path) -> None:
        self.marker = marker

    def __reduce__(self) -> tuple[object, tuple[object, ...]]:
        return Path.touch, (self.marker,)


def armed_files(marker: Path) -> Iterator[tuple[str, str, Made]]:
    armed = np.array([_Armed(marker)] * 9, object).reshape(3, 3)
    stream = io.BytesIO()
    np.save(stream, armed, allow_pickle=True)
    raw = pickle.dumps(_Armed(marker))
    fields = np.zeros((3, 3), [("x", "f8"), ("y", object)])
    with_fields = io.BytesIO()
    np.save(with_fields, fields, allow_pickle=True)
    yield "npy, pickled objects", "npy", stream.getvalue
    yield "npy, objects in fields", "npy", with_fields.getvalue
    yield "npy, a pickle", "npy", lambda: raw
    yield "npz, pickled objects", "npz", lambda: packed(stream.getvalue())
    yield "npz, a pickle", "npz", lambda: packed(raw)
    yield (
        "npz, a pickle as its unit",
        "npz",
        lambda: files.npz(POINTS, FACES, unit=np.array(_Armed(marker), object)),
    )
    code = f"__import__('pathlib').Path({str(marker)!r}).touch()"
    shapes = ("(3, 3)", f"({code}, 3)", "(10**12, 3)", "(-3, 3)", "(3,) * 3", "(" * 5000)
    for shape in shapes:
        head = f"{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}".encode()
        yield (
            f"npy, shape {shape[:20]}",
            "npy",
            lambda head=head: (
                b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head) + 1) + head + b"\n" + bytes(72)
            ),
        )
    old = b"{'descr': '<f8', 'fortran_order': False, 'shape': (3L, 3L), }\n"
    yield (
        "npy of Python 2",
        "npy",
        lambda: b"\x93NUMPY\x01\x00" + struct.pack("<H", len(old)) + old + np.eye(3).tobytes(),
    )
    for version in (b"\x02\x00", b"\x03\x00", b"\x09\x00"):
        yield (
            f"npy, header of four gigabytes {version!r}",
            "npy",
            lambda version=version: b"\x93NUMPY" + version + b"\xff" * 4 + b"{" * 1000,
        )
    for ending in ("txt", "csv", "xyz", "obj", "ply", "off"):
        yield f"Python in a .{ending}", ending, lambda: f"{code}\n{code} 1 2\n".encode()
