"""Odd and hostile files met in the wild: each is read, or refused in one line."""

from pathlib import Path

import pytest

from surfcmp_core.errors import InputError
from surfcmp_core.io import read_surface

Outcome = tuple[int, int] | str
"""Nodes and triangles, or a part of the refusal."""

NO_NODES = "holds 0 nodes"
UNKNOWN = "unknown ending"

OUTCOMES: dict[str, Outcome] = {
    "malformed/assimp/OBJ__box.obj": (8, 12),
    "malformed/assimp/OBJ__box_UTF16BE.obj": (8, 12),
    "malformed/assimp/OBJ__box_longline.obj": (8, 10),  # one face runs 234 times around
    "malformed/assimp/OBJ__box_without_lineending.obj": (8, 12),
    "malformed/assimp/OBJ__multiple_spaces.obj": (4, 1),
    "malformed/assimp/OBJ__number_formats.obj": "3 numbers expected in the row 'v 1e+2 2.e+1 3.1+e",
    "malformed/assimp/OBJ__only_a_part_of_vertexcolors.obj": (5, 3),
    "malformed/assimp/OBJ__point_cloud.obj": (3, 0),
    "malformed/assimp/OBJ__regr_3429812.obj": (4, 4),
    "malformed/assimp/OBJ__testline.obj": (8, 0),
    "malformed/assimp/OBJ__testmixed.obj": (8, 12),
    "malformed/assimp/OBJ__testpoints.obj": (8, 0),
    "malformed/assimp/OFF__Cube.off": (8, 12),
    "malformed/assimp/OFF__formatDetection": UNKNOWN,
    "malformed/assimp/OFF__invalid.off": "a polygon expected in the row '2'",
    "malformed/assimp/OutOfMemory.off": "353535235358 nodes and 6 faces declared, 14 lines found",
    "malformed/assimp/PLY__cube.ply": (8, 12),
    "malformed/assimp/PLY__cube_binary.ply": (8, 12),
    "malformed/assimp/PLY__cube_binary_header_with_RN_newline.ply": (8, 12),
    "malformed/assimp/PLY__cube_binary_starts_with_nl.ply": (8, 12),
    "malformed/assimp/PLY__float-color.ply": (3, 1),
    "malformed/assimp/PLY__issue623.ply": (24, 0),
    "malformed/assimp/PLY__payload_JVN42386607": UNKNOWN,
    "malformed/assimp/PLY__points.ply": (4, 0),
    "malformed/assimp/STL__formatDetection": UNKNOWN,
    "malformed/assimp/STL__triangle.stl": (3, 1),
    "malformed/assimp/STL__triangle_with_empty_solid.stl": (3, 1),
    "malformed/assimp/STL__triangle_with_two_solids.stl": (6, 2),
    "malformed/assimp/crash-30d6d0f7c529b3b66b4131700b7a4580cd7082df.ply": "header has no end",
    "malformed/assimp/empty.obj": "the file is empty",
    "malformed/assimp/empty.off": "the file is empty",
    "malformed/assimp/empty.ply": "the file is empty",
    "malformed/assimp/fuzzer_data__clusterfuzz-testcase-minimized-assimp_fuzzer-4751812606885888": (
        UNKNOWN
    ),
    "malformed/assimp/malformed.obj": "a face names node -1",
    "malformed/assimp/malformed2.obj": (8, 10),
    "malformed/assimp/readme.txt": "it holds no rows of numbers",
    "malformed/trimesh/empty.obj": NO_NODES,
    "malformed/trimesh/empty.ply": NO_NODES,
    "malformed/trimesh/empty.stl": NO_NODES,
    "malformed/trimesh/emptyIO__obj_empty.obj": NO_NODES,
    "malformed/trimesh/emptyIO__obj_points.obj": (8, 0),
    "malformed/trimesh/emptyIO__obj_wireframe.obj": (8, 0),
    "malformed/trimesh/emptyIO__ply_empty_ascii.ply": NO_NODES,
    "malformed/trimesh/emptyIO__ply_empty_bin.ply": NO_NODES,
    "malformed/trimesh/emptyIO__ply_empty_header.ply": "must name vertices once",
    "malformed/trimesh/emptyIO__ply_points_ascii.ply": (8, 0),
    "malformed/trimesh/emptyIO__ply_points_bin.ply": (8, 0),
    "malformed/trimesh/emptyIO__stl_empty_ascii.stl": NO_NODES,
    "malformed/trimesh/emptyIO__stl_empty_bin.stl": NO_NODES,
    "malformed/trimesh/nancolor.obj": (8, 12),
    "malformed/trimesh/points_ascii.ply": (5, 0),
    "malformed/trimesh/points_ascii_with_lists.ply": (5, 0),
    "malformed/trimesh/points_bin.ply": (5, 0),
    "malformed/trimesh/points_emptyascii.ply": "declares 12 lines of data, 13 found",
    "malformed/trimesh/points_emptyface.ply": (1024, 0),
    "pcl/cube.ply": (24, 12),
    "startin/samples.xyz": "all 4 nodes are on one line",
    "startin/samples2.xyz": (12, 0),
    "startin/samples3.xyz": (5, 0),
    "startin/samples4.xyz": (6, 0),
}

WITHOUT_ENDING: dict[str, tuple[str, Outcome]] = {
    "OFF__formatDetection": ("off", (8, 12)),
    "PLY__payload_JVN42386607": ("ply", "must name vertices once"),
    "STL__formatDetection": ("stl", (3, 1)),
    "fuzzer_data__clusterfuzz-testcase-minimized-assimp_fuzzer-4751812606885888": (
        "obj",
        "11 whole numbers expected in the row",
    ),
}


def _check(path: Path, expected: Outcome) -> None:
    if isinstance(expected, str):
        with pytest.raises(InputError) as caught:
            read_surface(path)
        message = str(caught.value)
        assert message.startswith(f"{path}: ")
        assert expected in message
        assert message.isprintable()
    else:
        surface = read_surface(path)
        found = 0 if surface.faces is None else len(surface.faces)
        assert (len(surface.points), found) == expected
        assert surface.kind == ("mesh" if expected[1] else "cloud")


def test_table_is_complete(shared: Path):
    folder = shared / "fixtures"
    files = {path for path in (folder / "malformed").rglob("*") if path.is_file()}
    files |= {*(folder / "startin").glob("*.xyz"), folder / "pcl" / "cube.ply"}
    assert {str(path.relative_to(folder)) for path in files} == set(OUTCOMES)


@pytest.mark.parametrize("name", OUTCOMES)
def test_file(name: str, shared: Path):
    _check(shared / "fixtures" / name, OUTCOMES[name])


@pytest.mark.parametrize("name", WITHOUT_ENDING)
def test_file_without_ending(name: str, shared: Path, tmp_path: Path):
    ending, expected = WITHOUT_ENDING[name]
    path = tmp_path / f"file.{ending}"
    path.write_bytes((shared / "fixtures" / "malformed" / "assimp" / name).read_bytes())
    _check(path, expected)


def test_real_scans(shared: Path):
    for path in (shared / "data").glob("*.npz"):
        surface = read_surface(path)
        assert surface.unit in ("mm", "cm", "m", "us-ft", None)
        assert all("not understood" in what for what in surface.changed)
