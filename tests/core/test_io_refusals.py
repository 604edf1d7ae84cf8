"""What cannot be believed is refused in one line that names the file, without a large memory."""

import io
import os
import struct
import tracemalloc
from pathlib import Path

import numpy as np
import pytest

from surfcmp_core.errors import InputError
from surfcmp_core.io import read_surface
from tests.core import surface_files as files

SQUARE, TWO = files.SQUARE, files.TWO


def _refusal(path: Path) -> str:
    with pytest.raises(InputError) as caught:
        read_surface(path)
    message = str(caught.value)
    assert message.startswith(f"{path}: ")
    assert "\n" not in message
    return message.removeprefix(f"{path}: ")


def _npy_claiming(shape: tuple[int, ...]) -> bytes:
    file = io.BytesIO()
    np.lib.format.write_array_header_1_0(
        file, {"descr": "<f8", "fortran_order": False, "shape": shape}
    )
    return file.getvalue() + bytes(72)


def _saved(array: np.ndarray) -> bytes:
    file = io.BytesIO()
    np.save(file, array, allow_pickle=True)
    return file.getvalue()


def _replaced(content: bytes, old: bytes, new: bytes) -> bytes:
    assert old in content
    return content.replace(old, new, 1)


_HEADER = files.ply_header("ascii", 4, 0)
_LAS = files.las(SQUARE)
_LAZ = files.las(SQUARE, compressed=True)
_STL = files.stl_binary(SQUARE)

LIES: dict[str, tuple[str, bytes, str]] = {
    "ply text, nodes": ("ply", files.ply_header("ascii", 4_000_000_000, 0) + b"0 0 0\n", "1 found"),
    "ply binary, nodes": (
        "ply",
        files.ply_header("binary_little_endian", 4_000_000_000, 0) + bytes(72),
        "more than the file has room for",
    ),
    "ply binary, corners": (
        "ply",
        files.ply_header("binary_big_endian", 3, 1) + SQUARE[:3].astype(">f8").tobytes()
        + b"\xff" + bytes(12),
        "beyond the end",
    ),
    "ply, fewer nodes than found": ("ply", _HEADER + files.xyz(SQUARE) + b"1 1 1\n", "5 found"),
    "ply binary, more bytes": ("ply", files.ply_binary(SQUARE) + b"more", "4 bytes found after"),
    "ply, nodes below zero": ("ply", _replaced(_HEADER, b"vertex 4", b"vertex -4"), "vertex -4"),
    "off": ("off", _replaced(files.off(SQUARE), b"4 2", b"4000000000 2"), "4000000000 nodes"),
    "off, fewer": ("off", _replaced(files.off(SQUARE), b"4 2", b"3 2"), "6 lines found"),
    "stl": ("stl", _STL[:80] + struct.pack("<I", 4_000_000_000) + _STL[84:], "file has 184"),
    "stl, fewer": ("stl", _STL[:80] + struct.pack("<I", 1) + _STL[84:], "take 134 bytes"),
    "stl text, cut off": ("stl", files.stl_text(SQUARE)[:-60], "facets with"),
    "npy": ("npy", _npy_claiming((4_000_000_000, 3)), "room"),
    "npy, product beyond 64 bits": ("npy", _npy_claiming((2**62, 2**62)), "room"),
    "vtk": ("vtk", _replaced(files.vtk_text(SQUARE), b"S 4 ", b"S 4000000000 "), "room"),
    "vtk binary": ("vtk", _replaced(files.vtk_binary(SQUARE), b"S 4 ", b"S 4000000000 "), "room"),
    "vtk, polygons": ("vtk", _replaced(files.vtk_text(SQUARE), b"NS 2 8", b"NS 9 8"), "2 found"),
    "vtp, offset": ("vtp", files.vtp_appended(SQUARE, shift=10**9), "beyond the file's end"),
    "vtp, count": (
        "vtp",
        _replaced(files.vtp_text(SQUARE), b'Points="4"', b'Points="40"'),
        "40 points declared, 4 found",
    ),
    "vtp, length": (
        "vtp",
        _replaced(files.vtp_appended(SQUARE), b"_\0\0\0\x60", b"_\xff\xff\xff\xff"),
        "beyond the file's end",
    ),
    "las": ("las", _LAS[:107] + struct.pack("<I", 4_000_000_000) + _LAS[111:], "room for 4"),
    "las, records": ("las", _LAS[:100] + b"\xff\xff\xff\xff" + _LAS[104:], "room"),
    "laz, points": ("laz", _LAZ[:107] + struct.pack("<I", 4_000_000_000) + _LAZ[111:], "into 78"),
    "laz, cut off": ("laz", _LAZ[:-20], "cut off"),
}  # fmt: skip


