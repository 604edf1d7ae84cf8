"""Exact arithmetic on floating-point expansions [Shewchuk1997].

An expansion is an array of float64 whose exact sum is the number: components do not overlap, grow
in magnitude, and none is zero but in the expansion of zero itself, ``[0.0]``. Exact while no
product over- or underflows; `surfcmp_core.grid.safe_range` sees to that.
"""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel

Expansion = NDArray[np.float64]

_SPLITTER = 134217729.0  # 2**27 + 1 cuts a double into two halves of 26 bits


@kernel
def two_sum(a: float, b: float) -> tuple[float, float]:
    """Add two doubles: the rounded sum and what rounding dropped."""
    x = a + b
    b_virtual = x - a
    return x, (a - (x - b_virtual)) + (b - b_virtual)


@kernel
def two_product(a: float, b: float) -> tuple[float, float]:
    """Multiply two doubles: the rounded product and what rounding dropped."""
    x = a * b
    c = _SPLITTER * a
    a_high = c - (c - a)
    a_low = a - a_high
    c = _SPLITTER * b
    b_high = c - (c - b)
    b_low = b - b_high
    return x, a_low * b_low - (((x - a_high * b_high) - a_low * b_high) - a_high * b_low)


@kernel
def difference(a: float, b: float) -> Expansion:
    """Subtract two doubles exactly."""
    x, tail = two_sum(a, -b)
    if tail == 0.0:
        single = np.empty(1)
        single[0] = x
        return single
    double = np.empty(2)
    double[0] = tail
    double[1] = x
    return double


@kernel
def add(e: Expansion, f: Expansion) -> Expansion:
    """Add: merges by magnitude and sums with one running carry."""
    out = np.empty(e.size + f.size)
    count = 0
    i = 0
    j = 0
    carry = 0.0
    while i < e.size or j < f.size:
        if j == f.size or (i < e.size and abs(e[i]) < abs(f[j])):
            component = e[i]
            i += 1
        else:
            component = f[j]
            j += 1
        carry, tail = two_sum(carry, component)
        if tail != 0.0:
            out[count] = tail
            count += 1
    if carry != 0.0 or count == 0:
        out[count] = carry
        count += 1
    return out[:count]


@kernel
def scale(e: Expansion, b: float) -> Expansion:
    """Multiply by a double."""
    out = np.empty(2 * e.size)
    count = 0
    carry, tail = two_product(e[0], b)
    if tail != 0.0:
        out[count] = tail
        count += 1
    for i in range(1, e.size):
        high, low = two_product(e[i], b)
        middle, tail = two_sum(carry, low)
        if tail != 0.0:
            out[count] = tail
            count += 1
        carry, tail = two_sum(high, middle)
        if tail != 0.0:
            out[count] = tail
            count += 1
    if carry != 0.0 or count == 0:
        out[count] = carry
        count += 1
    return out[:count]


@kernel
def multiply(e: Expansion, f: Expansion) -> Expansion:
    """Multiply two expansions."""
    out = scale(e, f[0])
    for i in range(1, f.size):
        out = add(out, scale(e, f[i]))
    return out


@kernel
def subtract(e: Expansion, f: Expansion) -> Expansion:
    """Subtract f from e."""
    return add(e, -f)


@kernel
def leading(e: Expansion) -> float:
    """Return the largest component: it carries the sign of the whole."""
    return float(e[e.size - 1])


@kernel
def rounded(e: Expansion) -> float:
    """Return the whole but for its last bits; the largest component alone has but the first one."""
    total = 0.0
    for component in e:
        total += component
    return total
