"""Motions of the window are in the unit and axes of surface 1's file."""

from pathlib import Path

import numpy as np
import pytest

from app.controllers.aligning import best_fit_of, to_comparison
from app.jobs.comparing import compared
from app.model.document import Document
from surfcmp_core.comparing.options import Motion, Options
from surfcmp_core.io.samples import sample_pair
from surfcmp_core.system.progress import silent
from tests.core.surface_files import ply_header


def written(path: Path, points: np.ndarray, comment: str) -> Path:
    rows = "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in points.tolist())
    path.write_bytes(ply_header("ascii", len(points), 0, comment=comment) + rows.encode())
    return path


@pytest.mark.parametrize(("comments", "unit"), [(("unit cm", "unit cm"), ""), (("", ""), "cm")])
@pytest.mark.parametrize("turned", [False, True])
def test_abest_fit_of_is_told_as_file_1_counts(
    comments: tuple[str, str], unit: str, turned: bool, tmp_path: Path
):
    from surfcmp_core.io import read_surface

    whole = read_surface(sample_pair("face")[0]).points / 10.0  # cm
    shift = np.array([0.2, -0.1, 0.05])
    axes = ("SPACE=RAS", "SPACE=LPS") if turned else ("", "")
    second = (whole - shift) * ([-1, -1, 1] if turned else [1, 1, 1])
    one = written(tmp_path / "a.ply", whole, f"{axes[0]} {comments[0]}")
    two = written(tmp_path / "b.ply", second, f"{axes[1]} {comments[1]}")
    shown = compared(Document((one, two), Options(unit=unit or None)), None, silent)
    motion = best_fit_of(shown, None, silent)
    np.testing.assert_allclose(np.array(motion.matrix)[:3, 3], shift, atol=1e-4)

    moved = compared(Document((one, two), Options(unit=unit or None, align=motion)), None, silent)
    assert moved.comparison.measures.mean_abs < 0.01  # mm
    there = to_comparison(moved)
    assert there[1][:3, :3] @ whole[0] + there[1][:3, 3] == pytest.approx(
        moved.comparison.surfaces[0].points[0] + 10 * shift * ([-1, -1, 1] if turned else 1),
        abs=0.01,
    )
    again = Motion(motion.matrix, "by hand")
    named = Document((one, two), Options(unit="cm", align=again))
    assert compared(named, None, silent).comparison.measures.mean_abs < 0.01
