"""Random trials of the whole program; those that once broke it; how a find is made small."""

from functools import partial
from pathlib import Path

import pytest

from tests.fuzz import checking, merging
from tests.fuzz.checking import check, fault_of, has_fault
from tests.fuzz.shrinking import fewer
from tests.fuzz.trials import load, random_trial, smaller
from tests.pairs import pair_of

pytestmark = pytest.mark.plain

FIXTURES = sorted((Path(__file__).parent / "fixtures").glob("trial_*.json"))


SLOW = {39, 44, 50, 57}
"""Trials that ask for much where kernels are not compiled."""


@pytest.mark.parametrize(
    "seed", [pytest.param(k, marks=pytest.mark.large) if k in SLOW else k for k in range(60)]
)
def test_a_random_trial(seed: int) -> None:
    check(random_trial(seed))


def test_what_once_broke_a_trial() -> None:
    for path in FIXTURES:
        assert fault_of(load(path)) == "", path.name


def test_a_trial_is_kept_to_the_last_bit(tmp_path: Path) -> None:
    for seed in range(20):
        trial = random_trial(seed)
        trial.save(tmp_path / "trial.json")
        assert load(tmp_path / "trial.json") == trial


def test_fewer_items_show_the_same() -> None:
    assert fewer(range(1000), lambda some: {3, 500, 999} <= set(some)) == [3, 500, 999]
    assert fewer([1, 2], lambda some: True) == []
    assert fewer([1, 2], lambda some: False) == [1, 2]


def test_a_trial_is_made_as_small_as_its_fault_allows(monkeypatch: pytest.MonkeyPatch) -> None:
    """A reading that is wrong where something lies high is found with the one high node."""
    right = checking.read_surface

    def wrong(path: Path, *, unit: str | None = None) -> object:
        surface = right(path, unit=unit)
        surface.points[surface.points[:, 2] > 1.0, 2] = 1.0
        return surface

    monkeypatch.setattr(checking, "read_surface", wrong)
    faults = 0
    for seed in range(40):
        trial = random_trial(seed)
        fault = fault_of(trial)
        if not fault:
            continue
        faults += 1
        least = smaller(trial, partial(has_fault, fault=fault))
        assert has_fault(least, fault)
        assert sum(len(model.points) for model in least.models) <= 8
        assert len(least.options) <= 1
        if faults == 3:
            return
    raise AssertionError("no trial has found the fault")


def test_a_pair_is_made_small() -> None:
    pair = pair_of("uniform", 3, most=60)
    least = merging.smaller(pair, lambda one: bool((one.first[:, 0] > 0.5).any()))
    assert len(least.first) == len(least.second) == 3
