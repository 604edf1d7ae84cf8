"""Closed forms against polygons cut and integrated in rationals."""

import itertools
from collections.abc import Callable
from fractions import Fraction

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from surfcmp_core.measures.triangle_area import triangle_area
from surfcmp_core.measures.triangle_integrals import (
    mean,
    mean_abs_weighted,
    mean_parts,
    mean_square,
    ordered,
    share_within,
)

pytestmark = pytest.mark.plain

Point = tuple[Fraction, Fraction, Fraction]  # barycentric
Linear = Callable[[Point], Fraction]

CORNERS: list[Point] = [
    (Fraction(1), Fraction(0), Fraction(0)),
    (Fraction(0), Fraction(1), Fraction(0)),
    (Fraction(0), Fraction(0), Fraction(1)),
]
ULP = Fraction(1, 2**52)


def linear(*values: float) -> Linear:
    exact = [Fraction(v) for v in values]
    return lambda p: sum((v * w for v, w in zip(exact, p, strict=True)), Fraction(0))


def clip(polygon: list[Point], f: Linear) -> list[Point]:
    """Keep the part with f ≥ 0."""
    kept: list[Point] = []
    for p, q in zip(polygon, polygon[1:] + polygon[:1], strict=True):
        at_p, at_q = f(p), f(q)
        if at_p >= 0:
            kept.append(p)
        if at_p * at_q < 0:
            s = at_p / (at_p - at_q)
            kept.append(tuple(a + s * (b - a) for a, b in zip(p, q, strict=True)))  # type: ignore[arg-type]
    return kept


def integrate(polygon: list[Point], f: Linear, g: Linear) -> Fraction:
    """∬ f g over a convex polygon, the whole triangle having area 1."""
    total = Fraction(0)
    for i in range(1, len(polygon) - 1):
        a, b, c = polygon[0], polygon[i], polygon[i + 1]
        area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
        fs, gs = [f(p) for p in (a, b, c)], [g(p) for p in (a, b, c)]
        products = sum((x * y for x, y in zip(fs, gs, strict=True)), Fraction(0))
        total += abs(area) * (products + sum(fs, Fraction(0)) * sum(gs, Fraction(0))) / 12
    return total


def one(_: Point) -> Fraction:
    return Fraction(1)


def halves(d: Linear) -> tuple[list[Point], list[Point]]:
    return clip(CORNERS, d), clip(CORNERS, lambda p: -d(p))


def close(got: float, exact: Fraction, ulps: int = 8, scale: Fraction | None = None) -> None:
    slack = ulps * ULP * abs(exact if scale is None else scale) + Fraction(5e-324) * 16
    assert abs(Fraction(got) - exact) <= slack, (got, float(exact))


near_one = st.integers(-3, 3).map(lambda k: 1.0 + k * 2.0**-52)
one_sided = st.one_of(
    st.sampled_from([0.0, 1.0, 2.0, 3.0, 1e-300, 1e300, 5e-324, 1e-9]),
    st.floats(1e-3, 1e3),
    st.floats(1e-290, 1e290),
    near_one,
    near_one.map(lambda v: v * 1e9),
)
nodal = st.one_of(one_sided, one_sided.map(lambda v: -v))
weights = st.one_of(st.sampled_from([0.0, 1.0]), st.floats(0.0, 8.0, allow_subnormal=False))


@given(nodal, nodal, nodal)
@example(-1.0, 0.0, 1.0)
@example(-1.0, 0.0, 0.0)
@example(0.0, 0.0, 0.0)
@example(-1e-300, 1e-300, 1e-300)
@example(-1e-300, 1e9, 1e9)
@example(1e9, 1e9 + 2e-7, 1e9)
def test_means_of_both_parts(a: float, b: float, c: float) -> None:
    d = linear(a, b, c)
    positive, negative = halves(d)
    above, below = mean_parts(*ordered(a, b, c))
    close(above, integrate(positive, d, one))
    close(below, -integrate(negative, d, one))
    largest = Fraction(max(abs(a), abs(b), abs(c)))
    close(mean(*ordered(a, b, c)), integrate(CORNERS, d, one), scale=largest)


@given(nodal, nodal, nodal)
@example(1e9, 1e9 + 2e-7, 1e9)
@example(-1.0, 1.0, 0.0)
def test_mean_square(a: float, b: float, c: float) -> None:
    largest = max(abs(a), abs(b), abs(c))
    if largest < 1e150 and (largest == 0.0 or largest > 1e-140):
        d = linear(a, b, c)
        close(mean_square(*ordered(a, b, c)), integrate(CORNERS, d, d))


