"""Compare merges with the triangulation of the union on ever new pairs of grids.

``python -m tests.fuzz --pairs N --seed S --seconds T`` ends after N pairs or T seconds, whichever
comes first, or never where neither is given. Each failing pair, made as small as simple removal
makes it, is written to the folder of fixtures; then the exit status is 1.

With NUMBA_BOUNDSCHECK=1, and NUMBA_CACHE_DIR set to an empty folder, a kernel that leaves its
arrays is a failure too.
"""

import argparse
import os
import sys
import threading
import time
from collections.abc import Callable
from functools import partial
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
        return f"{type(error).__name__}: {error}"
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


def _is_bad(pair: Pair, *, seed: int) -> bool:
    return bool(fails(pair, seed))


class _Watch:
    """Ends the process, naming the pair, where a kernel does not come back."""

    def __init__(self, seconds: float = 300.0) -> None:
        self.name = ""
        self._since = time.monotonic()
        self._seconds = seconds
        threading.Thread(target=self._look, daemon=True).start()

    def begins(self, name: str) -> None:
        self.name = name
        self._since = time.monotonic()

    def _look(self) -> None:
        while True:
            time.sleep(1.0)
            if time.monotonic() - self._since > self._seconds:
                print(f"{self.name}: hangs", flush=True)
                os._exit(1)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--pairs", type=int, metavar="N", help="how many pairs at most")
    parser.add_argument("--seconds", type=float, metavar="T", help="how long at most")
    parser.add_argument("--seed", type=int, default=0, metavar="S", help="where to begin")
    chosen = parser.parse_args()

    families = list(FAMILIES)
    found = 0
    begin = told = time.monotonic()
    watch = _Watch()
    for done in count():
        now = time.monotonic()
        rate = done / max(now - begin, 1e-9)
        if (
            (chosen.pairs is not None and done >= chosen.pairs)
            or (chosen.seconds is not None and now - begin >= chosen.seconds)
            or found >= 20
        ):
            print(f"{done} pairs in {now - begin:.0f} s, {found} failures", flush=True)
            break
        if now - told >= 10.0:
            told = now
            print(f"{done} pairs, {rate:.0f} a second, {found} failures", flush=True)
        family = families[done % len(families)]
        seed = 1_000_000 * (chosen.seed + 1) + done // len(families)
        most = _SIZES[seed % len(_SIZES)]
        watch.begins(f"pair_of({family!r}, {seed}, most={most})")
        pair = pair_of(family, seed, most=most)
        fault = fails(pair, seed)
        if fault:
            found += 1
            is_bad = partial(_is_bad, seed=seed)
            least = smaller(pair, is_bad)
            path = FOLDER / f"found_{family}_{seed}.json"
            least.save(path)
            print(f"{watch.name}: {fault}\n  {path}", flush=True)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
