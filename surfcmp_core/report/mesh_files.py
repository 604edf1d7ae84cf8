"""The united triangulation as a mesh with its values: .vtp and .ply, float64 throughout."""

import base64
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.report.data_files import exact_columns
from surfcmp_core.report.record import Record

Columns = dict[str, NDArray[Any]]

_VTK_TYPES = {"f8": "Float64", "i4": "Int32", "i8": "Int64", "u1": "UInt8"}
_PLY_TYPES = {"f8": "double", "i4": "int", "u1": "uchar"}


def points_in_space(comparison: Comparison) -> NDArray[np.float64]:
    """Place the nodes of T on surface 1, and where it has no data on surface 2: (N, 3), finite."""
    z = np.where(np.isnan(comparison.z1), comparison.z2, comparison.z1)
    return np.column_stack([comparison.united.nodes, z])


def node_columns(comparison: Comparison) -> Columns:
    """Return what is known at each node of T."""
    return {"z1": comparison.z1, "z2": comparison.z2, "label": comparison.united.label}


def triangle_columns(comparison: Comparison) -> Columns:
    """Return what is known in each triangle of T."""
    return {
        "area": comparison.area,
        "mean_abs": comparison.mean_abs,
        "mean_signed": comparison.mean_signed,
        **exact_columns(comparison),
        "origin": comparison.united.origin,
        "chain": comparison.united.chain,
        "compared": comparison.compared.astype(np.uint8),
        "reason": comparison.reason,
    }


def write_vtp(comparison: Comparison, _document: Record, stream: BinaryIO) -> None:
    """Write T as VTK poly data, XML with base64 arrays."""
    triangles = comparison.united.triangles
    points = points_in_space(comparison)
    ends = np.arange(3, 3 * len(triangles) + 1, 3, dtype=np.int64)

    def line(text: str) -> None:
        stream.write(text.encode() + b"\n")

    def array(name: str, values: NDArray[Any]) -> None:
        values = np.ascontiguousarray(values)
        values = values.astype(values.dtype.newbyteorder("<"), copy=False)
        parts = f' NumberOfComponents="{values.shape[1]}"' if values.ndim == 2 else ""
        kind = _VTK_TYPES[values.dtype.str[1:]]
        stream.write(
            f'<DataArray type="{kind}" Name="{name}"{parts} format="binary">'.encode()
            + base64.b64encode(np.uint64(values.nbytes).astype("<u8").tobytes() + values.tobytes())
            + b"</DataArray>\n"
        )

    line('<?xml version="1.0"?>')
    line('<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">')
    line("<PolyData>")
    line(f'<Piece NumberOfPoints="{len(points)}" NumberOfPolys="{len(triangles)}">')
    line('<PointData Scalars="z1">')
    for name, values in node_columns(comparison).items():
        array(name, values)
    line('</PointData>\n<CellData Scalars="mean_abs">')
    for name, values in triangle_columns(comparison).items():
        array(name, values)
    line("</CellData>\n<Points>")
    array("Points", points)
    line("</Points>\n<Polys>")
    array("connectivity", triangles.ravel().astype(np.int64))
    array("offsets", ends)
    line("</Polys>\n</Piece>\n</PolyData>\n</VTKFile>")


def write_ply(comparison: Comparison, _document: Record, stream: BinaryIO) -> None:
    """Write T as binary PLY with double coordinates; values stand as further properties."""
    triangles = comparison.united.triangles
    x, y, z = points_in_space(comparison).T
    vertices = _records({"x": x, "y": y, "z": z, **node_columns(comparison)})
    head = np.empty(len(triangles), [("count", "u1"), ("nodes", "<i4", 3)])
    head["count"] = 3
    head["nodes"] = triangles
    faces = _records(triangle_columns(comparison), head)

    header = ["ply", "format binary_little_endian 1.0", "comment surfcmp: united triangulation"]
    header += [f"element vertex {len(vertices)}"]
    header += [_property(name, vertices.dtype[name]) for name in vertices.dtype.names or ()]
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices"]
    header += [_property(name, faces.dtype[name]) for name in (faces.dtype.names or ())[2:]]
    stream.write("\n".join([*header, "end_header\n"]).encode())
    stream.write(vertices.tobytes())
    stream.write(faces.tobytes())


def _property(name: str, kind: np.dtype[Any]) -> str:
    return f"property {_PLY_TYPES[kind.str[1:]]} {name}"


def _records(columns: Columns, head: NDArray[Any] | None = None) -> NDArray[Any]:
    """Put columns side by side, packed and little-endian, after those of `head`."""
    first = [] if head is None else head.dtype.descr
    kinds = [(name, values.dtype.newbyteorder("<")) for name, values in columns.items()]
    table = np.empty(len(next(iter(columns.values()))), [*first, *kinds])
    if head is not None:
        for name in head.dtype.names or ():
            table[name] = head[name]
    for name, values in columns.items():
        table[name] = values
    return table
