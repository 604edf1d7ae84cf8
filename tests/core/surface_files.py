"""Files of every format, as bytes, made of nodes and triangles for the tests of the readers."""

import io
import struct
import zlib
from base64 import b64encode
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]
Faces = NDArray[np.int32]

SQUARE = np.array([[0, 0, 0], [1, 0, 0.25], [1, 1, 0.5], [0, 1, -1]], np.float64)
TWO = np.array([[0, 1, 2], [0, 2, 3]], np.int32)


def _rows(values: NDArray[np.generic], separator: str = " ", start: str = "") -> str:
    lines = (start + separator.join(map(repr, row)) + "\n" for row in values.tolist())
    return "".join(lines)


def ply_text(points: Points, faces: Faces = TWO, comment: str = "") -> bytes:
    head = ply_header("ascii", len(points), len(faces), comment=comment)
    return head + (_rows(points) + _rows(faces, start="3 ")).encode()


def ply_header(
    form: str, nodes: int, faces: int, real: str = "double", comment: str = "", end: str = "\n"
) -> bytes:
    lines = ["ply", f"format {form} 1.0", *([f"comment {comment}"] if comment else [])]
    lines += [f"element vertex {nodes}", *(f"property {real} {axis}" for axis in "xyz")]
    lines += [f"element face {faces}", "property list uchar int vertex_indices", "end_header"]
    return "".join(line + end for line in lines).encode()


def ply_binary(points: Points, faces: Faces = TWO, order: str = "<", real: str = "f8") -> bytes:
    form = "binary_little_endian" if order == "<" else "binary_big_endian"
    name = {"f8": "double", "f4": "float"}[real]
    records = np.empty(len(faces), [("n", "u1"), ("corners", order + "i4", (3,))])
    records["n"], records["corners"] = 3, faces
    head = ply_header(form, len(points), len(faces), name)
    return head + points.astype(order + real).tobytes() + records.tobytes()


def obj(points: Points, faces: Faces = TWO, comment: str = "") -> bytes:
    return f"# {comment}\n{_rows(points, start='v ')}{_rows(faces + 1, start='f ')}".encode()


def off(points: Points, faces: Faces = TWO) -> bytes:
    return f"OFF\n{len(points)} {len(faces)} 0\n{_rows(points)}{_rows(faces, start='3 ')}".encode()


def stl_binary(points: Points, faces: Faces = TWO) -> bytes:
    records = np.zeros(
        len(faces), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]
    )
    records["corners"] = points[faces]
    return b"made by a test".ljust(80) + struct.pack("<I", len(faces)) + records.tobytes()


def stl_text(points: Points, faces: Faces = TWO) -> bytes:
    facets = (
        f"facet normal 0 0 1\n outer loop\n{_rows(points[corners], start='  vertex ')}"
        " endloop\nendfacet\n"
        for corners in faces
    )
    return f"solid test\n{''.join(facets)}endsolid test\n".encode()


def vtk_text(points: Points, faces: Faces = TWO, title: str = "a test") -> bytes:
    return (
        f"# vtk DataFile Version 3.0\n{title}\nASCII\nDATASET POLYDATA\n"
        f"POINTS {len(points)} double\n{_rows(points)}"
        f"POLYGONS {len(faces)} {4 * len(faces)}\n{_rows(faces, start='3 ')}"
        f"POINT_DATA {len(points)}\nSCALARS s float\nLOOKUP_TABLE default\n{'1 ' * len(points)}\n"
    ).encode()


def vtk_binary(points: Points, faces: Faces = TWO) -> bytes:
    cells = np.column_stack((np.full(len(faces), 3), faces)).astype(">i4")
    return (
        f"# vtk DataFile Version 4.2\n\nBINARY\nDATASET POLYDATA\nPOINTS {len(points)} double\n"
    ).encode() + b"".join(
        (
            points.astype(">f8").tobytes(),
            f"\nPOLYGONS {len(faces)} {cells.size}\n".encode(),
            cells.tobytes(),
            b"\n",
        )
    )


def _vtp(points: Points, faces: Faces, array: Callable[..., str], head: str, tail: bytes) -> bytes:
    ends = 3 * np.arange(1, len(faces) + 1, dtype=np.int32)
    return (
        f'<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" {head}>\n<PolyData>'
        f'<Piece NumberOfPoints="{len(points)}" NumberOfPolys="{len(faces)}">'
        f"<PointData/><Points>{array('Points', 'Float64', points)}</Points>"
        f"<Polys>{array('connectivity', 'Int32', faces)}{array('offsets', 'Int32', ends)}</Polys>"
        f"</Piece></PolyData>\n"
    ).encode() + tail + b"</VTKFile>\n"  # fmt: skip


