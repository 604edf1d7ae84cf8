"""A comparison small enough to be written by hand: two squares, five nodes, four triangles."""

from pathlib import Path

import numpy as np

from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.comparing.options import Options
from surfcmp_core.domain import Reason
from surfcmp_core.grid import Grid
from surfcmp_core.measures.measures import Measures
from surfcmp_core.surface import Surface
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.united import United


def two_squares() -> Comparison:
    """Compare a flat unit square with the four corners of another and a raised middle.

    Its corners are shared; the middle belongs to 2. One triangle is not compared.
    """
    corners = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    middle = np.vstack([corners, [[0.5, 0.5]]])
    grids = (_grid(corners, np.zeros(4), "a.ply"), _grid(middle, np.r_[0, 0, 0, 0, -3.0], "b.ply"))
    around = np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]], dtype=np.int32)
    compared = np.array([True, True, True, False])
    nan_where_not = np.where(compared, 1.0, np.nan)
    surfaces = tuple(
        Surface(
            points=np.column_stack([grid.nodes, grid.z]),
            faces=faces,
            name=grid.name,
            path=Path(grid.name),
            sha256=digit * 64,
            unit="mm",
            dropped=dropped,
        )
        for grid, digit, faces, dropped in (
            (grids[0], "1", np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32), {"not finite": 2}),
            (grids[1], "2", None, {}),
        )
    )
    return Comparison(
        surfaces=(surfaces[0], surfaces[1]),
        grids=grids,
        triangulations=(
            _triangulation(corners, np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32)),
            _triangulation(middle, around),
        ),
        united=United(
            nodes=middle,
            label=np.array([3, 3, 3, 3, 2], dtype=np.uint8),
            node_1=np.arange(4, dtype=np.int32),
            node_2=np.arange(5, dtype=np.int32),
            triangles=around,
            origin=np.full(4, 2, dtype=np.uint8),
            chain=np.full(4, -1, dtype=np.int32),
            chain_closed=np.zeros(0, dtype=bool),
            tree1=np.array([[0, 1], [1, 2], [2, 3]], dtype=np.int32),
            tree2=np.array([[0, 4], [1, 4], [2, 4], [3, 4]], dtype=np.int32),
        ),
        z1=np.array([0.0, 0.0, 0.0, np.nan, 0.0]),
        z2=np.array([0.0, 0.0, 0.0, 0.0, -3.0]),
        weight=None,
        reason=np.where(compared, Reason.COMPARED, Reason.HOLE).astype(np.uint8),
        area=0.25 * nan_where_not,
        mean_abs=nan_where_not,
        mean_signed=nan_where_not,
        measures=Measures(
            rho_V=3.0,
            rho_V_mu=3.0,
            rho_delta_V=3.0,
            mean_abs=1.0,
            mean_abs_interface=float("nan"),
            mean_signed=1.0,
            rms=1.2247448713915890,
            max_abs=3.0,
            p50=1.0,
            p90=1.0,
            p95=1.0,
            within_tolerance={"0.5": 0.3, "1": 0.5555, "2": 0.88},
            volume_above=0.75,
            volume_below=0.0,
            area_compared=0.75,
            area_interface=0.75,
            coverage_1=0.75,
            coverage_2=0.75,
            hausdorff_1_2=0.0,
            hausdorff_2_1=3.08220700148449,
        ),
        options=Options(),
        transform=np.eye(4),
        max_edges=(float("inf"), 1.5),
        seconds={"read": 0.25, "total": 0.5},
        warnings=("units are not stated: taken as mm",),
    )


def _grid(nodes: np.ndarray, z: np.ndarray, name: str) -> Grid:
    keys = np.arange(len(nodes), dtype=np.uint64)
    source = np.arange(len(nodes))
    return Grid(nodes=nodes, z=z, source=source, faces=None, merged=0, keys=keys, name=name)


def _triangulation(nodes: np.ndarray, triangles: np.ndarray) -> Triangulation:
    start = triangles.ravel()
    return Triangulation(nodes, start, np.zeros_like(start), len(triangles))
