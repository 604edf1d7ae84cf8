"""Slow, obvious and exact: what the kernels are held against.

All numbers are whole numbers of one unit so small that every coordinate is a multiple of it
(`exact`), or fractions; nothing is ever rounded.
"""

from collections.abc import Iterable
from fractions import Fraction
from itertools import combinations, pairwise, permutations
from typing import Any

import numpy as np
from numpy.typing import NDArray

Place = tuple[int, int]
Triple = tuple[int, int, int]


def exact(values: NDArray[np.float64]) -> NDArray[np.object_]:
    """Python integers proportional to floating-point numbers, by one power of two."""
    values = np.asarray(values, np.float64)
    part, power = np.frexp(values)
    digits = np.ldexp(part, 53).astype(np.int64)
    lowest = int(power[values != 0.0].min(initial=0)) if (values != 0.0).any() else 0
    power = np.where(values == 0.0, lowest, power) - lowest
    return np.asarray(digits.astype(object) << power.astype(object))


def places(nodes: NDArray[np.float64]) -> list[Place]:
    return [(x, y) for x, y in exact(nodes).tolist()]


def sign(value: Any) -> Any:
    """-1, 0 or 1; also of arrays."""
    if isinstance(value, np.ndarray):
        return (value > 0).astype(int) - (value < 0).astype(int)
    return (value > 0) - (value < 0)


def orientation(ax: Any, ay: Any, bx: Any, by: Any, cx: Any, cy: Any) -> Any:
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)


def in_circle(ax: Any, ay: Any, bx: Any, by: Any, cx: Any, cy: Any, px: Any, py: Any) -> Any:
    """Positive where p is inside the circle through the counter-clockwise a, b, c."""
    ax, ay, bx, by, cx, cy = ax - px, ay - py, bx - px, by - py, cx - px, cy - py
    a, b, c = ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy
    return ax * (by * c - b * cy) - ay * (bx * c - b * cx) + a * (bx * cy - by * cx)


def compare_lengths(ax: Any, ay: Any, bx: Any, by: Any, cx: Any, cy: Any, dx: Any, dy: Any) -> Any:
    return (ax - bx) ** 2 + (ay - by) ** 2 - (cx - dx) ** 2 - (cy - dy) ** 2


def scalar_product(ax: Any, ay: Any, bx: Any, by: Any, cx: Any, cy: Any, dx: Any, dy: Any) -> Any:
    return (bx - ax) * (dx - cx) + (by - ay) * (dy - cy)


def compare_tangent_circles(
    vx: Any, vy: Any, ux: Any, uy: Any, ax: Any, ay: Any, bx: Any, by: Any
) -> Any:
    """Difference of the two radii times a positive number.

    The centre v + s (u - v) is as far from v as from a: s = |a - v|² / (2 (a - v)·(u - v)).
    """
    wx, wy, ax, ay, bx, by = ux - vx, uy - vy, ax - vx, ay - vy, bx - vx, by - vy
    return (ax * ax + ay * ay) * (bx * wx + by * wy) - (bx * bx + by * by) * (ax * wx + ay * wy)


Polynomial = list[int]
"""Coefficients, that of the lowest power of the infinitesimal first."""


def _product(p: Polynomial, q: Polynomial) -> Polynomial:
    out = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            out[i + j] += a * b
    return out


def _determinant(rows: list[list[Polynomial]]) -> Polynomial:
    """By Leibniz' formula."""
    total = [0] * 16
    for order in permutations(range(len(rows))):
        swaps = sum(a > b for a, b in combinations(order, 2))
        term: Polynomial = [(-1) ** swaps]
        for row, column in enumerate(order):
            term = _product(term, rows[row][column])
        for power, coefficient in enumerate(term):
            total[power] += coefficient
    return total


