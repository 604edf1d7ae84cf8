"""Extraction of the interface triangles against triangulating the union."""

import numpy as np
from triangular import delaunay

from surfcmp_core.grid import box_of, grid_of
from surfcmp_core.grid.curve import curve_keys
from surfcmp_core.interface import Joined, extract_chains, join
from surfcmp_core.spanning_tree import spanning_tree
from surfcmp_core.triangulation import triangulate
from surfcmp_core.triangulation.half_edges import half_edges
from tests.benchmarks.surfaces import uniform_surface
from tests.benchmarks.timing import seconds


def _fresh(joined: Joined, words: np.ndarray) -> Joined:
    np.copyto(joined.words, words)
    return joined


def _row(n1: int, n2: int) -> float:
    surfaces = uniform_surface(n1, 1), uniform_surface(n2, 2)
    box = box_of(*surfaces)
    grids = [grid_of(surface, box=box) for surface in surfaces]
    triangulations = [triangulate(grid.nodes) for grid in grids]
    trees = [spanning_tree(t) for t in triangulations]
    joined = join(*triangulations, *trees)
    words = joined.words.copy()
    both = np.concatenate([grid.nodes for grid in grids])
    both = both[np.argsort(curve_keys(both, box))]
    found = extract_chains(joined)

    def around() -> None:
        for t in triangulations:
            half_edges(t.triangles, len(t.nodes))
            spanning_tree(t)
        join(*triangulations, *trees)

    copy, whole, recorded, surroundings, union = seconds(
        lambda: _fresh(joined, words),
        lambda: extract_chains(_fresh(joined, words)),
        lambda: extract_chains(_fresh(joined, words), record=True),
        around,
        lambda: delaunay(both),
    )
    alone = whole - copy
    each = alone / len(found.base) * 1e9
    print(
        f"{n1} + {n2} nodes, {len(found.base)} interface triangles in {len(found.closed)} chains: "
        f"extraction {alone * 1e3:.1f} ms, {each:.0f} ns a triangle, "
        f"{union / alone:.2f} times faster than the union ({union * 1e3:.0f} ms); "
        f"with both trees, half-edges and joining {union / (alone + surroundings):.2f} times; "
        f"recording events {(recorded - copy) / alone:.2f} times as long"
    )
    return each


if __name__ == "__main__":
    each = {n: _row(n, n) for n in (10_000, 100_000, 1_000_000)}
    _row(1_000_000, 100_000)
    growth = each[1_000_000] / each[10_000]
    print(f"time for each triangle, 10 k to 1 M: grows {growth:.2f} times")
