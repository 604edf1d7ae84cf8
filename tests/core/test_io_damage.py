"""Damaged files of every format are read or refused, and nothing else happens."""

from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from surfcmp_core.errors import InputError
from surfcmp_core.io import facts_of, read_surface
from tests.core import surface_files as files

SOUND: dict[str, tuple[str, bytes]] = {
    "ply text": ("ply", files.ply_text(files.SQUARE)),
    "ply binary": ("ply", files.ply_binary(files.SQUARE)),
    "obj": ("obj", files.obj(files.SQUARE)),
    "off": ("off", files.off(files.SQUARE)),
    "stl text": ("stl", files.stl_text(files.SQUARE)),
    "stl binary": ("stl", files.stl_binary(files.SQUARE)),
    "vtk text": ("vtk", files.vtk_text(files.SQUARE)),
    "vtk binary": ("vtk", files.vtk_binary(files.SQUARE)),
    "vtp text": ("vtp", files.vtp_text(files.SQUARE)),
    "vtp compressed": ("vtp", files.vtp_compressed(files.SQUARE)),
    "vtp appended": ("vtp", files.vtp_appended(files.SQUARE)),
    "xyz": ("xyz", files.xyz(files.SQUARE)),
    "csv": ("csv", files.csv(files.SQUARE)),
    "npy": ("npy", files.npy(files.SQUARE)),
    "npz": ("npz", files.npz(files.SQUARE)),
    "las": ("las", files.las(files.SQUARE)),
    "laz": ("laz", files.las(files.SQUARE, compressed=True)),
}

_words = st.sampled_from([b"-1", b"4294967295", b"9" * 20, b"nan", b"1e999", b"\n", b" ", b"0"])
_octets = st.binary(min_size=1, max_size=8) | st.sampled_from([b"\xff" * 4, b"\0" * 4, b"\xff" * 8])
_damage = st.tuples(st.floats(0, 1), st.integers(0, 12), _words | _octets | st.just(b""))


@pytest.mark.parametrize("form", SOUND)
@settings(max_examples=40)
@given(damages=st.lists(_damage, min_size=1, max_size=3))
def test_damage(form: str, damages: list[tuple[float, int, bytes]]):
    ending, content = SOUND[form]
    for where, cut, new in damages:
        at = int(where * len(content))
        content = content[:at] + new + content[at + cut :]
    with TemporaryDirectory() as folder:
        path = Path(folder) / f"scan.{ending}"
        path.write_bytes(content)
        try:
            surface = read_surface(path)
        except InputError as error:
            surface, fault = None, str(error)
    if surface is None:
        assert fault.startswith(f"{path}: ")
        assert "\n" not in fault
        return
    assert np.isfinite(surface.points).all()
    assert len(surface.points) >= 3
    if surface.faces is not None:
        assert surface.faces.min() >= 0
        assert surface.faces.max() < len(surface.points)
    assert facts_of(surface).nodes == len(surface.points)
