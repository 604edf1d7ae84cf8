"""A small mesh in every format."""

from collections.abc import Callable

import numpy as np

from tests.core import surface_files as files

Made = Callable[[], bytes]
"""Content of a file, made when it is asked for: some take a while."""

_N = 12
_X, _Y = np.meshgrid(np.arange(_N, dtype=float), np.arange(_N, dtype=float))
POINTS = np.column_stack((_X.ravel(), _Y.ravel(), (_X * _Y).ravel() / 64))
_A = (np.arange(_N - 1)[:, None] * _N + np.arange(_N - 1)).ravel()
FACES = np.concatenate(
    (np.column_stack((_A, _A + 1, _A + _N + 1)), np.column_stack((_A, _A + _N + 1, _A + _N)))
).astype(np.int32)

WRITERS: dict[str, tuple[str, Callable[..., bytes]]] = {
    "ply text": ("ply", files.ply_text),
    "ply binary": ("ply", files.ply_binary),
    "ply big-endian": ("ply", lambda p, f: files.ply_binary(p, f, order=">")),
    "obj": ("obj", files.obj),
    "off": ("off", files.off),
    "stl text": ("stl", files.stl_text),
    "stl binary": ("stl", files.stl_binary),
    "vtk text": ("vtk", files.vtk_text),
    "vtk binary": ("vtk", files.vtk_binary),
    "vtp text": ("vtp", files.vtp_text),
    "vtp base64": ("vtp", files.vtp_base64),
    "vtp compressed": ("vtp", files.vtp_compressed),
    "vtp appended": ("vtp", files.vtp_appended),
    "xyz": ("xyz", files.xyz),
    "csv": ("csv", files.csv),
    "npy": ("npy", files.npy),
    "npz": ("npz", files.npz),
    "las": ("las", files.las),
    "laz": ("laz", lambda p, f: files.las(p, f, compressed=True)),
}
TEXTS = ("ply text", "obj", "off", "stl text", "vtk text", "vtp text", "xyz", "csv")
