"""What tests of the command line share."""

from pathlib import Path

import numpy as np
import pytest


@pytest.fixture
def pair(tmp_path: Path) -> tuple[str, str]:
    """Write a flat 5 x 5 lattice, and a cloud of 60 nodes a tenth above it."""
    x, y = np.meshgrid(np.arange(5.0), np.arange(5.0))
    first = tmp_path / "one.xyz"
    np.savetxt(first, np.column_stack([x.ravel(), y.ravel(), np.zeros(25)]))
    second = tmp_path / "two.csv"
    places = np.random.default_rng(5).random((60, 2)) * 4
    np.savetxt(second, np.column_stack([places, np.full(60, 0.1)]), delimiter=",")
    return str(first), str(second)
