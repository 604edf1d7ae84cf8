"""Spellings of mesh files that programs really write, and words for those that are not read."""

from pathlib import Path

import numpy as np
import pytest

from surfcmp_core.errors import InputError
from surfcmp_core.io import read_surface
from surfcmp_core.surface import Surface
from tests.core import surface_files as files

REPORTS = Path(__file__).parent / "fixtures" / "reports"
SQUARE, TWO = files.SQUARE, files.TWO


def _read(folder: Path, ending: str, content: bytes) -> Surface:
    path = folder / f"scan.{ending}"
    path.write_bytes(content)
    return read_surface(path)


def _refusal(folder: Path, ending: str, content: bytes) -> str:
    with pytest.raises(InputError) as caught:
        _read(folder, ending, content)
    message = str(caught.value)
    assert message.startswith(f"{folder / 'scan'}.{ending}: ")
    assert "\n" not in message
    return message.partition(": ")[2]


def _is_square(surface: Surface) -> bool:
    return (
        np.array_equal(surface.points, SQUARE)
        and surface.faces is not None
        and np.array_equal(surface.faces, TWO)
    )


REPORTED = (
    "ncoff.off", "cstoff.off", "off_glued_counts.off", "field_string.vtk",
    "ascii_bom.stl", "ascii_trailing_nul.stl",
)  # fmt: skip


@pytest.mark.parametrize("name", REPORTED)
def test_reported_files_hold_the_flat_mesh(name: str) -> None:
    found, flat = read_surface(REPORTS / name), read_surface(REPORTS / "flat1.ply")
    assert found.faces is not None
    assert flat.faces is not None
    assert sorted(map(tuple, found.points[found.faces].reshape(-1, 9).tolist())) == sorted(
        map(tuple, flat.points[flat.faces].reshape(-1, 9).tolist())
    )


def test_a_reported_free_form_surface_is_refused() -> None:
    with pytest.raises(InputError, match="holds a free-form surface \\('cstype'\\)"):
        read_surface(REPORTS / "nurbs_only.obj")


ROWS = files.off(SQUARE).split(b"\n", 2)[2]
OFFS = {
    **{
        mark: (mark + "OFF\n4 2 0\n").encode() + ROWS
        for mark in ("C", "N", "ST", "CN", "NC", "STC", "CST", "STCN", "NCST", "CNST")
    },
    "lower case": b"off\n4 2 0\n" + ROWS,
    "counts on the first line": b"COFF 4 2 0\n" + ROWS,
    "counts glued to the word": b"OFF4 2 0\n" + ROWS,
    "counts of two": b"OFF\n4 2\n" + ROWS,
    "comments": b"# one\nOFF # two\n# 3\n\n4 2 0 # four\n# 5\n" + ROWS.replace(b"\n", b" # 6\n"),
    "blanks ahead": b"\n  OFF\r\n4 2 0\r\n" + ROWS.replace(b"\n", b"\r\n"),
    "a byte-order mark": b"\xef\xbb\xbfOFF\n4 2 0\n" + ROWS,
    "UTF-16": (b"OFF\n4 2 0\n" + ROWS).decode().encode("utf-16"),
}  # fmt: skip


@pytest.mark.parametrize("spelling", OFFS)
def test_spellings_of_off(spelling: str, tmp_path: Path) -> None:
    assert _is_square(_read(tmp_path, "off", OFFS[spelling]))


@pytest.mark.parametrize("head", ["4OFF", "nOFF", "4nOFF", "ST4OFF", "C4nOFF"])
def test_off_of_other_dimensions_is_refused(head: str, tmp_path: Path) -> None:
    content = f"{head}\n4 2 0\n".encode() + ROWS
    assert f"begins with '{head}'" in _refusal(tmp_path, "off", content)


def test_binary_off_is_refused_by_name(tmp_path: Path) -> None:
    assert "'OFF BINARY'" in _refusal(tmp_path, "off", b"OFF BINARY\n\0\0\0\4\0\0\0\2\0\0\0\0")
    assert "'OFF BINARY'" in _refusal(tmp_path, "off", b"COFF BINARY\n\0\0\0\4\0\0\0\2\0\0\0\0")


FIELDS_IN_TEXT = {
    "string": "string\none%20two\n\nthree words here\n",
    "variant": "variant\n6 3\n13 s%20t\n13 \n",
    "bit": "bit\n1 0 1 ",
    "a type of tomorrow": "float8\n1 2 3\n",
}


@pytest.mark.parametrize("kind", FIELDS_IN_TEXT)
def test_text_vtk_passes_fields_of_any_type(kind: str, tmp_path: Path) -> None:
    field = f"FIELD FieldData 2\nnotes%20here 1 3 {FIELDS_IN_TEXT[kind]}\nmore 2 1 int\n7 8\n"
    content = files.vtk_text(SQUARE).replace(b"POINTS", field.encode() + b"POINTS")
    assert _is_square(_read(tmp_path, "vtk", content))


LONG = b"y" * 10_000
FIELDS_IN_BINARY = {
    "string": b"string\n\xc3one\xc0" + bytes((0x80 | len(LONG) >> 8, len(LONG) & 255)) + LONG,
    "variant": b"variant\n6 3\n13 s%20t\n13 \n",
    "bit": b"bit\n\xa0",
    "vtktypeuint64": b"vtktypeuint64\n" + bytes(24),
}


@pytest.mark.parametrize("kind", FIELDS_IN_BINARY)
def test_binary_vtk_passes_fields_of_any_type(kind: str, tmp_path: Path) -> None:
    field = b"FIELD FieldData 1\nnotes 1 3 " + FIELDS_IN_BINARY[kind] + b"\n"
    content = files.vtk_binary(SQUARE).replace(b"POINTS", field + b"POINTS")
    assert _is_square(_read(tmp_path, "vtk", content))


