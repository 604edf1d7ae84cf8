"""Seek what breaks the program: pairs of grids, and whole comparisons of files with options.

``python -m tests.fuzz --pairs N --trials N --seed S --seconds T`` ends after so many pairs and
trials or T seconds, whichever comes first, or never where none is given; with one of the two
numbers the other kind is left out. What fails, made as small as leaving out makes it, is written
to the folder of fixtures, from where a test tries it again; then the exit status is 1.

With NUMBA_BOUNDSCHECK=1, and NUMBA_CACHE_DIR set to an empty folder, a kernel that leaves its
arrays is a failure too.
"""

import argparse
import os
import re
import sys
import threading
import time
from itertools import count
from pathlib import Path

from tests.fuzz import merging

FOLDER = Path(__file__).parents[1] / "core" / "fixtures"
PAIRS_A_TRIAL = 20
"""Where both are sought; a trial takes as long as some ten pairs."""


class _Watch:
    """Ends the process, naming what it was at, where a kernel does not come back."""

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


def _try_pair(number: int, seed: int, watch: _Watch) -> bool:
    pair, own, name = merging.random_pair(number, seed)
    watch.begins(name)
    fault = merging.fault_of(pair, own)
    if fault:
        print(f"{name}: {fault}\n  {merging.keep(pair, own, FOLDER)}", flush=True)
    return not fault


def _try_trial(number: int, seed: int, watch: _Watch) -> bool:
    from tests.fuzz.checking import fault_of, has_fault
    from tests.fuzz.trials import random_trial, smaller

    own = 1_000_000 * (seed + 1) + number
    watch.begins(f"random_trial({own})")
    trial = random_trial(own)
    fault = fault_of(trial)
    if fault:
        least = smaller(trial, lambda one: has_fault(one, fault))
        word = "_".join(re.findall(r"[A-Za-z]+", fault)[:5]).lower()
        path = FOLDER / f"trial_{word}_{own}.json"
        least.save(path)
        print(f"{watch.name}: {fault}\n  {fault_of(least)}\n  {path}", flush=True)
    return not fault


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--pairs", type=int, metavar="N", help="how many pairs of grids at most")
    parser.add_argument("--trials", type=int, metavar="N", help="how many trials at most")
    parser.add_argument("--seconds", type=float, metavar="T", help="how long at most")
    parser.add_argument("--seed", type=int, default=0, metavar="S", help="where to begin")
    chosen = parser.parse_args()

    limits = [chosen.pairs, chosen.trials]
    if any(limit is not None for limit in limits):
        limits = [limit or 0 for limit in limits]
    done, failures = [0, 0], 0
    begin = told = time.monotonic()
    watch = _Watch()
    for step in count():
        now = time.monotonic()
        kind = 1 if step % (PAIRS_A_TRIAL + 1) == PAIRS_A_TRIAL else 0
        open_ = [limit is None or made < limit for made, limit in zip(done, limits, strict=True)]
        over = chosen.seconds is not None and now - begin >= chosen.seconds
        if now - told >= 10.0 or over or not any(open_) or failures >= 20:
            told = now
            print(
                f"{done[0]} pairs and {done[1]} trials in {now - begin:.0f} s, {failures} failures",
                flush=True,
            )
        if over or not any(open_) or failures >= 20:
            break
        if not open_[kind]:
            kind = 1 - kind
        works = (_try_pair, _try_trial)
        failures += not works[kind](done[kind], chosen.seed, watch)
        done[kind] += 1
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
