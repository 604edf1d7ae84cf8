"""Tables as people have them: headings in any usual way are understood, others refused."""

import time
from contextlib import suppress
from pathlib import Path

import pytest

from surfcmp_core.errors import InputError
from surfcmp_core.io import read_surface
from surfcmp_core.io.columns import read_columns

NODES = [[0.5, 2.25, 3.0], [1.0, 2.25, 3.5], [1.25, 4.0, 4.0], [7.5, 6.0, 5.125]]
"""In each column a number that no other has."""


def _table(header: str, order: str, delimiter: str = ",", more: str = "\n") -> str:
    """Rows below a header: `order` names what stands in each column; i a number, n a name."""
    rows = []
    for i, (x, y, z) in enumerate(NODES):
        field = {"x": x, "y": y, "z": z, "i": 17 * i % 7, "n": f"P{i}", "s": 0.5, "_": ""}
        rows.append(delimiter.join(str(field[letter]) for letter in order))
    return header + more + "\n".join(rows) + "\n"


NAMED: dict[str, tuple[str, str, str | None]] = {
    # header: delimiter and columns, unit
    "x,y,z": (",", "xyz", None),
    "X,Y,Z,": (",", "xyz", None),
    "Z,Y,X": (",", "zyx", None),
    "y,x,z": (",", "yxz", None),
    "x (mm),y (mm),z (mm)": (",", "xyz", "mm"),
    "X [m];Y [m];Z [m]": (";", "xyz", "m"),
    "X(m),Y(m),Z(m)": (",", "xyz", "m"),
    "x_mm y_mm z_mm": (" ", "xyz", "mm"),
    "x mm,y mm,z mm": (",", "xyz", "mm"),
    "x mm y mm z mm": (" ", "xyz", "mm"),
    "id x (mm) y (mm) z (mm)": (" ", "ixyz", "mm"),
    "x in mm\ty in mm\tz in mm": ("\t", "xyz", "mm"),
    "x/mm y/mm z/mm": (" ", "xyz", "mm"),
    "X..mm.,Y..mm.,Z..mm.": (",", "xyz", "mm"),
    "x [µm],y [μm],z [um]": (",", "xyz", "um"),
    "x (metres), y (meters), z (m)": (",", "xyz", "m"),
    "X [m], Y [m], Z [m ü. NN]": (",", "xyz", "m"),
    "X (US survey ft),Y (US survey ft),Z (US survey ft)": (",", "xyz", "us-ft"),
    "x,y,z (cm)": (",", "xyz", "cm"),
    "X (WGS84),Y (WGS84),Z (NAVD88)": (",", "xyz", None),
    "x-coordinate,y-coordinate,z-coordinate": (",", "xyz", None),
    "X Coordinate,Y Coordinate,Z Coordinate": (",", "xyz", None),
    "coord_x coord_y coord_z": (" ", "xyz", None),
    "CoordX,CoordY,CoordZ": (",", "xyz", None),
    "xcoord;ycoord;zcoord": (";", "xyz", None),
    "X-Koordinate [mm];Y-Koordinate [mm];Z-Koordinate [mm]": (";", "xyz", "mm"),
    "POINT_X,POINT_Y,POINT_Z": (",", "xyz", None),
    "OBJECTID,Shape,POINT_X,POINT_Y,POINT_Z": (",", "inxyz", None),
    "pos_x,pos_y,pos_z": (",", "xyz", None),
    '"Points:0","Points:1","Points:2"': (",", "xyz", None),
    '"scalar","Points:0","Points:1","Points:2"': (",", "sxyz", None),
    "Points_0,Points_1,Points_2,Normals_0,Normals_1,Normals_2": (",", "xyzsss", None),
    "Points[0] Points[1] Points[2]": (" ", "xyz", None),
    "coordinates:2,coordinates:1,coordinates:0": (",", "zyx", None),
    "Point,Easting,Northing,Elevation": (",", "ixyz", None),
    "Pt Northing Easting Height Code": (" ", "nyxzn", None),
    "Easting (m),Northing (m),Ellipsoidal Height (m)": (",", "xyz", "m"),
    "UTM Easting,UTM Northing,Elev.": (",", "xyz", None),
    "Easting_m,Northing_m,Altitude_m": (",", "xyz", "m"),
    "E,N,H": (",", "xyz", None),
    "N E Z": (" ", "yxz", None),
    "Rechtswert;Hochwert;Höhe": (";", "xyz", None),
    "Punkt;Rechtswert [m];Hochwert [m];Höhe [m]": (";", "nxyz", "m"),
    "R;H;Z": (";", "xyz", None),
    "Ost;Nord;Hoehe": (";", "xyz", None),
    "Punktnummer,Nord,Ost,Höhe ü. NN": (",", "nyxz", None),
    "Este,Norte,Cota": (",", "xyz", None),
    "Est;Nord;Quota": (";", "xyz", None),
    "lat,lon,x,y,z": (",", "ssxyz", None),
    "//X Y Z": (" ", "xyz", None),
    "//X,Y,Z,R,G,B": (",", "xyziii", None),
    "# x y z": (" ", "xyz", None),
    "# z x y": (" ", "zxy", None),
    "#id,y,x,z": (",", "iyxz", None),
    "# columns: z y x": (" ", "zyx", None),
    "% x y z": (" ", "xyz", None),
    "%% Easting Northing Elevation": (" ", "xyz", None),
    "# X [mm]  Y [mm]  Z [mm]": (" ", "xyz", "mm"),
    "# x y z": (" ", "xyzss", None),  # noqa: F601
    "# made by hand": (" ", "xyz", None),
    "# the laboratory's scan": (" ", "xyz", None),
    "Scan 17": (" ", "xyz", None),
    "Scan 17\nx y z": (" ", "xyz", None),
    "x,y,z\nmm,mm,mm": (",", "xyz", "mm"),
    "x,y,z\n[m],[m],[m]": (",", "xyz", "m"),
    "Name;y;x;z\n-;cm;cm;cm": (";", "nyxz", "cm"),
    "# x y z\n# m m m": (" ", "xyz", "m"),
    "sep=;\nx;y;z": (";", "xyz", None),
    '"sep=,"\nx,y,z': (",", "xyz", None),
    "sep=\t\nx\ty\tz": ("\t", "xyz", None),
    "x,y,z,,": (",", "xyz__", None),
    '"name","x","y","z"': (",", "nxyz", None),
    "x y z name": (" ", "xyzn", None),
    "x name y z": (" ", "xnyz", None),
    '"x" "y" "z"': (" ", "nxyz", None),  # names of rows without a name of their own
    "time x1 y1 z1": (" ", "sxyz", None),
    "x,y,z,height,nx,ny,nz": (",", "xyzssss", None),
}


