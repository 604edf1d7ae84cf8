"""Compare merges with the triangulation of the union on ever new pairs of grids.

``python -m tests.fuzz --pairs N --seed S --seconds T`` ends after N pairs or T seconds, whichever
comes first, or never where neither is given. Each failing pair, made as small as simple removal
makes it, is written to the folder of fixtures; then the exit status is 1.
"""

import argparse
import sys
import time
from collections.abc import Callable
from itertools import count
from pathlib import Path

import numpy as np

from tests.invariants import check_pair, check_unchanged
from tests.pairs import FAMILIES, Nodes, Pair, is_flat, pair_of

FOLDER = Path(__file__).parent / "core" / "fixtures"
_SIZES = (8, 20, 40, 40, 150)


def fails(pair: Pair, seed: int) -> str:
    """Say what is wrong with the merge of a pair; empty where nothing is."""
    try:
        merged = check_pair(pair)
        if seed % 4 == 0:
            check_unchanged(pair, merged, np.random.default_rng(seed))
    except Exception as error:  # whatever it is, it is a find
        return f"{type(error).__name__}: {error}" or type(error).__name__
    return ""


def smaller(pair: Pair, is_bad: Callable[[Pair], bool]) -> Pair:
    """Leave out nodes, many at a time and then one by one, as long as the pair stays bad."""

    def without(nodes: Nodes, begin: int, size: int) -> Nodes:
        return np.concatenate((nodes[:begin], nodes[begin + size :]))

    size = max(len(pair.first), len(pair.second)) // 2
    while size >= 1:
        changed = False
        for side in (0, 1):
            begin = 0
            while begin < len((pair.first, pair.second)[side]):
                sets = [pair.first, pair.second]
                sets[side] = without(sets[side], begin, size)
                trial = Pair(pair.name, *sets)
                if not any(is_flat(nodes) for nodes in sets) and is_bad(trial):
                    pair, changed = trial, True
                else:
                    begin += size
        if not changed or size > 1:
            size //= 2
    return pair


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--pairs", type=int, metavar="N", help="how many pairs at most")
    parser.add_argument("--seconds", type=float, metavar="T", help="how long at most")
    parser.add_argument("--seed", type=int, default=0, metavar="S", help="where to begin")
    chosen = parser.parse_args()

    families = list(FAMILIES)
    found = 0
    begin = told = time.monotonic()
    done = 0
    for done in count():
        now = time.monotonic()
        if chosen.pairs is not None and done >= chosen.pairs:
            break
        if chosen.seconds is not None and now - begin >= chosen.seconds:
            break
        if now - told >= 10.0:
            told = now
            print(
                f"{done} pairs, {done / (now - begin):.0f} a second, {found} failures", flush=True
            )
        family = families[done % len(families)]
        seed = 1_000_000 * (chosen.seed + 1) + done // len(families)
        pair = pair_of(family, seed, most=_SIZES[seed % len(_SIZES)])
        fault = fails(pair, seed)
        if fault:
            found += 1
            least = smaller(pair, lambda trial, seed=seed: bool(fails(trial, seed)))
            path = FOLDER / f"found_{family}_{seed}.json"
            least.save(path)
            print(f"{pair.name}: {fault}\n  {path}", flush=True)
            if found >= 20:
                break
    print(f"{done} pairs in {time.monotonic() - begin:.0f} s, {found} failures")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