def in_disc(a: Place, b: Place, c: Place, p: Place) -> bool:
    """Whether p lies in the disc of the counter-clockwise a, b, c under perturbation.

    Every node (x, y) is lifted to x² + y² + ε^k, k counting from the lexicographically last node
    back; p is in the disc where its lifted node is below the plane of the other three.
    """
    side = in_circle(*a, *b, *c, *p)
    if side != 0:
        return bool(side > 0)
    four = (a, b, c, p)
    rank = {node: k for k, node in enumerate(sorted(four, reverse=True), start=1)}
    rows: list[list[Polynomial]] = []
    for x, y in four:
        lift = [x * x + y * y] + [0] * rank[x, y]
        lift[rank[x, y]] = 1
        rows.append([[x], [y], lift, [1]])
    # the determinant of the rows (x, y, lift, 1) is positive where p is below
    return next(c for c in _determinant(rows) if c != 0) > 0


def delaunay(nodes: NDArray[np.float64]) -> set[Triple]:
    """All triangles whose discs hold no node, lowest node first, counter-clockwise."""
    at = places(nodes)
    found = set()
    for triple in combinations(range(len(at)), 3):
        a, b, c = triple
        side = orientation(*at[a], *at[b], *at[c])
        if side == 0:
            continue
        if side < 0:
            b, c = c, b
        if not any(in_disc(at[a], at[b], at[c], at[d]) for d in range(len(at)) if d not in triple):
            found.add((a, b, c))
    return found


def hull_area(nodes: NDArray[np.float64]) -> int:
    """Twice the area of the convex hull (Andrew 1979)."""
    at = sorted(places(nodes))
    hull: list[Place] = []
    for way in (at, at[::-1]):
        part: list[Place] = []
        for p in way:
            while len(part) > 1 and orientation(*part[-2], *part[-1], *p) <= 0:
                part.pop()
            part.append(p)
        hull += part[:-1]
    return int(sum(orientation(*hull[0], *p, *q) for p, q in pairwise(hull)))


def squares(nodes: NDArray[np.float64], ends: Iterable[tuple[int, int]]) -> list[int]:
    """Squared lengths of edges."""
    at = places(nodes)
    return [(at[a][0] - at[b][0]) ** 2 + (at[a][1] - at[b][1]) ** 2 for a, b in ends]


def shortest_tree(nodes: NDArray[np.float64]) -> list[tuple[int, int]]:
    """Minimum spanning tree of the complete graph (Kruskal 1956)."""
    pairs = list(combinations(range(len(nodes)), 2))
    part = list(range(len(nodes)))
    tree = []
    for _, (a, b) in sorted(zip(squares(nodes, pairs), pairs, strict=True)):
        p, q = part[a], part[b]
        if p != q:
            tree.append((a, b))
            part = [p if k == q else k for k in part]
    return tree


def chains(triangles: list[Triple], label: list[int]) -> list[tuple[frozenset[int], bool]]:
    """Chains of a labelled triangulation: sets of triangle numbers, and whether each is closed.

    Interface triangles with a common interface edge belong to one chain; it is closed where each
    has two such neighbours.
    """
    at_edge: dict[frozenset[int], list[int]] = {}
    neighbours: dict[int, list[int]] = {}
    for t, corners in enumerate(triangles):
        for edge in combinations(corners, 2):
            if {label[k] for k in edge} == {1, 2}:
                at_edge.setdefault(frozenset(edge), []).append(t)
                neighbours[t] = []
    for sides in at_edge.values():
        if len(sides) == 2:
            neighbours[sides[0]].append(sides[1])
            neighbours[sides[1]].append(sides[0])
    found = []
    left = set(neighbours)
    while left:
        chain: set[int] = set()
        reached = [min(left)]
        while reached:
            t = reached.pop()
            if t not in chain:
                chain.add(t)
                reached += neighbours[t]
        left -= chain
        found.append((frozenset(chain), all(len(neighbours[t]) == 2 for t in chain)))
    return found


def weights_in(a: Place, b: Place, c: Place, p: Place) -> tuple[Fraction, Fraction, Fraction]:
    """Barycentric coordinates of p."""
    whole = orientation(*a, *b, *c)
    return (
        Fraction(orientation(*p, *b, *c), whole),
        Fraction(orientation(*a, *p, *c), whole),
        Fraction(orientation(*a, *b, *p), whole),
    )
