"""The united triangulation against the triangulation of the union, family by family of pairs."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from tests.core import oracles
from tests.invariants import check_pair, check_unchanged, codes, merge, same
from tests.pairs import FAMILIES, load, pair_of

PAIRS = 420
"""Of each family: more than ten thousand in all."""

FIXTURES = sorted((Path(__file__).parent / "fixtures").glob("merge_*.json"))


@pytest.mark.parametrize("family", FAMILIES)
def test_merging_gives_the_triangulation_of_the_union(family: str) -> None:
    rng = np.random.default_rng(0)
    for seed in range(PAIRS):
        pair = pair_of(family, seed)
        try:
            merged = check_pair(pair)
            if seed % 4 == 0:
                check_unchanged(pair, merged, rng)
        except Exception as error:
            error.add_note(f"pair_of({family!r}, {seed})")
            raise


@pytest.mark.parametrize("family", FAMILIES)
def test_merging_gives_the_triangles_with_empty_discs(family: str) -> None:
    for seed in range(1000, 1008):
        pair = pair_of(family, seed, most=7)
        united = merge(pair.first, pair.second).united
        count = len(united.nodes)
        if count > 16:
            continue
        name = np.arange(count)
        expected = np.array(sorted(oracles.delaunay(united.nodes)), np.int32)
        same(codes(united.triangles, name, count), codes(expected, name, count), pair.name)


@pytest.mark.parametrize("family", ["uniform", "clusters_apart", "lattice", "nested", "rings"])
def test_merging_larger_grids(family: str) -> None:
    for seed in range(2000, 2006):
        pair = pair_of(family, seed, most=600)
        check_unchanged(pair, check_pair(pair), np.random.default_rng(seed))


def test_merging_interpreted() -> None:
    """Where indices out of range and overflowing integers do not pass in silence."""
    done = subprocess.run(
        [sys.executable, "-W", "error", "-m", "tests.fuzz", "--pairs", "96", "--seed", "7"],
        env=os.environ | {"NUMBA_DISABLE_JIT": "1"},
        cwd=Path(__file__).parents[2],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert "96 pairs" in done.stdout


@pytest.mark.parametrize("path", FIXTURES, ids=lambda path: path.stem)
def test_what_once_broke_the_merge(path: Path) -> None:
    pair = load(path)
    check_unchanged(pair, check_pair(pair), np.random.default_rng(0))