@pytest.mark.parametrize("lie", LIES)
def test_lying_headers_cost_nothing(lie: str, tmp_path: Path):
    ending, content, fragment = LIES[lie]
    path = tmp_path / f"lie.{ending}"
    path.write_bytes(content)
    if ending in ("las", "laz"):
        import laspy  # noqa: F401 - not to be counted
    tracemalloc.start()
    try:
        assert fragment in _refusal(path)
        assert tracemalloc.get_traced_memory()[1] < 200 << 20
    finally:
        tracemalloc.stop()


def test_laz_chunk_table_is_checked_before_it_aborts(tmp_path: Path):
    path = tmp_path / "lie.laz"
    start = int.from_bytes(_LAZ[96:100], "little")
    table = int.from_bytes(_LAZ[start : start + 8], "little")
    path.write_bytes(_LAZ[: table + 4] + b"\xff\xff\xff\xff" + _LAZ[table + 8 :])
    assert "compressed chunks" in _refusal(path)


def test_laz_without_items_is_refused_before_it_panics(tmp_path: Path):
    path = tmp_path / "lie.laz"
    items = _LAZ.index(b"laszip encoded") - 2 + 54 + 32
    path.write_bytes(_LAZ[:items] + b"\0\0" + _LAZ[items + 2 :])
    assert "how its points are compressed" in _refusal(path)


