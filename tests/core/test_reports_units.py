"""What files say of units: sizes, conversions, what is told of them."""

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from app.__main__ import main
from surfcmp_core import InputError, Surface, compare, read_surface
from surfcmp_core.alignment import best_fit
from surfcmp_core.cli.shared_options import UnitOption
from surfcmp_core.projection.placement import place
from surfcmp_core.surface.together import bring_together
from surfcmp_core.surface.units import SIZES, UNITS, converted
from tests.core import surface_files as files
from tests.core.reported_files import REPORTS, written


@pytest.mark.parametrize(
    "names", [("states_m.ply", "states_m.xyz"), ("states_m.xyz", "states_m.ply")]
)
def test_one_metre_is_one_metre_in_both_formats(names: tuple[str, str]) -> None:
    result = compare(*(read_surface(REPORTS / name) for name in names))
    assert result.surfaces[0].unit == "mm"
    assert result.measures.mean_abs == pytest.approx(1000.0, rel=1e-14)
    assert result.measures.area_compared == 9e6
    assert result.counts["nodes_shared"] == 16  # the same bits by both ways


def test_the_same_with_the_roles_exchanged() -> None:
    first, second = (read_surface(REPORTS / f"states_{unit}.xyz") for unit in ("mm", "m"))
    there, back = compare(first, second), compare(second, first)
    assert there.measures.mean_signed == -back.measures.mean_signed
    assert there.surfaces[0].unit == back.surfaces[0].unit == "mm"


def test_where_units_are_equal_every_bit_stays() -> None:
    one = read_surface(REPORTS / "states_m.xyz")
    together = bring_together(one, replace(one, name="other"))
    assert together.surfaces[0].points is one.points
    assert together.warnings == ()


def test_conversions_by_whole_numbers_are_rounded_once() -> None:
    rng = np.random.default_rng(5)
    decimals = np.round(rng.uniform(-4000, 4000, (500, 3)), 3)
    surface = Surface(decimals)
    metres = converted(surface, Fraction(1), "m")
    expected = [[float(Fraction(c) / 1000) for c in row] for row in decimals.tolist()]
    assert metres.points.tolist() == expected
    back = converted(surface, SIZES["m"], "mm")
    assert back.points.tolist() == [[float(Fraction(c) * 1000) for c in row] for row in decimals]


def test_sizes_of_units() -> None:
    assert float(SIZES["us-ft"]) == 1200.0 / 3937.0 * 1000.0
    assert SIZES["yd"] == 3 * SIZES["ft"] == 36 * SIZES["in"] == Fraction(9144, 10)
    assert SIZES["mil"] * 1000 == SIZES["in"]


def test_one_list_of_units_for_the_command_line_the_window_and_python() -> None:
    from typing import get_args

    panel = (Path(__file__).parents[2] / "app/panels/options_panel.py").read_text(encoding="utf-8")
    block = panel[panel.index("UNITS: dict") : panel.index("VIEWS: dict")]
    asked = get_args(get_args(get_args(UnitOption)[0])[0])
    assert set(asked) == set(UNITS)
    assert {line.split('"')[1] for line in block.splitlines() if line.startswith('    "')} == {
        "",
        *UNITS,
    }


def test_what_conversion_makes_infinite_is_refused() -> None:
    far = Surface(np.array([[0, 0, 0], [1e308, 0, 0], [0, 1e308, 0]]), unit="m")
    near = Surface(np.eye(3), unit="mm")
    with pytest.raises(InputError):
        compare(far, near)


@pytest.mark.parametrize("unlike", [{"unit": "m"}, {"space": "RAS"}])
@pytest.mark.parametrize("act", [best_fit, lambda a, b: place(a, b, "auto")])
def test_unlike_surfaces_are_not_fitted_nor_placed(
    unlike: dict[str, str], act: Callable[[Surface, Surface], object]
) -> None:
    surface = replace(read_surface(REPORTS / "flat1.ply"), unit="mm", space="LPS")
    with pytest.raises(InputError, match="but the other surface in"):
        act(surface, replace(surface, **unlike))  # type: ignore[arg-type]


@pytest.mark.parametrize(("form", "high"), [(1, 0), (6, 3)])
def test_noise_is_left_out(form: int, high: int, tmp_path: Path) -> None:
    import laspy

    header = laspy.LasHeader(point_format=form, version="1.4" if form == 6 else "1.2")
    data = laspy.LasData(header)
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(6.0), np.arange(6.0)))
    data.x, data.y, data.z = x, y, x + y
    classes = np.full(36, 2)
    classes[[3, 4]], classes[[10, 11, 12]], classes[20] = 7, 18, 12  # 12: overlap, which stays
    data.classification = classes
    data.withheld = np.arange(36) == 3
    data.synthetic = np.arange(36) == 5
    data.write(tmp_path / "a.las")
    surface = read_surface(tmp_path / "a.las")
    assert surface.dropped == {"withheld": 1, "noise": 1 + high}
    assert len(surface.points) == 36 - 2 - high
    data.classification = np.full(36, 7)
    data.write(tmp_path / "b.las")
    with pytest.raises(InputError, match="all of its 36 points are withheld or noise"):
        read_surface(tmp_path / "b.las")


def test_wkt_behind_the_points(tmp_path: Path) -> None:
    import laspy

    header = laspy.LasHeader(point_format=6, version="1.4")
    header.global_encoding.wkt = True
    data = laspy.LasData(header)
    data.x, data.y, data.z = files.SQUARE.T
    text = b'PROJCS["a",UNIT["US survey foot",0.3048006096]]\0'
    record = laspy.VLR("LASF_Projection", 2112, record_data=text)
    data.evlrs = laspy.vlrs.vlrlist.VLRList([record])
    data.write(tmp_path / "a.las")
    assert read_surface(tmp_path / "a.las").unit == "us-ft"


@pytest.mark.parametrize("ending", [".ply", ".npz", ".xyz"])
def test_a_thinned_file_says_what_the_whole_one_says(ending: str, tmp_path: Path) -> None:
    out = tmp_path / f"thin{ending}"
    whole = (REPORTS / "slicer_ras.ply").read_bytes().replace(b"SPACE=RAS", b"SPACE=RAS unit=cm")
    (tmp_path / "a.ply").write_bytes(whole)
    assert main(["thin", str(tmp_path / "a.ply"), "--keep", "0.8", "--out", str(out)]) == 0
    thinned = read_surface(out)
    assert (thinned.unit, thinned.space) == ("mm", "RAS")


def test_a_table_of_pairs_says_each_unit(tmp_path: Path) -> None:
    import csv

    pair = [str(written(tmp_path, "a.xyz", "m", 1.0)), str(written(tmp_path, "b.xyz", "ft", 0.0))]
    assert main(["batch", *pair, "--quiet", "--out", str(tmp_path / "r.csv")]) == 0
    with (tmp_path / "r.csv").open(newline="", encoding="utf-8") as stream:
        [row] = csv.DictReader(stream)
    assert row["unit"] == "m"


def test_a_million_comments_take_no_time(tmp_path: Path) -> None:
    import time

    comments = b"# unit vector of a node [x]\n" * 1_000_000
    (tmp_path / "a.obj").write_bytes(b"# unit cm\n" + comments + files.obj(files.SQUARE))
    (tmp_path / "b.las").write_bytes(files.las(files.SQUARE, wkt="A[" + "1," * 30_000))
    start = time.process_time()
    assert read_surface(tmp_path / "a.obj").unit == "mm"
    assert read_surface(tmp_path / "b.las").unit is None
    assert time.process_time() - start < 5.0
