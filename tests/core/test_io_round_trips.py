"""Every format gives back, bit for bit, the nodes and triangles that were written to it."""

import hashlib
import math
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core.io import read_surface
from tests.core import surface_files as files

Writer = Callable[..., bytes]

MESHES: dict[str, tuple[str, Writer]] = {
    "ply text": ("ply", files.ply_text),
    "ply little-endian": ("ply", files.ply_binary),
    "ply big-endian": ("ply", lambda p, f: files.ply_binary(p, f, order=">")),
    "obj": ("obj", files.obj),
    "off": ("off", files.off),
    "vtk text": ("vtk", files.vtk_text),
    "vtk binary": ("vtk", files.vtk_binary),
    "vtp text": ("vtp", files.vtp_text),
    "vtp base64": ("vtp", files.vtp_base64),
    "vtp base64, lengths apart": ("vtp", lambda p, f: files.vtp_base64(p, f, apart=True)),
    "vtp compressed": ("vtp", files.vtp_compressed),
    "vtp appended big-endian": ("vtp", files.vtp_appended),
    "vtp appended little-endian": ("vtp", lambda p, f: files.vtp_appended(p, f, order="<")),
    "npz": ("npz", files.npz),
}
CLOUDS: dict[str, tuple[str, Writer]] = {
    "xyz": ("xyz", files.xyz),
    "txt": ("txt", files.xyz),
    "csv": ("csv", files.csv),
    "npy": ("npy", files.npy),
}

finite = st.floats(allow_nan=False, allow_infinity=False)
awkward = st.sampled_from([-0.0, 5e-324, -1.7976931348623157e308, 1e6 + 1e-9, 0.1, 2.0**53 + 2])
nodes = st.lists(st.tuples(*[finite | awkward] * 3), max_size=12).map(
    lambda more: np.vstack((files.SQUARE, np.reshape(more, (-1, 3))))
)


def _read(name: str, content: bytes, unit: str | None = None):
    with TemporaryDirectory() as folder:
        path = Path(folder) / name
        path.write_bytes(content)
        return read_surface(path, unit=unit)


def _bits(values: NDArray[np.float64]) -> list[list[int]]:
    return values.view(np.int64).tolist()


@pytest.mark.parametrize("form", MESHES)
@settings(max_examples=40)
@given(points=nodes)
def test_mesh_keeps_every_bit(form: str, points: NDArray[np.float64]):
    ending, write = MESHES[form]
    surface = _read(f"scan.{ending}", write(points, files.TWO))
    assert _bits(surface.points) == _bits(points)
    assert surface.faces is not None
    assert surface.faces.dtype == np.int32
    assert surface.faces.tolist() == files.TWO.tolist()
    assert (surface.kind, surface.unit) == ("mesh", None)
    assert all("--no-data" in note for note in surface.changed)  # 1e30 far from all others


@pytest.mark.parametrize("form", CLOUDS)
@settings(max_examples=40)
@given(points=nodes)
def test_cloud_keeps_every_bit(form: str, points: NDArray[np.float64]):
    ending, write = CLOUDS[form]
    surface = _read(f"scan.{ending}", write(points))
    assert _bits(surface.points) == _bits(points)
    assert (surface.kind, surface.faces, surface.unit) == ("cloud", None, None)


@pytest.mark.parametrize("write", [files.stl_text, files.stl_binary])
@given(points=st.lists(st.tuples(*[st.floats(-(2.0**99), 2.0**99, width=32)] * 3), max_size=9))
def test_stl_merges_equal_corners_only(write: Writer, points: list[tuple[float, ...]]):
    given_points = np.vstack((files.SQUARE, np.reshape(points, (-1, 3))))
    apexes = np.arange(4, len(given_points))
    faces = np.vstack((files.TWO, np.column_stack((apexes * 0, apexes * 0 + 1, apexes))))
    surface = _read("scan.stl", write(given_points, faces))
    assert len(surface.points) == len({tuple(point) for point in given_points.tolist()})
    assert surface.faces is not None
    corners = given_points[faces]
    distinct = [len({tuple(node) for node in face}) == 3 for face in corners.tolist()]
    assert np.array_equal(surface.points[surface.faces], corners[distinct])


