"""Units: stated by a comment, told by an array, given by the caller."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from surfcmp_core.errors import InputError
from surfcmp_core.io import read_surface
from surfcmp_core.io.units import unit_in, unit_named
from tests.core import surface_files as files

SQUARE = files.SQUARE


@pytest.mark.parametrize(
    ("comment", "unit"),
    [
        ("comment unit mm", "mm"),
        ("# Units: millimeters", "mm"),
        ("# units = Millimetre.", "mm"),
        ("# units are in cm", "cm"),
        ("comment unit: m", "m"),
        ("comment UNITS: µm", "um"),
        ("comment microns are the units: microns", "um"),
        ("# unit inch", "in"),
        ("# unit in", "in"),
        ("# unit feet", "ft"),
        ("made by United Mm", None),
        ("a unit cube", None),
        ("one unit = 1 m", "m"),
        ("units in mm or so", None),
        ("units per em", None),
    ],
)
def test_comments(comment: str, unit: str | None):
    assert unit_in(("something else", comment)) == unit


@pytest.mark.parametrize(
    ("label", "unit"),
    [
        ("mm", "mm"),
        ("~mm", "mm"),
        ("m (as in file)", "m"),
        ("metre", "m"),
        ("US survey foot", "us-ft"),
        ("ft (US survey)", "us-ft"),
        ("Foot_US", "us-ft"),
        ("foot", "ft"),
        ("arbitrary", None),
        ("degree", None),
        ("", None),
    ],
)
def test_labels(label: str, unit: str | None):
    assert unit_named(label) == unit


def _write(path: Path, content: bytes) -> Path:
    path.write_bytes(content)
    return path


@pytest.mark.parametrize(
    ("ending", "write"),
    [
        ("ply", lambda: files.ply_text(SQUARE, comment="unit cm")),
        ("obj", lambda: files.obj(SQUARE, comment="units: cm")),
        ("vtk", lambda: files.vtk_text(SQUARE, title="unit cm")),
        ("stl", lambda: files.stl_text(SQUARE).replace(b"solid test", b"solid unit cm", 1)),
        ("off", lambda: b"OFF # units: cm\n" + files.off(SQUARE)[4:]),
    ],
)
def test_a_stated_unit_is_converted(ending: str, write: Callable[[], bytes], tmp_path: Path):
    surface = read_surface(_write(tmp_path / f"scan.{ending}", write()))
    assert surface.unit == "mm"
    assert surface.changed == {"nodes converted from cm to mm": 4}
    assert sorted(surface.points.tolist()) == sorted((10 * SQUARE).tolist())


def test_millimetres_stated_are_left_alone(tmp_path: Path):
    content = files.ply_text(SQUARE + 0.1, comment="unit mm")
    surface = read_surface(_write(tmp_path / "scan.ply", content))
    assert surface.unit == "mm"
    assert surface.changed == {}
    assert np.array_equal(surface.points, SQUARE + 0.1)


def test_the_callers_unit_wins(tmp_path: Path):
    path = _write(tmp_path / "scan.ply", files.ply_text(SQUARE, comment="unit cm"))
    assert np.array_equal(read_surface(path, unit="mm").points, SQUARE)
    inches = read_surface(path, unit="in")
    assert np.array_equal(inches.points, SQUARE * 25.4)
    assert inches.unit == "mm"


def test_text_columns_tell_their_unit_and_keep_their_bits(tmp_path: Path):
    path = _write(tmp_path / "survey.xyz", b"# units: m\n" + files.xyz(SQUARE))
    assert read_surface(path).unit == "m"
    assert np.array_equal(read_surface(path).points, SQUARE)
    assert np.array_equal(read_surface(path, unit="m").points, 1000 * SQUARE)


def test_what_conversion_makes_infinite_is_refused(tmp_path: Path):
    path = _write(tmp_path / "scan.xyz", files.xyz(SQUARE * 1e308))
    with pytest.raises(InputError, match="3 of 4 nodes have coordinates that are not finite"):
        read_surface(path, unit="cm")


def test_an_unknown_unit_is_a_mistake_of_the_caller(tmp_path: Path):
    with pytest.raises(ValueError, match="'furlong': mm, cm, m, um, in, ft, us-ft are known"):
        read_surface(tmp_path / "scan.ply", unit="furlong")


@pytest.mark.parametrize(
    ("more", "unit"),
    [
        ({"unit": "cm"}, "cm"),
        ({"meta": '{"units": "m (as in file)"}'}, "m"),
        ({"meta": '{"units": "arbitrary"}'}, None),
        ({"meta": "not JSON"}, None),
        ({"meta": "[1]"}, None),
        ({}, None),
    ],
)
def test_npz_tells_its_unit_and_keeps_its_bits(
    more: dict[str, str], unit: str | None, tmp_path: Path
):
    path = _write(tmp_path / "scan.npz", files.npz(SQUARE, **more))
    assert read_surface(path).unit == unit
    assert np.array_equal(read_surface(path).points, SQUARE)
    assert np.array_equal(read_surface(path, unit="cm").points, 10 * SQUARE)


def test_what_else_an_npz_holds_does_not_matter(tmp_path: Path):
    odd = np.array({"unit": "cm"}, dtype=object)
    path = _write(tmp_path / "scan.npz", files.npz(SQUARE, meta=odd, unit=odd, other=odd))
    assert read_surface(path).unit is None


WKT = 'PROJCS["a",GEOGCS["b",UNIT["degree",0.0174532925199433]],UNIT["metre",1]'


@pytest.mark.parametrize(
    ("wkt", "unit"),
    [
        (WKT + "]", "m"),
        (WKT.replace('"metre",1', '"US survey foot",0.3048006096') + "]", "us-ft"),
        (f'COMPD_CS["c",{WKT}],VERT_CS["d",UNIT["metre",1]]]', "m"),
        (f'COMPD_CS["c",{WKT}],VERT_CS["d",UNIT["foot",0.3048]]]', None),
        ('GEOGCS["b",UNIT["degree",0.0174532925199433]]', None),
        ('PROJCRS["a",CS[Cartesian,2],LENGTHUNIT["metre",1]]', "m"),
    ],
)
def test_las_tells_its_linear_unit(wkt: str, unit: str | None, tmp_path: Path):
    surface = read_surface(_write(tmp_path / "scan.las", files.las(SQUARE, wkt=wkt)))
    assert surface.unit == unit
    assert np.array_equal(surface.points, SQUARE)


@pytest.mark.parametrize(("code", "unit"), [(9001, "m"), (9002, "ft"), (9003, "us-ft"), (1, None)])
def test_las_tells_the_unit_of_its_geotiff_keys(code: int, unit: str | None, tmp_path: Path):
    import laspy

    keys = np.array([1, 1, 0, 2, 1024, 0, 1, 1, 3076, 0, 1, code], "<u2").tobytes()
    record = laspy.VLR("LASF_Projection", 34735, record_data=keys)
    surface = read_surface(_write(tmp_path / "scan.las", files.las(SQUARE, record=record)))
    assert surface.unit == unit
