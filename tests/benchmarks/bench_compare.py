"""Arrays to measures against the same by SciPy, side by side."""

import math

from surfcmp_core.comparing.request import compare
from tests.benchmarks.by_scipy import mean_abs
from tests.benchmarks.surfaces import uniform_surface
from tests.benchmarks.timing import seconds


def _row(count: int, scipy_count: int) -> None:
    pair = uniform_surface(count, 1), uniform_surface(count, 2)
    peer = uniform_surface(scipy_count, 1), uniform_surface(scipy_count, 2)
    ours, theirs = seconds(
        lambda: compare(*pair, domain="hull"), lambda: mean_abs(*peer), repeats=3
    )
    note = ""
    if scipy_count != count:
        factor = count * math.log(count) / (scipy_count * math.log(scipy_count))
        theirs *= factor
        note = f" (timed at {scipy_count} + {scipy_count} nodes, scaled by N log N)"
    print(
        f"{count} + {count} nodes: {ours:.3f} s, SciPy {theirs:.2f} s{note}: "
        f"{theirs / ours:.1f} times faster"
    )


if __name__ == "__main__":
    small = uniform_surface(2000, 1), uniform_surface(2000, 2)
    found = compare(*small, domain="hull").measures.mean_abs
    print(f"mean |d| at 2000 + 2000 nodes: {found:.12g}, SciPy {mean_abs(*small):.12g}")
    _row(100_000, 100_000)
    _row(1_000_000, 200_000)
