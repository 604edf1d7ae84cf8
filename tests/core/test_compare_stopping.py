"""A comparison tells how far it is, and may be stopped."""

import threading

import pytest

from surfcmp_core import compare
from surfcmp_core.errors import Cancelled
from tests.core.small_surfaces import assert_same, two_surfaces

STAGES = ["triangulate", "spanning trees", "interface", "interpolate", "measures", "done"]


@pytest.mark.parametrize("threads", [1, 2])
def test_progress_tells_the_stages_in_order(threads: int) -> None:
    told: list[tuple[str, float]] = []
    compare(*two_surfaces(13))  # the first comparison of all speaks of compiling too
    result = compare(*two_surfaces(13), threads=threads, progress=lambda *what: told.append(what))
    stages = list(dict.fromkeys(stage for stage, _ in told))
    assert stages == STAGES
    shares = [share for _, share in told]
    assert shares == sorted(shares)
    assert (shares[0], shares[-1]) == (0.0, 1.0)
    parts = [v for k, v in result.seconds.items() if k != "total"]
    assert max(parts) <= result.seconds["total"]


@pytest.mark.parametrize("stage", STAGES)
def test_cancelling_leaves_nothing_behind(stage: str) -> None:
    first, second = two_surfaces(14)
    expected = compare(first, second)
    threads = threading.active_count()

    def stop(reached: str, share: float) -> None:
        if reached == stage:
            raise Cancelled

    with pytest.raises(Cancelled):
        compare(first, second, progress=stop)
    assert threading.active_count() == threads
    assert_same(compare(first, second), expected)
