"""The results made for programs: to the letter, unrounded, readable by others."""

import csv
import json
import math
from dataclasses import fields, replace
from io import BytesIO, StringIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.measures import Measures
from surfcmp_core.names import one_line
from surfcmp_core.report import WRITERS, make_record
from surfcmp_core.report.data_files import json_bytes

from .two_squares import two_squares


def written(ending: str, comparison: Comparison) -> bytes:
    stream = BytesIO()
    WRITERS[ending](comparison, make_record(comparison), stream)
    return stream.getvalue()


def test_json_has_the_keys_of_schema_1_in_order() -> None:
    document = json.loads(written(".json", two_squares()))
    assert list(document) == [
        "schema",
        "program",
        "created",
        "inputs",
        "options",
        "transform",
        "alignment",
        "counts",
        "measures",
        "seconds",
        "warnings",
    ]
    assert document["schema"] == 1
    assert list(document["program"]) == ["name", "version"]
    assert list(document["inputs"][0]) == [
        "file",
        "sha256",
        "kind",
        "nodes",
        "triangles",
        "dropped",
    ]
    keys = [field.name for field in fields(Measures) if field.name != "exact"]
    assert list(document["measures"]) == keys
    assert list(document["counts"]) == [
        "nodes_1",
        "nodes_2",
        "nodes_shared",
        "triangles_1",
        "triangles_2",
        "triangles_united",
        "triangles_interface",
        "triangles_representative",
        "triangles_compared",
        "chains",
        "chains_closed",
        "chains_open",
    ]
    assert list(document["seconds"]) == [
        "read",
        "triangulate",
        "spanning_trees",
        "locate",
        "interpolate",
        "interface",
        "measures",
        "total",
    ]
    assert document["seconds"]["read"] == 0.25
    assert document["created"].endswith("Z")
    assert np.array_equal(document["transform"], np.eye(4))
    assert document["warnings"] == ["units are not stated: taken as mm"]


def test_json_tells_what_was_read_and_dropped() -> None:
    comparison = two_squares()
    grids = (replace(comparison.grids[0], merged=3), comparison.grids[1])
    first, second = make_record(replace(comparison, grids=grids))["inputs"]
    assert first == {
        "file": "a.ply",
        "sha256": "1" * 64,
        "kind": "mesh",
        "nodes": 4 + 2 + 3,
        "triangles": 2,
        "dropped": {"not finite": 2, "merged": 3},
    }
    assert (second["kind"], second["triangles"], second["dropped"]) == ("cloud", 0, {})


def test_json_is_strict_where_numbers_are_not_finite() -> None:
    comparison = two_squares()
    text = written(".json", comparison).decode()

    def refuse(word: str) -> None:
        raise AssertionError(f"{word} is not JSON")

    document = json.loads(text, parse_constant=refuse)
    assert document["measures"]["mean_abs_interface"] is None
    assert document["options"]["max_edge_used"] == [None, 1.5]


def test_options_are_all_there_as_used() -> None:
    comparison = two_squares()
    options = make_record(comparison)["options"]
    assert set(options) >= {field.name for field in fields(comparison.options)} - {"verify"}
    assert (options["align"], options["weight"]) == ("none", None)
    assert (options["max_edge"], options["max_edge_derived"]) == (None, True)
    meshes = replace(comparison, max_edges=(math.inf, math.inf))
    assert make_record(meshes)["options"]["max_edge_derived"] is False
    limitless = replace(comparison, options=replace(comparison.options, max_edge=math.inf))
    options = make_record(limitless)["options"]
    assert (options["max_edge"], options["max_edge_derived"]) == (None, False)


def test_json_takes_names_that_are_not_text() -> None:
    comparison = two_squares()
    odd = replace(comparison.surfaces[0], path=Path("scan\udcff\n\x1b[1m.ply"))
    comparison = replace(comparison, surfaces=(odd, comparison.surfaces[1]))
    document = json.loads(json_bytes(make_record(comparison)))
    assert document["inputs"][0]["file"] == "scan��[1m.ply".replace("[", "�[")
    assert one_line("größe.ply") == "größe.ply"


def test_npz_has_exactly_the_arrays_and_types_of_the_contract() -> None:
    comparison = two_squares()
    arrays = np.load(BytesIO(written(".npz", comparison)))
    kinds = {name: (arrays[name].dtype.name, arrays[name].shape) for name in arrays.files}
    assert kinds == {
        "nodes": ("float64", (5, 2)),
        "label": ("uint8", (5,)),
        "z1": ("float64", (5,)),
        "z2": ("float64", (5,)),
        "triangles": ("int32", (4, 3)),
        "origin": ("uint8", (4,)),
        "chain": ("int32", (4,)),
        "chain_closed": ("bool", (0,)),
        "compared": ("bool", (4,)),
        "area": ("float64", (4,)),
        "mean_abs": ("float64", (4,)),
        "mean_signed": ("float64", (4,)),
        "tree1": ("int32", (3, 2)),
        "tree2": ("int32", (4, 2)),
    }
    assert np.array_equal(arrays["nodes"], comparison.united.nodes)
    assert np.array_equal(arrays["z1"], comparison.z1, equal_nan=True)
    assert np.array_equal(arrays["compared"], [True, True, True, False])
    assert np.isnan(arrays["area"][3])


