"""Numbers as text that gives back every bit: the shortest decimals, as Python's `repr` has them.

Python needs half a microsecond for each; a table of a million triangles has five million.
"""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.kernel import inlined, kernel

ROOM = 25
"""Octets that a number takes at most."""

_LEAST, _MOST = -292, 324
"""Powers of ten that scale a double to 17 digits."""
_U = np.uint64
_LOW = _U(0xFFFFFFFF)
_MINUS, _POINT, _ZERO, _PLUS, _E = b"-.0+e"


def _powers_of_ten() -> NDArray[np.uint64]:
    """Give 10**k, rounded up to 128 bits of which the first is set: high and low half."""
    powers = np.empty((_MOST - _LEAST + 1, 2), np.uint64)
    for row, k in enumerate(range(_LEAST, _MOST + 1)):
        shift = 127 - ((k * 1741647) >> 19)  # floor(log2(10**k))
        over, under = 10 ** max(k, 0) << max(shift, 0), 10 ** max(-k, 0) << max(-shift, 0)
        power = -(-over // under)
        powers[row] = power >> 64, power & (2**64 - 1)
    return powers


_POWERS = _powers_of_ten()


@inlined
def _product(a: np.uint64, b: np.uint64) -> tuple[np.uint64, np.uint64]:
    """High and low half of the product of 64 by 64 bits."""
    a1, a0, b1, b0 = a >> _U(32), a & _LOW, b >> _U(32), b & _LOW
    middle = a1 * b0 + (a0 * b0 >> _U(32))
    carried = a0 * b1 + (middle & _LOW)
    return a1 * b1 + (middle >> _U(32)) + (carried >> _U(32)), a * b


@inlined
def _scaled(high: np.uint64, low: np.uint64, factor: np.uint64) -> np.uint64:
    """Product with a power of ten, rounded to odd: its last bit tells that something is cut off."""
    y1, y0 = _product(high, factor)
    x1, _ = _product(low, factor)
    total = y0 + x1
    if total < x1:
        y1 += _U(1)
    return y1 | _U(1) if total > _U(1) else y1


@kernel
def _shortest(bits: np.uint64) -> tuple[np.uint64, int]:
    """Digits d and exponent k of the shortest d * 10**k that is read as this positive double.

    Of the shortest ones the nearest. `bits` are those of the double, neither zero nor infinite.

    References
    ----------
    Giulietti 2020, The Schubfach way to render doubles, figure 4.
    """
    fraction, exponent = bits & _U(0xFFFFFFFFFFFFF), np.int64(bits >> _U(52))
    c, q = fraction | _U(1 << 52), exponent - 1075
    if exponent == 0:
        c, q = fraction, np.int64(-1074)
    elif -53 < q <= 0 and c & ((_U(1) << _U(-q)) - _U(1)) == 0:
        return c >> _U(-q), 0
    closer = fraction == 0 and exponent > 1  # the next smaller double is nearer than the larger
    k = int((q * 1262611 - (524031 if closer else 0)) >> 22)
    shift = _U(q + ((-k * 1741647) >> 19) + 1)
    high, low = _POWERS[-k - _LEAST, 0], _POWERS[-k - _LEAST, 1]
    open_end = c & _U(1)  # halfway doubles are read as even ones
    lower = _scaled(high, low, (_U(4) * c - _U(1 if closer else 2)) << shift) + open_end
    middle = _scaled(high, low, (_U(4) * c) << shift)
    upper = _scaled(high, low, (_U(4) * c + _U(2)) << shift) - open_end
    s = middle >> _U(2)
    if s >= _U(10):
        tens = s // _U(10)
        below, above = lower <= _U(40) * tens, _U(40) * tens + _U(40) <= upper
        if below != above:
            return tens + _U(above), k + 1
    below, above = lower <= _U(4) * s, _U(4) * s + _U(4) <= upper
    if below != above:
        return s + _U(above), k
    half = _U(4) * s + _U(2)
    return s + _U(middle > half or (middle == half and s & _U(1) == _U(1))), k


@inlined
def _put_whole(number: np.uint64, text: NDArray[np.uint8], at: int) -> int:
    end = at
    rest = number
    while True:
        end += 1
        rest //= _U(10)
        if rest == _U(0):
            break
    for place in range(end - 1, at - 1, -1):
        text[place] = _ZERO + np.int64(number % _U(10))
        number //= _U(10)
    return end


@kernel
def put_integer(number: int, text: NDArray[np.uint8], at: int) -> int:
    """Write an int64 to text[at:]; return where it ends."""
    if number < 0:
        text[at] = _MINUS
        return _put_whole(_U(0) - _U(number), text, at + 1)
    return _put_whole(_U(number), text, at)


@kernel
def put_real(bits: np.uint64, text: NDArray[np.uint8], at: int) -> int:
    """Write the finite double of these bits to text[at:]; return where it ends."""
    if bits >> _U(63):
        text[at] = _MINUS
        at += 1
        bits &= _U(0x7FFFFFFFFFFFFFFF)
    digits, exponent = _U(0), 0
    if bits:
        digits, exponent = _shortest(bits)
        while digits % _U(10) == _U(0):
            digits //= _U(10)
            exponent += 1
    end = _put_whole(digits, text, at)
    count = end - at
    point = count + exponent  # digits ahead of the point
    if -4 < point <= 0:  # 0.00ddd
        for k in range(count - 1, -1, -1):
            text[at + 2 - point + k] = text[at + k]
        text[at : at + 2 - point] = _ZERO
        text[at + 1] = _POINT
        return end + 2 - point
    if 0 < point <= 16:
        if point >= count:  # ddd00.0
            text[end : at + point] = _ZERO
            text[at + point] = _POINT
            text[at + point + 1] = _ZERO
            return at + point + 2
        for k in range(end, at + point, -1):  # dd.ddd
            text[k] = text[k - 1]
        text[at + point] = _POINT
        return end + 1
    if count > 1:  # d.ddde-05
        for k in range(end, at + 1, -1):
            text[k] = text[k - 1]
        text[at + 1] = _POINT
        end += 1
    text[end] = _E
    text[end + 1] = _PLUS if point > 0 else _MINUS
    power = abs(point - 1)
    if power < 10:
        text[end + 2] = _ZERO
        end += 1
    return _put_whole(_U(power), text, end + 2)