def test_strings_that_reach_beyond_the_file_are_refused(tmp_path: Path) -> None:
    field = b"FIELD FieldData 1\nnotes 1 1 string\n\x3f" + b"\xff" * 7
    content = files.vtk_binary(SQUARE).replace(b"POINTS", field + b"POINTS")
    assert "room" in _refusal(tmp_path, "vtk", content)
    content = content.replace(b"1 1 string", b"1 99999999 string")
    assert "99999999 values declared" in _refusal(tmp_path, "vtk", content)


TEXT_STL, BINARY_STL = files.stl_text(SQUARE), files.stl_binary(SQUARE)
STLS = {
    "a byte-order mark": b"\xef\xbb\xbf" + TEXT_STL,
    "NULs behind": TEXT_STL + bytes(9),
    "UTF-16": TEXT_STL.decode().encode("utf-16"),
    "capitals": TEXT_STL.upper(),
    "no name": TEXT_STL.replace(b"solid test", b"solid"),
    "lone carriage returns": TEXT_STL.replace(b"\n", b"\r"),
    "binary that begins with solid": b"solid" + BINARY_STL[5:],
    "binary with NULs behind": BINARY_STL + bytes(16),
    "binary, solid, with a line end behind": b"solid" + BINARY_STL[5:] + b"\r\n",
}


@pytest.mark.parametrize("spelling", STLS)
def test_spellings_of_stl(spelling: str, tmp_path: Path) -> None:
    surface = _read(tmp_path, "stl", STLS[spelling])
    assert surface.faces is not None
    assert sorted(map(tuple, surface.points.tolist())) == sorted(map(tuple, SQUARE.tolist()))
    assert np.array_equal(surface.points[surface.faces], SQUARE[TWO])


def test_what_is_wrong_with_an_stl_is_true(tmp_path: Path) -> None:
    message = _refusal(tmp_path, "stl", b"solid" + BINARY_STL[5:-7])
    assert message.startswith("no facet follows its first line; read as binary, 2 triangles")
    assert "take 184 bytes; the file has 177" in message
    assert _refusal(tmp_path, "stl", BINARY_STL[:-7]).startswith("2 triangles declared in its bin")
    assert "2 facets with 5 corners" in _refusal(
        tmp_path, "stl", TEXT_STL.replace(b"  vertex", b"", 1) + bytes(3)
    )


OBJ = files.obj(SQUARE)
OBJS = {
    "corners counted back": OBJ.replace(b"f 1 2 3", b"f -4 -3 -2"),
    "textures and normals": OBJ.replace(b"f 1 2 3", b"f 1/1/1 2/1/1 3/1/1"),
    "normals": OBJ.replace(b"f 1 2 3", b"f 1//1 2//1 3//1"),
    "a line continued": OBJ.replace(b"f 1 2 3", b"f 1 \\\n2 \\\r\n 3"),
    "colours of nodes": OBJ.replace(b"v 0.0 0.0 0.0", b"v 0.0 0.0 0.0 0.5 0.25 1"),
    "lines and points": OBJ + b"l 1 2 3\np 4\n",
    "words of comment": b"# surf, curv and cstype are words\n" + OBJ,
    "names of groups": b"g surf cstype\no curv\nusemtl surf\n" + OBJ,
}


@pytest.mark.parametrize("spelling", OBJS)
def test_spellings_of_obj(spelling: str, tmp_path: Path) -> None:
    assert _is_square(_read(tmp_path, "obj", OBJS[spelling]))


@pytest.mark.parametrize(
    "statement", ["cstype bezier", "surf 0 1 0 1 1 2 3 4", " curv 0 1 1 2", "bsp 1 2"]
)
def test_free_form_statements_are_refused(statement: str, tmp_path: Path) -> None:
    message = _refusal(tmp_path, "obj", OBJ + f"{statement}\n".encode())
    assert f"free-form surface ({statement.split()[0]!r})" in message


OTHERS = {
    "stl": ("a text .stl file", TEXT_STL),
    "binary stl": ("a binary .stl file", BINARY_STL),
    "ply": ("a .ply file", files.ply_binary(SQUARE)),
    "obj": ("an .obj file", b"# from a scanner\nmtllib a.mtl\n\no face\n" + OBJ),
    "off": ("an .off file", files.off(SQUARE)),
    "vtk": ("a .vtk file", files.vtk_text(SQUARE)),
    "vtp": ("a .vtp file", files.vtp_text(SQUARE)),
    "npy": ("a .npy file", files.npy(SQUARE)),
    "npz": ("a ZIP archive, such as .npz", files.npz(SQUARE)),
    "las": ("a .las or .laz file", files.las(SQUARE)),
    "gzip": ("a file packed by gzip", b"\x1f\x8b\x08\0" + bytes(range(99))),
    "page": ("a page of the web", b"<!DOCTYPE html><html><body>404</body></html>"),
    "picture": ("a picture", b"\x89PNG\r\n\x1a\n" + bytes(99)),
}


@pytest.mark.parametrize("ending", ["ply", "obj", "stl", "off", "vtp", "vtk", "npy", "npz", "las"])
@pytest.mark.parametrize("other", OTHERS)
def test_a_wrong_ending_is_told(other: str, ending: str, tmp_path: Path) -> None:
    like, content = OTHERS[other]
    if f".{ending}" in like:
        return
    assert f"; it looks like {like}" in _refusal(tmp_path, ending, content)
