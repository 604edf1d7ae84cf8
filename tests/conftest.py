"""What all tests share."""

import os
from collections.abc import Callable, Generator
from pathlib import Path

import pytest
from hypothesis import settings

from surfcmp_core.surface import Surface
from tests.scans import MADE, made_scan, real_scan

# The machine decides how long an example takes; pytest's timeout watches over the whole test.
settings.register_profile("surfcmp", deadline=None)
settings.load_profile("surfcmp")


_ABSENT = "no real scans here"


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport() -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Tell of all tests that ask for real scans in one line, not each."""
    report = yield
    if report.skipped and isinstance(report.longrepr, tuple) and _ABSENT in report.longrepr[2]:
        report.longrepr = (__file__, None, report.longrepr[2])  # type: ignore[assignment]
    return report


@pytest.fixture(scope="session")
def shared() -> Path:
    """Give the folder of real scans: `shared` beside the project, or $SURFCMP_SHARED."""
    beside = Path(__file__).resolve().parents[2] / "shared"
    folder = Path(os.environ.get("SURFCMP_SHARED", beside))
    if not (folder / "data").is_dir():
        pytest.skip(f"{_ABSENT}: {folder / 'data'} is absent (set SURFCMP_SHARED)")
    return folder


@pytest.fixture(scope="session")
def scan(request: pytest.FixtureRequest) -> Callable[[str], Surface]:
    """Load a scan by name: one of our own making always, a real one where it is at hand."""

    def load(name: str) -> Surface:
        if name in MADE:
            return made_scan(name)
        return real_scan(request.getfixturevalue("shared"), name)

    return load