def vtp_text(points: Points, faces: Faces = TWO) -> bytes:
    def array(name: str, kind: str, values: NDArray[np.generic]) -> str:
        text = " ".join(map(repr, values.ravel().tolist()))
        return f'<DataArray type="{kind}" Name="{name}" format="ascii">{text}</DataArray>'

    return _vtp(points, faces, array, 'byte_order="LittleEndian"', b"")


def vtp_base64(points: Points, faces: Faces = TWO, apart: bool = False) -> bytes:
    def array(name: str, kind: str, values: NDArray[np.generic]) -> str:
        length, octets = struct.pack("<I", values.nbytes), values.tobytes()
        coded = b64encode(length) + b64encode(octets) if apart else b64encode(length + octets)
        head = f'<DataArray type="{kind}" Name="{name}" format="binary">'
        return f"{head}{coded.decode()}</DataArray>"

    return _vtp(points, faces, array, 'byte_order="LittleEndian"', b"")


def vtp_compressed(points: Points, faces: Faces = TWO, block: int = 64) -> bytes:
    def array(name: str, kind: str, values: NDArray[np.generic]) -> str:
        octets = values.tobytes()
        blocks = [octets[i : i + block] for i in range(0, len(octets), block)]
        packed = [zlib.compress(one) for one in blocks]
        counts = [len(blocks), block, len(octets) % block, *map(len, packed)]
        text = b64encode(struct.pack(f"<{len(counts)}Q", *counts)) + b64encode(b"".join(packed))
        head = f'<DataArray type="{kind}" Name="{name}" format="binary">'
        return f"{head}\n  {text.decode()}\n</DataArray>"

    head = 'byte_order="LittleEndian" header_type="UInt64" compressor="vtkZLibDataCompressor"'
    return _vtp(points, faces, array, head, b"")


def vtp_appended(points: Points, faces: Faces = TWO, order: str = ">", shift: int = 0) -> bytes:
    """Raw, appended; `shift` is a lie about where the arrays stand."""
    blob = b""

    def array(name: str, kind: str, values: NDArray[np.generic]) -> str:
        nonlocal blob
        at = len(blob) + shift
        octets = values.astype(values.dtype.newbyteorder(order)).tobytes()
        blob += struct.pack(f"{order}I", len(octets)) + octets
        return f'<DataArray type="{kind}" Name="{name}" format="appended" offset="{at}"/>'

    head = f'byte_order="{"BigEndian" if order == ">" else "LittleEndian"}"'
    xml = _vtp(points, faces, array, head, b"@")
    return xml.replace(b"@", b'<AppendedData encoding="raw">\n_' + blob + b"\n</AppendedData>")


def xyz(points: Points, _faces: object = None) -> bytes:
    return _rows(points).encode()


def csv(points: Points, _faces: object = None) -> bytes:
    return ("x,y,z\n" + _rows(points, ",")).encode()


def npy(points: Points, _faces: object = None) -> bytes:
    file = io.BytesIO()
    np.save(file, points)
    return file.getvalue()


def npz(points: Points, faces: Faces = TWO, **more: object) -> bytes:
    file = io.BytesIO()
    np.savez_compressed(file, points=points, faces=faces, **more)  # type: ignore[arg-type]
    return file.getvalue()


def las(
    points: Points,
    _faces: object = None,
    compressed: bool = False,
    wkt: str = "",
    record: Any = None,
) -> bytes:
    """Nodes that are whole multiples of 1/1024, which .las holds exactly."""
    import laspy

    header = laspy.LasHeader(point_format=6 if wkt else 3, version="1.4" if wkt else "1.2")
    header.scales, header.offsets = np.full(3, 1 / 1024), np.zeros(3)
    if wkt:
        header.vlrs.append(laspy.vlrs.known.WktCoordinateSystemVlr(wkt))
    if record:
        header.vlrs.extend(record if isinstance(record, list) else [record])
    data = laspy.LasData(header)
    data.x, data.y, data.z = points.T
    file = io.BytesIO()
    data.write(file, do_compress=compressed)
    return file.getvalue()