@pytest.mark.parametrize("compressed", [False, True])
@given(whole=st.lists(st.tuples(*[st.integers(-(2**31), 2**31 - 1)] * 3), max_size=9))
def test_las_gives_its_scaled_integers(compressed: bool, whole: list[tuple[int, ...]]):
    points = np.vstack((files.SQUARE, np.reshape(whole, (-1, 3)) / 1024))
    surface = _read("scan.laz", files.las(points, compressed=compressed))
    assert np.array_equal(surface.points, points)
    assert surface.kind == "cloud"


def test_float_ply_is_widened_not_rounded():
    points = files.SQUARE + 0.1
    surface = _read("scan.ply", files.ply_binary(points, real="f4"))
    assert np.array_equal(surface.points, points.astype(np.float32).astype(np.float64))


def test_surface_knows_its_file(tmp_path: Path):
    path = tmp_path / "Scan.PLY"
    path.write_bytes(files.ply_text(files.SQUARE))
    surface = read_surface(str(path))
    assert surface.path == path
    assert surface.name == "Scan.PLY"
    assert surface.sha256 == hashlib.sha256(path.read_bytes()).hexdigest()


@pytest.mark.parametrize(
    "text",
    [
        "0 0 0\n1 0 1\n0 1 2\n",
        "\ufeff0,0,0\r\n1,0,1\r\n0,1,2",
        "0;0;0\n1;0;1\n\n0;1;2\n\n",
        "\t0 \t 0   0 \n1 0 1\n 0 1 2",
        "x y z\n0 0 0\n1 0 1\n0 1 2\n",
        "# made by hand\n3\n0 0 0\n1 0 1\n0 1 2\n",
        "//X Y Z\n0 0 0\n1 0 1\n# half way\n0 1 2\n",
        '"id","z","x","y"\n"a, b",0,0,0\nc,1,1,0\n"d",2,0,1\n',
        "0 0 0 255 lower\n1 0 1 0 upper\n0 1 2 7 lower\n",
        "x;y;z\n0,0;0;0,00\n1,0;0;1\n0;10e-1;2,\n",
        "0,0;0;0\n1;0;1\n0;1;2\n",
        "id,Z [mm],X [mm],Y [mm]\n7,0,0,0\n8,1,1,0\n9,2,0,1\n",
        "z_mm z x y\n5 0 0 0\n5 1 1 0\n5 2 0 1\n",
    ],
)
def test_text_columns(text: str):
    surface = _read("scan.txt", text.encode())
    assert surface.points.tolist() == [[0, 0, 0], [1, 0, 1], [0, 1, 2]]


def test_utf16_text():
    surface = _read("scan.csv", "x,y,z\n0,0,0\n1,0,1\n0,1,2\n".encode("utf-16"))
    assert len(surface.points) == 3


def test_obj_corners_counted_back_and_with_texture():
    text = "v 0 0 0\nv 1 0 0 1.0\nv 1 1 0\nf -3/1 -2/2 -1/3\nv 0 1 0\nf 1//4 3//4 -1//4 # back\n"
    surface = _read("scan.obj", text.encode())
    assert surface.faces is not None
    assert surface.faces.tolist() == [[0, 1, 2], [0, 2, 3]]


def test_polygons_are_fanned_and_counted():
    text = (
        "OFF # units\n5 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n9 9 9\n"
        "4 0 1 2 3 255 0 0\n3 0 1 1\n2 0 1\n3 0 1 2\n"
    )
    surface = _read("scan.off", text.encode())
    assert surface.faces is not None
    assert sorted(surface.faces.tolist()) == [[0, 1, 2], [0, 1, 2], [0, 2, 3]]
    assert len(surface.points) == 5  # the node of no face stays
    assert surface.changed == {
        "polygons split into triangles": 1,
        "faces that name a node twice": 1,
        "faces with fewer than three corners": 1,
    }