@pytest.mark.parametrize("header", NAMED)
def test_a_heading_that_is_understood(header: str):
    delimiter, order, unit = NAMED[header]
    raw = read_columns(_table(header, order, delimiter).encode())
    assert raw.points.tolist() == NODES
    assert raw.unit == unit


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "cp1252"])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_a_heading_in_another_encoding(encoding: str, end: str):
    text = _table("Punkt;Rechtswert [m];Hochwert [m];Höhe [m]", "nxyz", ";").replace("\n", end)
    raw = read_columns(text.encode(encoding))
    assert raw.points.tolist() == NODES
    assert raw.unit == "m"


@pytest.mark.parametrize("encoding", ["cp437", "mac-roman"])
def test_a_german_height_in_an_encoding_that_nothing_tells(encoding: str):
    text = _table("Rechtswert;Hochwert;Höhe", "xyz", ";")
    assert read_columns(text.encode(encoding)).points.tolist() == NODES


REFUSED: dict[str, tuple[str, str, str]] = {
    # header: delimiter, columns, what the message tells besides the header
    "a,b,c": (",", "xyz", "does not name x, y and z once each"),
    "x,y,value": (",", "xyz", "does not name x, y and z once each"),
    "x,y,depth": (",", "xyz", "does not name x, y and z once each"),
    "u;v;w": (";", "xyz", "does not name x, y and z once each"),
    "Messung vom Montag": (" ", "xyz", "does not name x, y and z once each"),
    "x,y,z,x,y,z": (",", "xyzxyz", "does not name x, y and z once each"),
    "x,y,height,elevation": (",", "xyzs", "does not name x, y and z once each"),
    "Easting,Northing": (",", "xyz", ""),
    "# x y intensity": (" ", "xyz", "does not name x, y and z once each"),
    "lat,lon,height": (",", "xyz", "names latitude and longitude, angles"),
    "Latitude (deg) Longitude (deg) Elevation (m)": (" ", "xyz", "names latitude and longitude"),
    "Länge;Breite;Höhe": (";", "xyz", "names latitude and longitude"),
    "# lon lat h": (" ", "xyz", "names latitude and longitude"),
    "x (deg),y (deg),z (m)": (",", "xyz", "'deg', which is no length known"),
    "x [px],y [px],z [px]": (",", "xyz", "'px', which is no length known"),
    "x [miles],y [miles],z [miles]": (",", "xyz", "'miles', which is no length known"),
    "x [mm],y [mm],z [m]": (",", "xyz", "in m and mm"),
    "Easting_m Northing_m Elevation_ft": (" ", "xyz", "in ft and m"),
    "x [mm],y [mm],z [mm]\nm,m,m": (",", "xyz", "in m and mm"),
    "x,y,z\nmm,mm,m": (",", "xyz", "in m and mm"),
    "mm,mm,mm": (",", "xyz", "names units only"),
    "x,y,z": (",", "xyzi", "names 3 columns, but 4 are in the row '0.5,2.25,3.0,0'"),
    "x,y,z,id": (",", "xyz", "names 4 columns, but 3 are in the row '0.5,2.25,3.0'"),
    "# z y x": (" ", "zyxss", "names 3 columns, but 5 are in the row"),
    "x,y,z\na,b,c": (",", "xyz", ""),
    "0,1,2": (",", "xyz", ""),
    ",0,1,2": (",", "ixyz", ""),
}


