"""Nothing that counts goes through arithmetic that rounds as the processor likes."""

import ast
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import surfcmp_core
from surfcmp_core.compiled import linear_algebra

CORE = Path(surfcmp_core.__file__).parent
MODULES = sorted(CORE.rglob("*.py"))

FORBIDDEN = {
    # BLAS and LAPACK: fused or not, in blocks of this or that size, by kind of processor
    *("linalg", "dot", "vdot", "inner", "outer", "matmul", "einsum", "tensordot", "vecdot"),
    *("matvec", "vecmat", "kron", "cov", "corrcoef", "polyfit", "lstsq"),
    # functions of libraries that differ in the last bit between processors and systems
    *("sin", "cos", "tan", "arcsin", "arccos", "arctan", "arctan2", "asin", "acos", "atan"),
    *("atan2", "sinh", "cosh", "tanh", "exp", "exp2", "expm1", "log", "log2", "log10", "log1p"),
    *("pow", "float_power", "hypot", "cbrt"),
}
HARMLESS = {
    "alignment/account.py": {"atan2"},  # an angle that is rounded
    "io/triangles.py": {"**", "arctan2"},  # whole numbers; turns, to a billionth of one
    "io/stated_units.py": {"**"},  # fractions: exact
    "report/numbers.py": {"acos", "log10"},  # an angle that is shown, and with how many digits
    "comparing/verification/check_sums.py": {"hypot"},  # which corner of a triangle to measure from
    "comparing/verification/check_united.py": {"hypot"},  # lengths that are compared within bounds
    "colours/scale.py": {"log10"},  # round ends of a scale of colours
}


def used(path: Path) -> set[str]:
    """Name the functions of numpy and math, and the operators, that round as they like."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        operator = getattr(node, "op", None)
        if isinstance(operator, ast.MatMult):
            found.add("@")
        elif isinstance(operator, ast.Pow) and isinstance(node, ast.BinOp):
            # of whole numbers and of constants it is exact, and the fourth root of two nobody takes
            constant = ast.unparse(node.left).replace(".", "").isdigit()
            found |= set() if constant else {"**"}
        elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            if node.value.id in {"np", "numpy", "math"} and node.attr in FORBIDDEN:
                found.add(node.attr)
        elif isinstance(node, ast.ImportFrom) and node.module in {"numpy", "math", "numpy.linalg"}:
            found |= {alias.name for alias in node.names} & FORBIDDEN
    return found


@pytest.mark.parametrize("path", MODULES, ids=lambda p: str(p.relative_to(CORE)))
def test_core_uses_no_arithmetic_that_depends_on_the_processor(path: Path) -> None:
    assert used(path) <= HARMLESS.get(path.relative_to(CORE).as_posix(), set())


def test_what_is_allowed_is_there() -> None:
    for name, allowed in HARMLESS.items():
        assert used(CORE / name) == allowed


numbers = st.floats(-10.0, 10.0).map(lambda v: 0.0 if abs(v) < 1e-6 else v)


@settings(max_examples=200)
@given(st.integers(1, 6), st.data())
def test_eigenvectors_take_a_matrix_apart(size, data):
    drawn = data.draw(st.lists(numbers, min_size=size * size, max_size=size * size))
    matrix = np.array(drawn).reshape(size, size)
    matrix = matrix + matrix.T
    values, vectors = linear_algebra.eigen(matrix)
    assert (np.diff(values) >= 0.0).all()
    np.testing.assert_allclose(vectors.T @ vectors, np.eye(size), atol=1e-14)
    scale = max(1.0, np.abs(matrix).max())
    np.testing.assert_allclose(vectors * values @ vectors.T, matrix, atol=1e-13 * scale)
    np.testing.assert_allclose(values, np.linalg.eigvalsh(matrix), atol=1e-13 * scale)


def test_eigenvectors_of_a_diagonal_are_the_axes_to_the_last_bit():
    values, vectors = linear_algebra.eigen(np.diag([3.0, 1e-30, 2.0]))
    np.testing.assert_array_equal(values, [1e-30, 2.0, 3.0])
    np.testing.assert_array_equal(vectors, np.eye(3)[:, [1, 2, 0]])


def test_shortest_of_all_solutions_is_taken():
    rng = np.random.default_rng(0)
    rows = rng.normal(size=(40, 6))
    rows[:, 5] = rows[:, 0] - 2.0 * rows[:, 1]  # one direction stays open
    weights, right = rng.random(40), rng.normal(size=6)
    matrix = linear_algebra.moments(rows, weights)
    np.testing.assert_allclose(matrix, rows.T * weights @ rows, rtol=1e-13)
    np.testing.assert_allclose(
        linear_algebra.least_solution(matrix, right, 1e-12),
        np.linalg.pinv(matrix, 1e-12, hermitian=True) @ right,
        rtol=1e-9,
        atol=1e-12,
    )


@given(st.lists(numbers, min_size=4, max_size=4).filter(any), st.data())
def test_motions_compose_and_invert(quaternion, data):
    turn = linear_algebra.rotation(quaternion)
    np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-14)
    assert np.linalg.det(turn) == pytest.approx(1.0)
    motion = np.eye(4)
    motion[:3, :3] = turn
    motion[:3, 3] = data.draw(st.lists(numbers, min_size=3, max_size=3))
    other = np.diag([-1.0, -1.0, 1.0, 1.0])
    back = linear_algebra.inverse(motion)
    np.testing.assert_allclose(linear_algebra.composed(back, motion), np.eye(4), atol=1e-13)
    np.testing.assert_array_equal(linear_algebra.composed(motion, np.eye(4)), motion + 0.0)
    points = np.arange(12.0).reshape(4, 3)
    np.testing.assert_allclose(
        linear_algebra.applied(linear_algebra.composed(motion, other), points),
        linear_algebra.applied(motion, linear_algebra.applied(other, points)),
        atol=1e-12,
    )
    np.testing.assert_allclose(linear_algebra.turned(points, turn), points @ turn.T, atol=1e-12)
