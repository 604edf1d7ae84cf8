"""Units: stated by a comment, told by an array, given by the caller."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from surfcmp_core.errors import InputError
from surfcmp_core.io import read_surface
from surfcmp_core.io.stated_units import unit_in, unit_named
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
        ("# vertex coordinates are measured in units, where 1 unit = 1000.000000 mm", "m"),
        ("# where 1 unit = 1000,000000 mm", "m"),
        ("1 unit = 1 mm", "mm"),
        ("1 unit is 0.001 m", "mm"),
        ("1 unit = 1,000 mm", None),  # one or a thousand
        ("10 mm = 1 unit", "cm"),
        ("# File units = millimeters", "mm"),
        ("# all coordinates in meters", "m"),
        ("# coordinates [µm]", "um"),
        ("# x, y, z in cm", "cm"),
        ("# length_unit: cm", "cm"),
        ('# {"unit": "cm"}', "cm"),
        ("# unit: cm; time: s", "cm"),
        ("# Made by a program 3.2, units cm", "cm"),
        ("# units: cm (converted from inches)", "cm"),
        ("# Units: US survey feet", "us-ft"),
        ("# units: yards", "yd"),
        ("# unit km", "km"),
        ("# unit nm", "nm"),
        ("# unit thou", "mil"),
        ("# unit ìm", "um"),  # written in the code page 1253
        ("# unit Âµm", "um"),  # UTF-8 read as Latin-1 and written once more
        ("# unit \ufffdm", None),
        ("# time unit s", None),
        ("# time unit m", None),
        ("# unit m²", None),
        ("# unit m^2", None),
        ("# unit m/s", None),
        ("# unit m·s", None),
        ("# unit: mm per pixel", None),
        ("# unit 1/mm", None),
        ("# unit kg/m", None),
        ("# intensity unit: m", None),
        ("# focal length unit: cm", None),
        ("# converted from inches", None),
        ("# converted from units: inches", None),
        ("# original units: inches", None),
        ("# unit normals", None),
        ("# scale 0.001", None),
        ("# unit: furlong", None),
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
        ("m/s", None),
        ("m²", None),
        ("mm per pixel", None),
        ("m (land survey)", "m"),
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


@pytest.mark.parametrize("ending", ["ply", "obj", "vtk", "stl", "off", "xyz"])
@pytest.mark.parametrize("encoding", ["utf-8", "latin-1", "cp1253", "mac-roman", "cp850", "ascii"])
def test_no_encoding_makes_metres_of_micrometres(ending: str, encoding: str, tmp_path: Path):
    micro = "\ufffd" if encoding == "ascii" else "\xb5"  # for ascii: lost before we see it
    statement = f"unit: {micro}m"
    content = {
        "ply": files.ply_text(SQUARE, comment="unit: *m"),
        "obj": files.obj(SQUARE, comment="unit: *m"),
        "vtk": files.vtk_text(SQUARE, title="unit: *m"),
        "stl": files.stl_text(SQUARE).replace(b"solid test", b"solid unit: *m", 1),
        "off": b"OFF # unit: *m\n" + files.off(SQUARE)[4:],
        "xyz": b"# unit: *m\n" + files.xyz(SQUARE),
    }[ending]
    word = statement.encode("utf-8" if encoding == "ascii" else encoding)
    surface = read_surface(_write(tmp_path / f"s.{ending}", content.replace(b"unit: *m", word, 1)))
    extent = np.ptp(surface.points, axis=0).max()
    if encoding == "ascii":
        assert surface.unit is None
        assert any("not understood" in what for what in surface.changed)
        assert extent == np.ptp(SQUARE, axis=0).max()
    else:
        kept = ending == "xyz"
        assert surface.unit == ("um" if kept else "mm")
        assert extent == np.ptp(SQUARE if kept else SQUARE / 1000, axis=0).max()


def test_utf_16_says_its_unit(tmp_path: Path):
    content = files.obj(SQUARE, comment="unit: µm").decode().encode("utf-16")
    assert read_surface(_write(tmp_path / "s.obj", content)).unit == "mm"
    assert read_surface(tmp_path / "s.obj").points.max() == SQUARE.max() / 1000


def test_contradicting_statements_are_told_and_not_believed(tmp_path: Path):
    path = _write(tmp_path / "s.obj", b"# unit m\n" + files.obj(SQUARE, comment="units: cm"))
    surface = read_surface(path)
    assert surface.unit is None
    assert list(surface.changed) == [
        "statement of a unit that is not understood: '# unit m'",
        "statement of a unit that is not understood: '# units: cm'",
    ]
    assert np.array_equal(surface.points, SQUARE)


@pytest.mark.parametrize("ending", ["obj", "xyz"])
def test_units_of_no_name_are_converted(ending: str, tmp_path: Path):
    comment = "1 unit = 2.5 mm"
    content = files.obj(SQUARE, comment=comment)
    if ending == "xyz":
        content = f"# {comment}\n".encode() + files.xyz(SQUARE)
    surface = read_surface(_write(tmp_path / f"s.{ending}", content))
    assert surface.unit == "mm"
    assert surface.changed == {"nodes converted from 2.5 mm to mm": 4}
    assert np.array_equal(surface.points, SQUARE * 2.5)


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
US_FEET = WKT.replace('"metre",1', '"US survey foot",0.3048006096')
GEOGRAPHIC = 'GEOGCS["b",UNIT["degree",0.0174532925199433]]'


@pytest.mark.parametrize(
    ("wkt", "unit"),
    [
        (WKT + "]", "m"),
        (US_FEET + "]", "us-ft"),
        (f'COMPD_CS["c",{WKT}],VERT_CS["d",UNIT["metre",1]]]', "m"),
        (f'{US_FEET}],VERTCS["NAVD88_height_(ftUS)",UNIT["Foot_US",0.3048006096012192]]', "us-ft"),
        ('PROJCRS["a",CS[Cartesian,2],LENGTHUNIT["metre",1]]', "m"),
        ('PROJCRS["a",CS[Cartesian,2],AXIS["e",east,LENGTHUNIT["foot",0.3048]]]', "ft"),
        ('PROJCS["a",UNIT["Gold Coast foot",0.3047997101815088]]', None),  # no foot we know
        ('PROJCS["a",UNIT["metre",0.3048]]', None),  # contradicts itself
        ('PROJCS["m",UNIT["unnamed",0.3048006]]', "us-ft"),
        ('PROJCS["a UNIT[""metre"",1]",UNIT["foot",0.3048]]', "ft"),  # within a name
        ('BOUNDCRS[SOURCECRS[PROJCRS["a",LENGTHUNIT["metre",1]]],TARGETCRS[GEOGCRS["b"]]]', "m"),
        ('GEODCRS["earth-centred",CS[Cartesian,3],LENGTHUNIT["metre",1]]', "m"),
        (WKT, None),  # cut off
        ("[" * 5000, None),
        ("", None),
    ],
)
def test_las_tells_its_linear_unit(wkt: str, unit: str | None, tmp_path: Path):
    surface = read_surface(_write(tmp_path / "scan.las", files.las(SQUARE, wkt=wkt)))
    assert surface.unit == unit
    assert surface.georeferenced == (unit is not None)
    assert bool(surface.changed) == (wkt != "" and unit is None)
    assert np.array_equal(surface.points, SQUARE)


@pytest.mark.parametrize(
    ("wkt", "fault"),
    [
        (f'COMPD_CS["c",{WKT}],VERT_CS["d",UNIT["foot",0.3048]]]', "heights are in ft, but its x"),
        (f'{WKT}],VERTCS["d",UNIT["Foot_US",0.3048006096012192]]', "heights are in us-ft, but"),
        (
            'PROJCRS["a",CS[Cartesian,3],AXIS["e",east,LENGTHUNIT["metre",1]],'
            'AXIS["h",up,LENGTHUNIT["foot",0.3048]]]',
            "heights are in ft, but its x and y in m",
        ),
        (GEOGRAPHIC, "longitude and latitude"),
        (f'COMPD_CS["c",{GEOGRAPHIC},VERT_CS["d",UNIT["metre",1]]]', "longitude and latitude"),
        ('GEOGCRS["b",CS[ellipsoidal,2],ANGLEUNIT["degree",0.01745]]', "longitude and latitude"),
    ],
)
def test_las_whose_coordinates_are_no_lengths_in_one_unit(wkt: str, fault: str, tmp_path: Path):
    path = _write(tmp_path / "scan.las", files.las(SQUARE, wkt=wkt))
    with pytest.raises(InputError, match=fault):
        read_surface(path)
    assert np.array_equal(read_surface(path, unit="m").points, 1000 * SQUARE)  # as the caller says


def _geotiff(pairs: dict[int, int], doubles: tuple[float, ...] = ()) -> list[Any]:
    import laspy

    keys = [1, 1, 0, len(pairs)]
    for key, value in pairs.items():
        keys += [key, 34736 if key == 3077 else 0, 1, value]
    records = [laspy.VLR("LASF_Projection", 34735, record_data=np.array(keys, "<u2").tobytes())]
    if doubles:
        data = np.array(doubles, "<f8").tobytes()
        records.append(laspy.VLR("LASF_Projection", 34736, record_data=data))
    return records


@pytest.mark.parametrize(("code", "unit"), [(9001, "m"), (9002, "ft"), (9003, "us-ft"), (1, None)])
def test_las_tells_the_unit_of_its_geotiff_keys(code: int, unit: str | None, tmp_path: Path):
    [record] = _geotiff({1024: 1, 3076: code})
    surface = read_surface(_write(tmp_path / "scan.las", files.las(SQUARE, record=record)))
    assert surface.unit == unit


@pytest.mark.parametrize(
    ("keys", "doubles", "outcome"),
    [
        ({1024: 1, 3072: 32632}, (), "m"),  # UTM
        ({1024: 1, 3072: 2992}, (), None),  # in feet, but nothing in the file says so
        ({1024: 1, 3072: 2992, 3076: 9002}, (), "ft"),
        ({1024: 1, 2054: 9102, 3076: 9001}, (), "m"),  # degrees are those of its base
        ({1024: 1, 3076: 32767, 3077: 0}, (1200 / 3937,), "us-ft"),
        ({1024: 1, 3076: 9003, 4099: 9003}, (), "us-ft"),
        ({1024: 1, 3076: 9001, 4099: 9003}, (), "heights are in us-ft, but its x and y in m"),
        ({1024: 1, 3076: 9001, 4096: 6360}, (), "heights are in us-ft, but its x and y in m"),
        ({1024: 2, 2048: 4326}, (), "longitude and latitude"),
        ({2048: 4326}, (), "longitude and latitude"),
    ],
)
def test_las_by_geotiff_keys(
    keys: dict[int, int], doubles: tuple[float, ...], outcome: str | None, tmp_path: Path
):
    content = files.las(SQUARE, record=_geotiff(keys, doubles))
    path = _write(tmp_path / "scan.las", content)
    if outcome and " " in outcome:
        with pytest.raises(InputError, match=outcome):
            read_surface(path)
    else:
        surface = read_surface(path)
        assert surface.unit == outcome
        assert bool(surface.changed) == (outcome is None)