@pytest.mark.parametrize("header", REFUSED)
def test_a_heading_that_is_not_understood_is_quoted(header: str):
    delimiter, order, told = REFUSED[header]
    with pytest.raises(InputError) as caught:
        read_columns(_table(header, order, delimiter).encode())
    message = str(caught.value)
    assert told in message
    assert message.startswith("its header ")
    quoted = header.lstrip("#% ").split("\n")
    assert any(repr(line) in message for line in quoted)
    assert "\n" not in message


def test_a_comment_and_the_heading_must_agree():
    table = _table("x [mm],y [mm],z [mm]", "xyz")
    assert read_columns(f"# unit mm\n{table}".encode()).unit == "mm"
    with pytest.raises(InputError, match="its header says mm, a comment m"):
        read_columns(f"# unit m\n{table}".encode())


def test_names_of_points_without_any_heading():
    for order in ("nxyz", "xnyz", "xyzn", "nnxyzn"):
        assert read_columns(_table("", order, more="").encode()).points.tolist() == NODES


@pytest.mark.parametrize("start", [0, 1, 1001])
def test_running_numbers_without_any_heading_are_left_out_and_counted(start: int):
    rows = [f"{i + start} {x} {y} {z}" for i, (x, y, z) in enumerate(NODES)]
    raw = read_columns("\n".join(rows).encode())
    assert raw.points.tolist() == NODES
    assert raw.changed == {"rows that begin with a number of the point, left out": 4}


def test_whole_numbers_ahead_that_do_not_run_on_are_refused():
    with pytest.raises(InputError, match="a header must name x, y and z"):
        read_columns(_table("", "ixyz", more="").encode())
    rows = [[*row, 255, 17, 0] for row in ([1, 2, 3], [2, 5, 3], [2, 7, 4], [1, 9, 4])]
    text = "\n".join(" ".join(map(str, row)) for row in rows)
    assert read_columns(text.encode()).points[:, 1].tolist() == [2, 5, 7, 9]  # with colours


@pytest.mark.parametrize(
    "row", ["1 2 3 4", "1 2", "x 2 3", "1,2,3", "1 2 3 # here", "1 2 NULL", "1 2 3;5"]
)
def test_ragged_rows_are_quoted(row: str):
    text = "x y z\n" + "0 0 1.5\n" * 60 + row + "\n" + "0 1 1.5\n" * 60
    with pytest.raises(InputError, match="expected") as caught:
        read_columns(text.encode())
    assert repr(row) in str(caught.value)


def test_ragged_rows_have_status_3_and_the_file_named(tmp_path: Path):
    path = tmp_path / "scan.csv"
    path.write_text("x,y,z\n0,0,1\n1,0,1\n0,1\n")
    with pytest.raises(InputError) as caught:
        read_surface(path)
    assert str(caught.value) == f"{path}: 3 columns, x, y and z numbers, expected in the row '0,1'"


LONG = {
    "comments": "# x y z unit (mm)\n" * 100_000 + "0 0 1.5\n1 0 0\n0 1 0\n",
    "units": "mm " * 500_000 + "\n0 0 0\n",
    "columns": "0 " * 500_000 + "\n",
    "names": "x," * 500_000 + "\n0,0,0\n",
    "brackets": "x " + "(" * 500_000 + "\n0 0 0\n",
    "blanks": "x" + " " * 500_000 + "y\tz\n0 0 0\n",
    "titles": "a\n" * 500_000,
    "commas": "," * 500_000 + "\n",
}


@pytest.mark.parametrize("case", LONG)
def test_nothing_ahead_takes_long(case: str):
    start = time.process_time()
    with suppress(InputError):
        read_columns(LONG[case].encode())
    assert time.process_time() - start < 2.0
