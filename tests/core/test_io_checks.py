"""Collinearity is decided exactly."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.io.checks import check_nodes


def _on_one_line(points: NDArray[np.float64]) -> bool:
    """By rationals: the slow, obvious way."""
    first, *rest = [[Fraction(value) for value in point] for point in points.tolist()]
    steps = [[b - a for a, b in zip(first, point, strict=True)] for point in rest]
    axis = next((step for step in steps if any(step)), [Fraction(0)] * 3)
    return all(
        axis[i] * step[j] == axis[j] * step[i] for step in steps for i in range(3) for j in range(i)
    )


def _refused(points: NDArray[np.float64]) -> bool:
    fault = ""
    try:
        check_nodes(points)
    except InputError as error:
        fault = str(error)
    assert fault == "" or fault.endswith(("on one line", "at one place"))
    return fault != ""


steps = st.tuples(*[st.integers(-(2**40), 2**40)] * 3)
times = st.tuples(st.integers(-9, 9), st.integers(-60, 60)).map(lambda one: one[0] * 2.0 ** one[1])
scales = st.integers(-1000, 900).map(lambda exponent: 2.0**exponent)


# Most are exactly on one line, while what floats make of it is noise.
@given(steps, st.lists(times, min_size=3, max_size=9), scales, st.booleans())
def test_multiples_of_one_step(
    step: tuple[int, ...], times: list[float], scale: float, nudged: bool
):
    points = np.outer(times, np.array(step)) * scale
    if nudged:
        points[-1, 0] = np.nextafter(points[-1, 0], np.inf)
    assert _refused(points) == _on_one_line(points)


@given(st.lists(st.tuples(*[st.floats(-1e308, 1e308)] * 3), min_size=3, max_size=5).map(np.array))
def test_any_nodes(points: NDArray[np.float64]):
    assert _refused(points) == _on_one_line(points)


def test_the_last_of_many_decides():
    points = np.outer(np.arange(20_000), [1.0, 2.0, 3.0])
    assert _refused(points)
    points[-1, 2] = np.nextafter(points[-1, 2], 0)
    assert not _refused(points)


def test_noise_below_the_least_float_is_no_bend():
    times = [-274877906936.0, 0, -0.1875]
    assert _refused(np.outer(times, [8135.0, 5610.0, 7747.0]) * 2.0**-564)


@pytest.mark.parametrize("count", [0, 1, 2])
def test_too_few(count: int):
    with pytest.raises(InputError, match=f"it holds {count} nodes; three or more are needed"):
        check_nodes(np.eye(3)[:count])