def test_csv_has_a_row_for_each_triangle() -> None:
    rows = list(csv.reader(StringIO(written(".csv", two_squares()).decode())))
    assert rows[0] == [
        "x",
        "y",
        "area",
        "mean_abs",
        "mean_signed",
        "origin",
        "chain",
        "compared",
        "reason",
    ]
    assert len(rows) == 5
    assert rows[1] == ["0.5", repr(0.5 / 3), "0.25", "1.0", "1.0", "2", "-1", "1", "compared"]
    assert rows[4][2:] == ["", "", "", "2", "-1", "0", "hole"]


def test_ply_keeps_every_bit_and_value() -> None:
    import trimesh

    comparison = two_squares()
    far = comparison.united.nodes + np.array([4.5e5 + 1e-9, 0.1])
    comparison = replace(comparison, united=replace(comparison.united, nodes=far))
    data = written(".ply", comparison)
    mesh: Any = trimesh.load(BytesIO(data), file_type="ply", process=False)
    assert np.array_equal(mesh.vertices[:, :2], far)
    assert np.array_equal(mesh.vertices[:, 2], np.zeros(5))  # where 1 has no data: on 2
    assert np.array_equal(mesh.faces, comparison.united.triangles)
    raw = mesh.metadata["_ply_raw"]
    assert np.array_equal(raw["vertex"]["data"]["z2"].ravel(), comparison.z2)
    assert np.array_equal(raw["face"]["data"]["reason"].ravel(), comparison.reason)


@pytest.mark.parametrize("ending", [".vtp", ".ply"])
def test_meshes_are_read_back_by_our_own_readers(ending: str, tmp_path: Path) -> None:
    from surfcmp_core import read_surface

    comparison = two_squares()
    path = tmp_path / f"t{ending}"
    path.write_bytes(written(ending, comparison))
    surface = read_surface(path)
    assert np.array_equal(surface.points[:, :2], comparison.united.nodes)
    assert surface.faces is not None
    assert np.array_equal(surface.faces, comparison.united.triangles)


def test_vtp_is_read_by_vtk(tmp_path: Path) -> None:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    comparison = two_squares()
    path = tmp_path / "t.vtp"
    path.write_bytes(written(".vtp", comparison))
    reader = vtkXMLPolyDataReader(file_name=str(path))
    reader.Update()
    mesh = reader.GetOutput()

    def array(data: Any, name: str) -> Any:
        return vtk_to_numpy(data.GetAbstractArray(name))  # type: ignore[no-untyped-call]

    points = vtk_to_numpy(mesh.GetPoints().GetData())  # type: ignore[no-untyped-call]
    assert points.dtype == np.float64
    assert np.array_equal(points[:, :2], comparison.united.nodes)
    corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())  # type: ignore[no-untyped-call]
    assert np.array_equal(corners.reshape(-1, 3), comparison.united.triangles)
    nodes, triangles = mesh.GetPointData(), mesh.GetCellData()
    assert np.array_equal(array(nodes, "z1"), comparison.z1, equal_nan=True)
    assert np.array_equal(array(nodes, "label"), comparison.united.label)
    assert np.array_equal(array(triangles, "mean_abs"), comparison.mean_abs, equal_nan=True)
    assert np.array_equal(array(triangles, "chain"), comparison.united.chain)
    assert np.array_equal(array(triangles, "compared"), comparison.compared)


def test_exact_values_stand_beside_the_nodal_ones_where_there_are_any() -> None:
    comparison = two_squares()
    exact = np.array([0.25, 0.5, 0.75, np.nan])
    comparison = replace(comparison, mean_abs_exact=exact, mean_signed_exact=-exact)
    arrays = np.load(BytesIO(written(".npz", comparison)))
    assert np.array_equal(arrays["mean_abs_exact"], exact, equal_nan=True)
    assert np.array_equal(arrays["mean_signed_exact"], -exact, equal_nan=True)
    row = next(csv.DictReader(StringIO(written(".csv", comparison).decode())))
    assert (row["mean_abs_exact"], row["mean_signed_exact"]) == ("0.25", "-0.25")
    for ending in (".vtp", ".ply"):
        assert b"mean_signed_exact" in written(ending, comparison)
