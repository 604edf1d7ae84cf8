"""Tables and clouds that other programs were reported to misread: what each gives here."""

import json
from pathlib import Path
from typing import Any

import pytest

from app.__main__ import main
from tests.program.said import lines

REPORTS = Path(__file__).parent / "fixtures" / "reports"


def _compared(capsys: pytest.CaptureFixture[str], first: str, *options: str) -> dict[str, Any]:
    other = "zero_scan.xyz" if first.startswith("scan") else "zero4.xyz"
    assert main(["compare", str(REPORTS / first), str(REPORTS / other), "--json", *options]) == 0
    return dict(json.loads(capsys.readouterr().out))


@pytest.mark.parametrize(
    "name",
    [
        "true4.xyz",
        "header_survey_names.csv",
        "header_paraview.csv",
        "header_unit_words.txt",
        "units_row.csv",
        "excel_sep.csv",
    ],
)
def test_tables(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    document = _compared(capsys, name)
    measures = document["measures"]
    assert abs(measures["mean_signed"]) == pytest.approx(3.150)
    assert measures["area_compared"] == pytest.approx(9.0)
    stated = name in ("header_unit_words.txt", "units_row.csv")
    assert any(f"no unit stated in {name}" in one for one in document["warnings"]) != stated


def test_thousands(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["info", str(REPORTS / "thousands_german.csv")]) == 0
    said = capsys.readouterr().out
    for extent in ("1200 to 1203", "5600 to 5603", "3.000 to 3.300"):
        assert extent in said


def test_scan_lines(capsys: pytest.CaptureFixture[str]) -> None:
    measures = _compared(capsys, "scan_lines_1to4.xyz")["measures"]
    assert measures["mean_abs"] == pytest.approx(1.0)
    assert measures["area_compared"] == pytest.approx(36.0)
    pair = [str(REPORTS / name) for name in ("scan_lines_1to4.xyz", "zero_scan.xyz")]
    assert main(["compare", *pair, "--max-edge", "0.2"]) == 3
    [line] = lines(capsys)
    assert "0.2 mm (scan_lines_1to4.xyz)" in line
    assert "--max-edge" in line


def test_no_data(capsys: pytest.CaptureFixture[str]) -> None:
    told = "nodata_9999.xyz: 1 nodes with z = -9999"
    assert any(one.startswith(told) for one in _compared(capsys, "nodata_9999.xyz")["warnings"])
    left_out = _compared(capsys, "nodata_9999.xyz", "--no-data", "-9999")
    assert abs(left_out["measures"]["mean_signed"]) == pytest.approx(3.150, rel=0.02)
    pair = [str(REPORTS / name) for name in ("nodata_9999.xyz", "zero4.xyz")]
    assert main(["compare", *pair, "--max-edge", "0.2"]) == 3
    assert "nodata_9999.xyz has 1 nodes with z = -9999" in lines(capsys)[-1]


def test_a_node_that_is_not_finite(capsys: pytest.CaptureFixture[str]) -> None:
    pair = [str(REPORTS / name) for name in ("nan_one.xyz", "zero4.xyz")]
    assert main(["compare", *pair]) == 3
    assert "--no-data nan" in lines(capsys)[-1]
    assert main(["compare", *pair, "--quiet", "--no-data", "nan"]) == 0


@pytest.mark.parametrize("header", ["x,y,weight", "x,y,µ", "X [mm],Y [mm],mu", "x,y,z", ""])
def test_weights_may_be_named(
    header: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    weight = tmp_path / "weight.csv"
    rows = "-1,-1,1\n5,-1,1\n5,5,3\n-1,5,3\n"
    weight.write_text(f"{header}\n{rows}".lstrip(), encoding="utf-8")
    measures = _compared(capsys, "true4.xyz", "--weight", str(weight))["measures"]
    assert measures["rho_V_mu"] > measures["rho_V"]


def test_weights_are_no_heights(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    weight = tmp_path / "weight.csv"
    weight.write_text("x,y,weight\n-1,-1,1\n5,-1,1\n5,5,3\n", encoding="utf-8")
    assert main(["compare", str(weight), str(REPORTS / "zero4.xyz")]) == 3
    assert lines(capsys) == [
        f"surfcmp: {weight}: its header 'x,y,weight' does not name x, y and z once each"
    ]
