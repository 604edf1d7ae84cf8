"""Pairs of grids against the triangulation of their union."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np

from tests.fuzz.shrinking import fewer
from tests.invariants import check_pair, check_unchanged
from tests.pairs import FAMILIES, Nodes, Pair, is_flat, pair_of

_SIZES = (8, 20, 40, 40, 150)


def random_pair(number: int, seed: int) -> tuple[Pair, int, str]:
    """Give the pair of a number, the seed that its check takes, and how it is made again."""
    families = list(FAMILIES)
    family = families[number % len(families)]
    own = 1_000_000 * (seed + 1) + number // len(families)
    most = _SIZES[own % len(_SIZES)]
    return pair_of(family, own, most=most), own, f"pair_of({family!r}, {own}, most={most})"


def fault_of(pair: Pair, seed: int) -> str:
    """Say what is wrong with the merge of a pair; empty where nothing is."""
    try:
        merged = check_pair(pair)
        if seed % 4 == 0:
            check_unchanged(pair, merged, np.random.default_rng(seed))
    except Exception as error:  # whatever it is, it is a find
        return f"{type(error).__name__}: {error}"
    return ""


def keep(pair: Pair, seed: int, folder: Path) -> Path:
    """Write a failing pair, made as small as leaving out nodes makes it."""
    least = smaller(pair, lambda trial: bool(fault_of(trial, seed)))
    path = folder / f"merge_{pair.name.replace(' ', '_')}.json"
    least.save(path)
    return path


def smaller(pair: Pair, is_bad: Callable[[Pair], bool]) -> Pair:
    """Leave out nodes as long as the pair stays bad."""

    def shows(rows: list[Nodes], *, first: bool) -> bool:
        nodes = np.array(rows).reshape(-1, 2)
        trial = Pair(pair.name, *((nodes, pair.second) if first else (pair.first, nodes)))
        return not is_flat(nodes) and is_bad(trial)

    while True:
        before = len(pair.first) + len(pair.second)
        first = fewer(list(pair.first), partial(shows, first=True))
        pair = Pair(pair.name, np.array(first), pair.second)
        second = fewer(list(pair.second), partial(shows, first=False))
        pair = Pair(pair.name, pair.first, np.array(second))
        if len(pair.first) + len(pair.second) == before:
            return pair
