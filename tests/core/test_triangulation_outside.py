"""Triangulating in another process changes nothing but who does it."""

import sys

import numpy as np
import pytest

from surfcmp_core.triangulation import outside, triangulate, triangulation

NODES = np.random.default_rng(3).random((500, 2))


def test_another_process_gives_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    inside = triangulate(NODES)
    monkeypatch.setattr(triangulation, "WORTH_A_PROCESS", 100)
    called: list[int] = []

    def counted(nodes: np.ndarray) -> np.ndarray | None:
        called.append(len(nodes))
        return outside.delaunay_outside(nodes)

    monkeypatch.setattr(triangulation, "delaunay_outside", counted)
    found = triangulate(NODES)
    assert called == [500]
    assert np.array_equal(found.start, inside.start)
    assert np.array_equal(found.twin, inside.twin)


@pytest.mark.parametrize("executable", ["", "/nowhere/python", "/bin/false"])
def test_without_such_a_process_the_work_is_done_here(
    executable: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(triangulation, "WORTH_A_PROCESS", 100)
    monkeypatch.setattr(sys, "executable", executable)
    assert outside.delaunay_outside(NODES) is None
    assert triangulate(NODES).real > 900
