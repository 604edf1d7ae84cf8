"""Sets of nodes, moved as data is met, against a part of themselves and a copy beside them."""

from collections.abc import Iterator
from fractions import Fraction

import numpy as np

from surfcmp_core import Surface, compare
from surfcmp_core.comparing.verification import check_chains
from surfcmp_core.errors import InputError
from surfcmp_core.grid import safe_scale
from surfcmp_core.triangulation import triangulate
from tests.invariants import codes, ranks, same
from tests.pairs import Nodes, distinct, is_flat

ANGLE = 2.0**0.5
"""Radians: no lattice falls upon itself."""
MOTIONS = ("as is", "+1e6", "+1e8", "turned", "*1e-12", "*1e12")
FLAT = "all nodes lie on one line in the plane"
FEW = "at least 3 are needed"
NO_AREA = "no common area to compare"
"""So thin that no area is left in a number."""
OUTCOMES = (FEW, FLAT, NO_AREA)


def moved(nodes: Nodes, motion: str) -> Nodes:
    if motion.startswith("+"):
        return nodes + float(motion)
    if motion.startswith("*"):
        return nodes * float(motion[1:])
    if motion == "turned":
        x, y = nodes.T
        c, s = np.cos(ANGLE), np.sin(ANGLE)
        return np.column_stack((c * x - s * y, s * x + c * y))
    return nodes


def others(nodes: Nodes) -> Iterator[Nodes]:
    """Give a half of the nodes, and a copy a part of their spacing away."""
    rng = np.random.default_rng(len(nodes))
    some = rng.permutation(len(nodes))[: max(3, len(nodes) // 2)]
    yield nodes[np.sort(some)]
    step = np.ptp(nodes, axis=0) / max(1.0, len(nodes)) ** 0.5
    yield nodes + step * [0.37, 0.21]


def is_thin(nodes: Nodes) -> bool:
    """Whether nodes lie within a last bit of the line through those farthest apart."""
    ends = nodes[[nodes.sum(axis=1).argmin(), nodes.sum(axis=1).argmax()]]
    (ax, ay), (bx, by) = ((Fraction(x), Fraction(y)) for x, y in ends.tolist())
    places = [(Fraction(x) - ax, Fraction(y) - ay) for x, y in nodes.tolist()]
    away = max(abs((bx - ax) * y - (by - ay) * x) for x, y in places)
    return away <= Fraction(2) ** -50 * ((bx - ax) ** 2 + (by - ay) ** 2)


def outcome(first: Nodes, second: Nodes) -> str:
    """Compare two sets; check T and say "ok", or check the reason of the refusal and give it."""
    surfaces = [Surface(np.column_stack((p, np.zeros(len(p)))), unit="mm") for p in (first, second)]
    sets = [distinct(nodes) for nodes in (first, second)]
    expected = "ok"
    if any(len(nodes) < 3 for nodes in sets):
        expected = FEW
    elif any(is_flat(nodes) for nodes in sets):
        expected = FLAT
    try:
        result = compare(*surfaces, domain="plane", threads=1)
    except InputError as error:
        found = next((text for text in OUTCOMES if text in str(error)), str(error))
        if expected == "ok":
            assert found == NO_AREA
            assert is_thin(distinct(np.concatenate(sets)))
        else:
            assert found == expected
        return found
    assert expected == "ok"
    united = result.united
    count = len(united.nodes)
    given, known = (p[np.lexsort(p.T)] for p in (distinct(np.concatenate(sets)), united.nodes))
    assert np.array_equal(given, known)  # bit for bit, each once
    name = ranks(united.nodes)
    whole = triangulate(united.nodes * safe_scale(*sets)).triangles
    same(codes(united.triangles, name, count), codes(whole, name, count), "triangles of T")
    check_chains(united)
    assert np.isfinite(result.measures.rho_V)
    return expected
