"""What goes into a wheel beside the modules."""

import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize("package", ["app", "surfcmp_core"])
def test_types_and_what_else_lies_beside_the_modules_are_packed(package: str) -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    folder = ROOT / package
    beside = {
        str(path.relative_to(folder))
        for path in folder.rglob("*")
        if path.is_file() and path.suffix not in {".py", ".pyc"}
    }
    assert "py.typed" in beside
    assert set(project["tool"]["setuptools"]["package-data"][package]) == beside
