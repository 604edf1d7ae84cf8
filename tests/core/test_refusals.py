"""What nothing can be computed with is refused in one line that names it, before any kernel."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from app.__main__ import main
from surfcmp_core import Surface, compare
from surfcmp_core.alignment import best_fit
from surfcmp_core.comparing.weight import read_weight
from surfcmp_core.errors import InputError
from surfcmp_core.projection.placement import place

Floats = NDArray[np.float64]
RNG = np.random.default_rng(3)
ONE = Surface(RNG.random((300, 3)) * [100, 100, 5], name="one")
TWO = Surface(RNG.random((250, 3)) * [100, 100, 5], name="two")

WEIGHTS: dict[str, tuple[Callable[[Floats, Floats], Any], str]] = {
    "another length": (lambda x, y: np.ones(3), r"weight: shape \(3,\) for 550 places"),
    "one number": (lambda x, y: 1.0, r"weight: shape \(\) for 550"),
    "a column": (lambda x, y: x[:, None], r"weight: shape \(550, 1\)"),
    "none": (lambda x, y: None, r"weight: shape \(\)"),
    "negative": (lambda x, y: x - 1e3, r"weight: 550 of 550 values are not numbers from 0 to"),
    "NaN": (lambda x, y: np.where(x < 50, np.nan, 1), r"values are not numbers .*, the first nan"),
    "infinite": (lambda x, y: np.full_like(x, np.inf), r"the first inf at"),
    "huge": (lambda x, y: np.full_like(x, 1e300), r"the first 1e\+300 at"),
    "complex": (lambda x, y: x + 1j, r"weight: gives complex128, not real numbers"),
    "objects": (lambda x, y: x.astype(object), r"weight: gives object, not real"),
    "words": (lambda x, y: x.astype(str), r"weight: gives <U\d+, not real"),
}


@pytest.mark.parametrize("kind", WEIGHTS)
def test_weights_that_are_none(kind: str) -> None:
    weight, said = WEIGHTS[kind]
    with pytest.raises(InputError, match=said):
        compare(ONE, TWO, domain="hull", weight=weight)


def test_weights_of_other_types_of_numbers_are_taken() -> None:
    whole = compare(ONE, TWO, weight=lambda x, y: (x > 50).astype(np.int8))
    truth = compare(ONE, TWO, weight=lambda x, y: np.asarray(x > 50))
    assert whole.measures.rho_V_mu == truth.measures.rho_V_mu > 0


def test_a_weight_cannot_move_the_nodes() -> None:
    def weight(x: Floats, y: Floats) -> Floats:
        x[:] = 0.0
        return x

    moved = compare(ONE, TWO, weight=weight)
    assert moved.measures.mean_abs == compare(ONE, TWO).measures.mean_abs


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"domain": "all"}, "domain 'all': must be one of data, hull, plane"),
        ({"duplicates": "first"}, "duplicates 'first': must be one of refuse, mean, max, min"),
        ({"max_edge": np.nan}, "max_edge nan: must be above zero"),
        ({"max_edge": 0.0}, "max_edge 0.0: must be above zero"),
        ({"max_edge": -1.0}, "max_edge -1.0: must be above zero"),
        ({"tolerances": (1.0, np.nan)}, "tolerance nan: must be a number, zero or above"),
        ({"tolerances": (-0.5,)}, "tolerance -0.5: must be a number, zero or above"),
        ({"tolerances": (np.inf,)}, "tolerance inf: must be a number, zero or above"),
        ({"threads": 0}, "threads 0: must be a whole number above zero"),
        ({"threads": 1.5}, "threads 1.5: must be a whole number above zero"),
        ({"align": np.full((4, 4), np.nan)}, "align: not a 4×4 matrix of numbers"),
        ({"align": np.eye(3)}, "align: not a 4×4 matrix of numbers"),
        ({"align": np.diag([2.0, 2.0, 2.0, 1.0])}, "align: not a rigid motion"),
        ({"align": np.diag([-1.0, 1.0, 1.0, 1.0])}, "align: not a rigid motion"),
        ({"align": np.eye(4) * 1e300}, "align: the last row of the matrix is not 0 0 0 1"),
        ({"align": np.diag([1e300, 1.0, 1.0, 1.0])}, "align: not a rigid motion"),
        ({"project": "view:0,0,0"}, "project 'view:0,0,0': must be auto, z or view:X,Y,Z"),
        ({"project": "x"}, "project 'x': must be auto, z or view:X,Y,Z"),
    ],
)
def test_options_that_mean_nothing(options: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        compare(ONE, TWO, **options)


FACES = np.array([[0, 1, 2], [2, 1, 3]], np.int32)
SURFACES: dict[str, tuple[Surface, str]] = {
    "z at the limit of doubles": (
        Surface(np.where(np.arange(3) == 2, -1.797e308, ONE.points), name="far.xyz"),
        r"far.xyz: 300 of 300 nodes have coordinates .* the first z = -1.797e\+308; if it stands",
    ),
    "one NaN": (
        Surface(np.concatenate((ONE.points, [[0.0, np.nan, 0.0]])), name="nan"),
        r"nan: 1 of 301 nodes have coordinates that are no numbers .* the first y = nan",
    ),
    "float32": (Surface(ONE.points.astype(np.float32), name="f"), "f: points are not an array of"),
    "two columns": (Surface(ONE.points[:, :2], name="f"), r"f: points of shape \(300, 2\)"),
    "a face beyond": (Surface(ONE.points[:3], FACES, name="f"), "f: a triangle names node"),
    "a face below": (Surface(ONE.points, FACES - 1, name="f"), "f: a triangle names node"),
    "quads": (
        Surface(ONE.points, np.zeros((2, 4), np.int32), name="f"),
        r"f: faces are not \(m, 3",
    ),
    "no nodes": (Surface(np.empty((0, 3)), name="f"), "f: 0 nodes; at least 3 are needed"),
}


@pytest.mark.parametrize("kind", SURFACES)
def test_surfaces_that_are_none(kind: str) -> None:
    surface, said = SURFACES[kind]
    for pair in ((surface, TWO), (TWO, surface)):
        with pytest.raises(InputError, match=said):
            compare(*pair)
    if kind not in ("a face beyond", "no nodes"):
        for work in (lambda: place(surface, TWO, "auto"), lambda: best_fit(TWO, surface)):
            with pytest.raises(InputError, match=said):
                work()


def test_a_motion_beyond_all_numbers_is_refused() -> None:
    away = np.eye(4)
    away[2, 3] = 1e200
    with pytest.raises(InputError, match=r"two: 250 of 250 nodes .* the first z = 1e\+200"):
        compare(ONE, TWO, align=away)


@pytest.mark.parametrize(("value", "share"), [(1e160, 1.0), (1e200, 0.1), (-1.797e308, 0.1)])
def test_heights_no_distance_can_be_told_of_end_with_3(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], value: float, share: float
) -> None:
    points = TWO.points.copy()
    points[RNG.random(len(points)) < share, 2] = value
    np.savetxt(tmp_path / "a.xyz", ONE.points)
    np.savetxt(tmp_path / "b.xyz", points)
    for more in ([], ["--align", "icp"], ["--project", "auto"]):
        assert main(["compare", str(tmp_path / "a.xyz"), str(tmp_path / "b.xyz"), *more]) == 3
        line = capsys.readouterr().err
        assert line.count("\n") == 1
        assert "b.xyz: " in line
        assert "if it stands for no data" in line


def test_weights_of_a_file_whose_nodes_are_out_of_range_name_it(tmp_path: Path) -> None:
    path = tmp_path / "weights.xyz"
    np.savetxt(path, [[0, 0, 1], [1e300, 0, 1], [0, 1, 1]])
    with pytest.raises(InputError, match=r"weights.xyz: 1 of 3 nodes .* the first x = 1e\+300"):
        read_weight(path)
    np.savetxt(path, [[0, 0, 1], [1e-70, 0, 1], [0, 1e-70, 1]])
    weight = read_weight(path)
    with pytest.raises(InputError, match=r"weights.xyz: coordinates span too many magnitudes"):
        weight(np.array([0.0, 1e70]), np.array([0.0, 1.0]))