CONTENTS: dict[str, tuple[str, bytes, str]] = {
    "empty": ("ply", b"", "empty"),
    "nothing but blanks": ("xyz", b"  \n\n", "no rows"),
    "nothing but a header": ("csv", b"x,y,z\n", "no rows"),
    "two columns": ("xyz", b"1 2\n3 4\n5 6\n", "three columns or more expected, 2 in"),
    "short row": ("xyz", b"0 0 0\n1 0 0\n1 1\n0 1 0\n", "3 columns, x, y and z numbers"),
    "long row": ("csv", b"0,0,0\n1,0,0\n1,1,0,7\n", "'1,1,0,7'"),
    "first row damaged": ("xyz", b"0x 0 0\n0 0 0\n1 0 0\n1 1 0\n", "'0x 0 0'"),
    "commas in a table of commas": ("csv", b"1,5,2,5,3,5\n1,0,2,5,3\n", "6 columns"),
    "word": ("txt", b"0 0 0\n1 0 0\n1 ? 0\n", "'1 ? 0'"),
    "fewer rows than it says": ("xyz", b"4\n0 0 0\n1 0 0\n1 1 1\n", "4 rows declared, 3 found"),
    "nan": ("xyz", b"0 0 0\n1 0 nan\n1 1 0\ninf 0 0\n", "2 of 4 nodes"),
    "too large for a float": ("obj", b"v 0 0 0\nv 1 0 0\nv 0 1 1e999\n", "1 of 3 nodes"),
    "two nodes": ("xyz", b"0 0 0\n1 1 1\n", "holds 2 nodes"),
    "one place": ("xyz", b"1 2 3\n" * 5, "all 5 nodes are at one place"),
    "one line": ("xyz", b"0 0 0\n.1 .1 .1\n.3 .3 .3\n.7 .7 .7\n", "all 4 nodes are on one line"),
    "node beyond": ("off", files.off(SQUARE, TWO + 1), "names node 4"),
    "node below": ("npz", files.npz(SQUARE, TWO - 1), "names node -1"),
    "obj node 0": ("obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "names node -1"),
    "not an archive": ("npz", b"PK\3\4 or so", "not an .npz"),
    "no points": ("npz", files.npz(SQUARE).replace(b"points", b"nodes_"), "only nodes_, faces"),
    "flat points": ("npy", _saved(np.zeros(12)), "(12,) float64"),
    "four columns": ("npy", _saved(np.zeros((12, 4))), "(12, 4) float64"),
    "complex points": ("npy", _saved(np.zeros((12, 3), complex)), "complex128"),
    "real faces": ("npz", files.npz(SQUARE, TWO.astype(float)), "faces must be (m, 3)"),
    "pickle": ("npy", _saved(np.array([{}, None])), "pickled"),
    "not a ply": ("ply", b"solid x\nendsolid x\n", "'ply'"),
    "ply without x": ("ply", files.ply_text(SQUARE).replace(b"double x", b"double w"), "x, y, z"),
    "ply with other faces": (
        "ply", files.ply_text(SQUARE).replace(b"_indices", b"_numbers"), "no list vertex_indices"
    ),
    "ply with strips": ("ply", files.ply_text(SQUARE).replace(b"face", b"tristrips"), "strips"),
    "ply of unknown type": ("ply", files.ply_text(SQUARE).replace(b"double", b"quad"), "quad x"),
    "not an off": ("off", b"4OFF\n", "'OFF'"),
    "off counts": ("off", b"OFF\nmany few\n", "'many few'"),
    "not a vtk": ("vtk", b"hello", "legacy VTK"),
    "volume": ("vtk", files.vtk_text(SQUARE).replace(b"POLYDATA", b"RECTILINEAR_GRID"), "not a su"),
    "not xml": ("vtp", b"hello", "XML is damaged"),
    "entities": ("vtp", b"<!DOCTYPE a [<!ENTITY b 'b'>]><VTKFile/>", "document type"),
    "other xml": ("vtp", b"<VTKFile type='ImageData'/>", "'ImageData', not PolyData"),
    "lz4": ("vtp", files.vtp_compressed(SQUARE).replace(b"ZLib", b"LZ4"), "LZ4DataCompressor"),
    "damaged block": (
        "vtp",
        files.vtp_compressed(SQUARE, block=1 << 20).replace(b"eJ", b"AA"),
        "damaged or not a .vtp file",
    ),
    "not a las": ("las", b"LASF or not", "LAS header"),
}  # fmt: skip


@pytest.mark.parametrize("fault", CONTENTS)
def test_contents(fault: str, tmp_path: Path):
    ending, content, fragment = CONTENTS[fault]
    path = tmp_path / f"scan.{ending}"
    path.write_bytes(content)
    assert fragment in _refusal(path)


def test_unknown_ending_lists_the_known(tmp_path: Path):
    message = _refusal(tmp_path / "scan.dcm")
    assert "'.dcm'" in message
    assert ".ply .obj .stl .off .vtp .vtk .xyz .txt .csv .npy .npz .las .laz" in message


def test_places_that_are_no_file(tmp_path: Path):
    folder = tmp_path / "folder.ply"
    folder.mkdir()
    pipe = tmp_path / "pipe.ply"
    os.mkfifo(pipe)  # opening it would wait for ever
    assert "folder" in _refusal(folder)
    assert "regular" in _refusal(pipe)
    assert "no such file" in _refusal(tmp_path / "none.ply")


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read every file")
def test_unreadable_file(tmp_path: Path):
    path = tmp_path / "secret.ply"
    path.write_bytes(files.ply_text(SQUARE))
    path.chmod(0)
    assert "cannot be read: Permission denied" in _refusal(path)
