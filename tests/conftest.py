"""What all tests share."""

import os
from pathlib import Path

import pytest
from hypothesis import settings

# The machine decides how long an example takes; pytest's timeout watches over the whole test.
settings.register_profile("surfcmp", deadline=None)
settings.load_profile("surfcmp")


@pytest.fixture(scope="session")
def shared() -> Path:
    """Give the folder of real scans: `shared` beside the project, or $SURFCMP_SHARED."""
    beside = Path(__file__).resolve().parents[2] / "shared"
    folder = Path(os.environ.get("SURFCMP_SHARED", beside))
    if not (folder / "data").is_dir():
        pytest.skip(f"no real scans here: {folder / 'data'} is absent (set SURFCMP_SHARED)")
    return folder