@given(nodal, nodal, nodal, one_sided)
@example(0.5, 0.5, 0.5, 0.5)
@example(-0.5, 0.5, 0.5, 0.5)
@example(0.5, 0.5, 1.0, 0.5)
@example(-1.0, 1.0, 1.0, 1e-300)
@example(0.0, 0.0, 1.0, 0.0)
@example(0.0, 0.0, 0.0, 0.0)
@example(-2.0, 0.5, 3.0, 1.0)
def test_share_within(a: float, b: float, c: float, tolerance: float) -> None:
    d, t = linear(a, b, c), Fraction(tolerance)
    strip = clip(clip(CORNERS, lambda p: t - d(p)), lambda p: t + d(p))
    close(share_within(*ordered(a, b, c), tolerance), integrate(strip, one, one))


@given(nodal, nodal, nodal, weights, weights, weights)
@example(-1.0, 0.0, 1.0, 1.0, 2.0, 3.0)
@example(-1.0, 0.0, 2.0, 1.0, 2.0, 3.0)
@example(-2.0, 0.0, 0.0, 1.0, 2.0, 3.0)
@example(-2.0, 1.0, 5.0, 1.0, 0.0, 0.0)
@example(-1e-300, 1e9, 1e9, 1.0, 0.0, 0.0)
def test_mean_abs_weighted(a: float, b: float, c: float, p: float, q: float, r: float) -> None:
    d, weight = linear(a, b, c), linear(p, q, r)
    positive, negative = halves(d)
    exact = integrate(positive, d, weight) - integrate(negative, d, weight)
    close(mean_abs_weighted(a, b, c, p, q, r), exact, ulps=16)


@given(st.floats(-1e300, 1e300))
def test_a_constant_difference_is_exact(c: float) -> None:
    assert mean(c, c, c) == c
    assert mean_parts(c, c, c) == (max(c, 0.0), max(-c, 0.0))
    assert share_within(c, c, c, abs(c)) == 1.0
    if abs(c) < 1e150:
        assert mean_square(c, c, c) == c * c


@given(nodal, nodal, nodal, weights, weights, weights, one_sided)
@example(-1.0, 0.0, 1.0, 1.0, 2.0, 3.0, 0.3)
@example(-0.1, 0.0, 0.7, 0.1, 0.3, 0.7, 0.3)
@example(-0.7, 0.0, 0.7, 0.1, 0.3, 0.7, 0.3)
@example(-1.0, 1.0, 1.0, 0.1, 0.3, 0.7, 0.3)
@example(1.0, 1.0, 1.0, 0.1, 0.3, 0.7, 0.3)
def test_neither_order_nor_sign_matters(
    a: float, b: float, c: float, p: float, q: float, r: float, tolerance: float
) -> None:
    lo, mid, hi = ordered(a, b, c)
    above, below = mean_parts(lo, mid, hi)
    for (i, x), (j, y), (k, z) in itertools.permutations([(a, p), (b, q), (c, r)]):
        assert ordered(i, j, k) == (lo, mid, hi) == tuple(sorted((a, b, c)))
        expected = mean_abs_weighted(a, b, c, p, q, r)
        assert mean_abs_weighted(i, j, k, x, y, z) == expected
        assert mean_abs_weighted(-i, -j, -k, x, y, z) == expected
    turned = ordered(-a, -b, -c)
    assert mean_parts(*turned) == (below, above)
    assert mean(*turned) == -mean(lo, mid, hi)
    assert share_within(*turned, tolerance) == share_within(lo, mid, hi, tolerance)
    if max(abs(lo), abs(hi)) < 1e150:
        assert mean_square(*turned) == mean_square(lo, mid, hi)


coordinate = st.one_of(st.sampled_from([-0.7, -0.1, 0.3, 0.4, 1.1]), st.floats(-1e6, 1e6))


@given(coordinate, coordinate, coordinate, coordinate, coordinate, coordinate)
def test_area_does_not_depend_on_the_first_node(
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float
) -> None:
    area = triangle_area(ax, ay, bx, by, cx, cy)
    assert triangle_area(bx, by, cx, cy, ax, ay) == area
    assert triangle_area(cx, cy, ax, ay, bx, by) == area
    exact = (Fraction(bx) - Fraction(ax)) * (Fraction(cy) - Fraction(ay)) - (
        Fraction(cx) - Fraction(ax)
    ) * (Fraction(by) - Fraction(ay))
    reach = max(abs(v) for v in (bx - ax, by - ay, cx - ax, cy - ay))
    assert float(exact / 2) == pytest.approx(area, rel=0, abs=4e-15 * reach * reach + 1e-320)
