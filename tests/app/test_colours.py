"""A difference has one colour, on the screen and on paper."""

import numpy as np
import pytest

from app.jobs.comparing import Compared
from app.jobs.writing import record_of
from app.model.document import Document
from app.model.view_state import Heatmap, ScaleChoice, ViewState
from app.scene.content import Content, content_of
from app.scene.scene import scene_of
from surfcmp_core.colours.scale import scale_end, scale_of
from surfcmp_core.report import make_record
from surfcmp_core.report.figures import heatmap
from tests.window.builders import comparison_of, hills


@pytest.fixture(scope="module")
def content() -> Content:
    """A small comparison with a hole, ready to be shown."""
    return content_of(comparison_of(hills(200, 1), hills(150, 2, lift=3.0), hole=15.0))


@pytest.mark.parametrize("kind", [Heatmap.SIGNED, Heatmap.ABSOLUTE])
@pytest.mark.parametrize("banded", [True, False])
@pytest.mark.parametrize("limit", [0.7, 3.0])
def test_report_and_window_paint_the_same_map(
    content: Content, kind: Heatmap, banded: bool, limit: float
) -> None:
    comparison = content.comparison
    state = ViewState(heatmap=kind, scale=ScaleChoice(limit, (0.5, 1.0, 2.0), banded))
    shown = Compared(Document(), comparison, make_record(comparison), content, ())
    record = record_of(shown, state)
    assert scale_of(comparison, record) == state.colours
    (painted, *_) = heatmap(comparison, record, signed=kind is Heatmap.SIGNED).axes[0].collections
    on_paper = painted.to_rgba(painted.get_array()[::3], bytes=True)[:, :3]
    on_screen = scene_of(content, state).layers[3].colours
    assert (on_paper == on_screen).all()
    assert len(np.unique(on_screen, axis=0)) > (3 if banded else 30)


def test_the_range_that_fits_is_the_same(content: Content) -> None:
    assert content.distributions.fitting_end == scale_end(content.comparison)