@pytest.mark.parametrize("order", ["<", ">"])
def test_binary_ply_of_triangles_and_quadrilaterals_with_other_properties(order: str):
    real, whole = np.dtype(order + "f8"), np.dtype(order + "i4")
    form = "binary_little_endian" if order == "<" else "binary_big_endian"
    header = (
        f"ply\nformat {form} 1.0\nelement camera 1\nproperty list uchar float view\n"
        "element vertex 4\nproperty uchar red\nproperty double z\nproperty double x\n"
        "property double y\nelement face 3\nproperty short flag\n"
        "property list ushort int vertex_index\nproperty list uchar uchar colours\nend_header\n"
    ).encode()
    body = b"\x02" + bytes(8)
    for x, y, z in files.SQUARE:
        body += b"\xff" + np.array([z, x, y], real).tobytes()
    for corners, colours in (([0, 1, 2], 1), ([0, 1, 2, 3], 0), ([0, 2, 3], 2)):
        length = np.array(len(corners), order + "u2").tobytes()
        body += bytes(2) + length + np.array(corners, whole).tobytes()
        body += bytes([colours]) + bytes(colours)
    surface = _read("scan.ply", header + body)
    assert np.array_equal(surface.points, files.SQUARE)
    assert surface.faces is not None
    assert sorted(surface.faces.tolist()) == [[0, 1, 2], [0, 1, 2], [0, 2, 3], [0, 2, 3]]


def test_text_ply_with_lists_ahead_of_what_is_read():
    text = (
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty list uchar float weights\n"
        "property double x\nproperty double y\nproperty double z\nelement face 2\n"
        "property list uchar float texcoord\nproperty uchar flag\n"
        "property list uchar int vertex_indices\nend_header\n"
        "0 0 0 0\n2 9 9 1 0 0.25\n1 9 1 1 0.5\n0 0 1 -1\n"
        "2 0.5 0.5 7 3 0 1 2\n0 7 3 0 2 3\n"
    )
    surface = _read("scan.ply", text.encode())
    assert np.array_equal(surface.points, files.SQUARE)
    assert surface.faces is not None
    assert surface.faces.tolist() == files.TWO.tolist()


def test_a_mesh_left_without_triangles_is_a_cloud():
    surface = _read("scan.ply", files.ply_text(files.SQUARE, np.array([[0, 0, 1]], np.int32)))
    assert surface.kind == "cloud"
    assert surface.changed == {"faces that name a node twice": 1}


def test_huge_extents_are_not_taken_for_a_line():
    big = math.ldexp(1.0, 1023)
    points = np.array([[-big, -big, 0], [big, big, 0], [big, -big, 0]])
    assert len(_read("scan.npy", files.npy(points)).points) == 3


@pytest.mark.parametrize("kind", ["<f4", ">f8", "<i2"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_arrays_of_any_order_and_number_type(order: str, kind: str):
    points = np.arange(12.0).reshape(4, 3) ** 2
    array = np.asarray(points, kind, order=order)
    for content, name in ((files.npy(array), "scan.npy"), (files.npz(array), "scan.npz")):
        assert np.array_equal(_read(name, content).points, points)


def test_vtp_pieces_are_joined():
    def piece(height: int, kind: str, corners: str) -> str:
        points = f"0 0 {height} 1 0 {height} 1 1 {height}"
        return (
            f'<Piece NumberOfPoints="3"><Points><DataArray type="Float64">{points}</DataArray>'
            f'</Points><{kind}><DataArray type="Int32" Name="connectivity">{corners}</DataArray>'
            f'<DataArray type="Int32" Name="offsets">3</DataArray></{kind}></Piece>'
        )

    pieces = piece(0, "Polys", "0 1 2") + piece(5, "Polys", "2 0 1") + piece(9, "Strips", "1 2 0")
    text = f'<VTKFile type="PolyData"><PolyData>{pieces}</PolyData></VTKFile>'
    surface = _read("scan.vtp", text.encode())
    assert surface.points[:, 2].tolist() == [0, 0, 0, 5, 5, 5, 9, 9, 9]
    assert surface.faces is not None
    assert surface.faces.tolist() == [[0, 1, 2], [5, 3, 4], [7, 8, 6]]
