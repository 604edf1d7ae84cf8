"""All entrances bring files to one unit, or refuse them alike."""

import json
from pathlib import Path
from typing import Any

import pytest

from app.__main__ import main
from app.jobs.comparing import compared
from app.model.document import Document
from surfcmp_core import InputError, compare, read_surface
from surfcmp_core.report import make_record
from surfcmp_core.surface.units import SIZES
from surfcmp_core.system.progress import silent
from tests.core.reported_files import REPORTS, written

Told = dict[str, Any] | str
"""The .json result, or the refusal."""


def in_python(first: Path, second: Path, _folder: Path) -> Told:
    try:
        return make_record(compare(read_surface(first), read_surface(second)))
    except InputError as fault:
        return str(fault)


def by_command(first: Path, second: Path, folder: Path) -> Told:
    out = folder / "r.json"
    status = main(["compare", str(first), str(second), "--quiet", "--out", str(out)])
    if status:
        assert status == 3
        return "refused"
    found: dict[str, Any] = json.loads(out.read_text(encoding="utf-8"))
    return found


def in_batch(first: Path, second: Path, folder: Path) -> Told:
    out = folder / "pairs.json"
    main(["batch", str(first), str(second), "--quiet", "--out", str(out)])
    [found] = json.loads(out.read_text(encoding="utf-8"))["pairs"]
    return str(found["error"]) if "error" in found else dict(found)


def in_window(first: Path, second: Path, _folder: Path) -> Told:
    try:
        return compared(Document((first, second)), None, silent).record
    except InputError as fault:
        return str(fault)


ENTRANCES = (in_python, by_command, in_batch, in_window)


PAIRS = [
    # the first file, its unit; the second, its unit; the unit of the comparison
    ("a.ply", "m", "b.xyz", "m", "mm"),
    ("a.xyz", "m", "b.ply", "m", "mm"),
    ("a.xyz", "m", "b.npz", "m", "m"),
    ("a.xyz", "cm", "b.npz", "cm", "cm"),
    ("a.xyz", "um", "b.obj", "m", "mm"),
    ("a.xyz", "m", "b.npz", "mm", "mm"),
    ("a.npz", "mm", "b.xyz", "m", "mm"),
    ("a.xyz", "m", "b.npz", "ft", "m"),
    ("a.npz", "ft", "b.xyz", "us-ft", "m"),
    ("a.xyz", "in", "b.xyz", "ft", "mm"),
    ("a.obj", "in", "b.ply", "cm", "mm"),
    ("a.xyz", "km", "b.xyz", "yd", "m"),
    ("a.ply", "m", "b.ply", "", "mm"),
    ("a.xyz", "", "b.xyz", "m", "m"),
    ("a.xyz", "", "b.ply", "m", "mm"),
    ("a.ply", "", "b.xyz", "", "mm"),
]


@pytest.mark.parametrize(("first", "unit_1", "second", "unit_2", "unit"), PAIRS)
def test_all_entrances_bring_files_to_one_unit(
    first: str, unit_1: str, second: str, unit_2: str, unit: str, tmp_path: Path
) -> None:
    # a file that says nothing holds numbers in the unit that the other one states
    one = written(tmp_path, first, unit_1 or unit_2, 0.25)
    two = written(tmp_path, second, unit_2 or unit_1, 0.0)
    if not unit_1:
        one.write_bytes(one.read_bytes().replace(f"unit {unit_2}".encode(), b"nothing"))
    if not unit_2:
        two.write_bytes(two.read_bytes().replace(f"unit {unit_1}".encode(), b"nothing"))
    told = [entrance(one, two, tmp_path) for entrance in ENTRANCES]
    metre = float(SIZES["m"] / SIZES[unit])
    for found in told:
        assert isinstance(found, dict)
        assert found["options"]["unit"] == unit
        measures = found["measures"]
        assert measures["mean_abs"] == pytest.approx(0.25 * metre, rel=1e-12)
        if "us-ft" not in (unit_1, unit_2):  # else the borders are some last bits apart
            assert measures["area_compared"] == pytest.approx(9.0 * metre**2, rel=1e-12)
        assert measures == told[0]["measures"]  # type: ignore[index]
        assert found["warnings"] == told[0]["warnings"]  # type: ignore[index]
        quiet = [name for name, said in ((first, unit_1), (second, unit_2)) if not said]
        taken = f"no unit stated in {' and '.join(quiet)}: taken as {unit_1 or unit_2 or 'mm'}"
        assert (taken in found["warnings"]) == bool(quiet)
        for name, stated in ((first, unit_1 or unit_2), (second, unit_2 or unit_1)):
            line = f"{name}: 16 nodes converted from {stated} to {unit}"
            assert (line in found["warnings"]) == (bool(stated) and stated != unit)


REFUSED = [
    ("las_metre.las", "las_foot.las", "las_foot.las: is in ft, but the other surface in m"),
    ("las_metre.las", "las_wkt2_usft.las", "las_wkt2_usft.las: is in us-ft, but the other"),
    (
        "las_metre_plus_usft_heights.las",
        "las_metre.las",
        "las_metre_plus_usft_heights.las: its heights are in us-ft, but its x and y in m",
    ),
]


@pytest.mark.parametrize(("first", "second", "fault"), REFUSED)
def test_all_entrances_refuse_the_same(
    first: str, second: str, fault: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for entrance in ENTRANCES:
        found = entrance(REPORTS / first, REPORTS / second, tmp_path)
        told = capsys.readouterr().err if found == "refused" else found
        assert isinstance(told, str)
        assert fault in told
        assert "\n" not in told.strip()


def test_withheld_points_are_left_out_and_counted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pair = REPORTS / "las_two_withheld.las", REPORTS / "las_metre_b.las"
    for entrance in ENTRANCES:
        found = entrance(*pair, tmp_path)
        assert isinstance(found, dict)
        assert found["measures"]["mean_abs"] == pytest.approx(1.0, rel=1e-12)
        assert found["inputs"][0]["dropped"] == {"withheld": 2}
        assert found["inputs"][0]["nodes"] == 123
    assert main(["compare", *map(str, pair)]) == 0
    assert "left out of 1" in capsys.readouterr().out
