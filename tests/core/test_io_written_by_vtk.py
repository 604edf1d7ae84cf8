"""Files as VTK itself writes them: every encoding, compression, width and byte order."""

from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from surfcmp_core.errors import InputError
from surfcmp_core.io import read_surface

vtk = pytest.importorskip("vtkmodules.all")

NODES = [(0, 0, 0), (1, 0, 0.5), (1, 1, 1e6 + 0.125), (0, 1, 0.1), (2, 0, -1), (2, 1, 3)]


def _mesh(strip: bool) -> Any:
    """Give a quadrilateral and a triangle, or a strip of three, and a line and a vertex."""
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for node in NODES:
        points.InsertNextPoint(node)
    points.GetData().GetRange(-1)  # a range once asked for is written as metadata
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(points)
    for cells, add in (
        ([[4]], mesh.SetVerts),
        ([[0, 5]], mesh.SetLines),
        ([] if strip else [[0, 1, 2, 3], [1, 4, 2]], mesh.SetPolys),
        ([[0, 1, 3, 2, 5]] if strip else [], mesh.SetStrips),
    ):
        array = vtk.vtkCellArray()
        for cell in cells:
            array.InsertNextCell(len(cell), cell)
        if cells == [[4]]:  # corners kept as vtkIdType are written as such
            offsets, corners = vtk.vtkIdTypeArray(), vtk.vtkIdTypeArray()
            for value in (0, 1):
                offsets.InsertNextValue(value)
            corners.InsertNextValue(4)
            array.SetData(offsets, corners)
        add(array)
    values = vtk.vtkFloatArray()
    values.SetName("values")
    for i in range(len(NODES)):
        values.InsertNextValue(i)
    mesh.GetPointData().SetScalars(values)
    field = vtk.vtkDoubleArray()
    field.SetName("time")
    field.InsertNextValue(10)
    mesh.GetFieldData().AddArray(field)
    return mesh


def _check(path: Path, strip: bool) -> None:
    surface = read_surface(path)
    assert surface.faces is not None
    assert surface.points.tolist() == [list(node) for node in np.array(NODES, float)]
    expected = [[0, 1, 3], [3, 1, 2], [3, 2, 5]] if strip else [[0, 1, 2], [0, 2, 3], [1, 4, 2]]
    rolled = sorted(np.roll(face, -int(face.argmin())).tolist() for face in surface.faces)
    assert rolled == sorted(np.roll(face, -int(np.argmin(face))).tolist() for face in expected)
    assert surface.changed == ({} if strip else {"polygons split into triangles": 1})


@pytest.mark.parametrize("strip", [False, True])
@pytest.mark.parametrize("compressor", ["None", "ZLib", "LZMA"])
@pytest.mark.parametrize("mode", ["Ascii", "Binary", "Appended"])
def test_vtp(mode: str, compressor: str, strip: bool, tmp_path: Path):
    for wide_head, wide_id, big, base64 in product((False, True), repeat=4):
        writer = vtk.vtkXMLPolyDataWriter()
        getattr(writer, f"SetDataModeTo{mode}")()
        getattr(writer, f"SetCompressorTypeTo{compressor}")()
        writer.SetBlockSize(64)
        writer.SetHeaderType(writer.UInt64 if wide_head else writer.UInt32)
        writer.SetIdType(writer.Int64 if wide_id else writer.Int32)
        writer.SetByteOrder(writer.BigEndian if big else writer.LittleEndian)
        writer.SetEncodeAppendedData(base64)
        writer.SetInputData(_mesh(strip))
        writer.SetFileName(str(tmp_path / "scan.vtp"))
        writer.Write()
        _check(tmp_path / "scan.vtp", strip)


@pytest.mark.parametrize("strip", [False, True])
@pytest.mark.parametrize("version", [42, 51])
@pytest.mark.parametrize("binary", [False, True])
@pytest.mark.parametrize("unstructured", [False, True])
def test_vtk(unstructured: bool, binary: bool, version: int, strip: bool, tmp_path: Path):
    data = _mesh(strip)
    writer = vtk.vtkPolyDataWriter()
    if unstructured:
        append = vtk.vtkAppendFilter()
        append.SetInputData(data)
        append.Update()
        data = append.GetOutput()
        writer = vtk.vtkUnstructuredGridWriter()
    writer.SetFileType(2 if binary else 1)
    writer.SetFileVersion(version)
    writer.SetInputData(data)
    writer.SetFileName(str(tmp_path / "scan.vtk"))
    writer.Write()
    _check(tmp_path / "scan.vtk", strip)


@pytest.mark.parametrize("binary", [False, True])
def test_solid_cells_are_counted_and_pixels_are_turned(binary: bool, tmp_path: Path):
    grid = vtk.vtkUnstructuredGrid()
    points = vtk.vtkPoints()
    for node in NODES:
        points.InsertNextPoint(node)
    grid.SetPoints(points)
    grid.InsertNextCell(vtk.VTK_TETRA, 4, [0, 1, 2, 3])
    grid.InsertNextCell(vtk.VTK_PIXEL, 4, [0, 1, 3, 2])
    writer = vtk.vtkUnstructuredGridWriter()
    writer.SetFileType(2 if binary else 1)
    writer.SetInputData(grid)
    writer.SetFileName(str(tmp_path / "scan.vtk"))
    writer.Write()
    surface = read_surface(tmp_path / "scan.vtk")
    assert surface.faces is not None
    assert surface.faces.tolist() == [[0, 1, 2], [0, 2, 3]]
    assert surface.changed["cells that are not flat polygons"] == 1


def test_image_is_refused(tmp_path: Path):
    image = vtk.vtkImageData()
    image.SetDimensions(2, 2, 2)
    writer = vtk.vtkStructuredPointsWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(tmp_path / "scan.vtk"))
    writer.Write()
    with pytest.raises(InputError, match="it holds 'STRUCTURED_POINTS', not a surface"):
        read_surface(tmp_path / "scan.vtk")
