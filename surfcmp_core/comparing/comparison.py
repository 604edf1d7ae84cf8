"""A finished comparison: what it was made of, what it found, how long it took."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.alignment import FitRecord, record_of_motion
from surfcmp_core.comparing.options import Options
from surfcmp_core.domain import Reason
from surfcmp_core.grid import Grid
from surfcmp_core.measures import Covered
from surfcmp_core.measures.measures import Measures
from surfcmp_core.surface import Surface
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.united import United


@dataclass(frozen=True, slots=True)
class MeshFaces:
    """How the faces of a mesh's file differ from the triangles of T1, on which F̂ is linear."""

    replaced: int
    """Faces with an area in the plane that are not triangles of T1."""
    overlapping: int
    """Faces that lie over others in the plane, so that not all are taken as the file has them."""
    mean_difference: float
    """Mean of |z of the file's own surface - F̂| over the area under the faces, length."""
    largest_difference: float
    """The largest such difference, length."""


@dataclass(frozen=True, slots=True, eq=False)
class Comparison:
    """Two surfaces compared over their united triangulation.

    N nodes and M triangles of T. Values without data are NaN.
    """

    surfaces: tuple[Surface, Surface]
    """As they were read, but in one unit and the same axes."""
    grids: tuple[Grid, Grid]
    triangulations: tuple[Triangulation, Triangulation]
    united: United
    z1: NDArray[np.float64]
    """(N,) F̂1 at the nodes of T."""
    z2: NDArray[np.float64]
    """(N,) F̂2 at the nodes of T."""
    weight: NDArray[np.float64] | None
    """(N,) µ at the nodes of T; None for µ = 1."""
    reason: NDArray[np.uint8]
    """(M,) a `Reason` for each triangle."""
    area: NDArray[np.float64]
    """(M,) area in the plane; NaN where not compared."""
    mean_abs: NDArray[np.float64]
    """(M,) mean of |d| over the triangle; NaN where not compared."""
    mean_signed: NDArray[np.float64]
    """(M,) mean of d over the triangle; NaN where not compared."""
    measures: Measures
    options: Options
    transform: NDArray[np.float64]
    """(4, 4) the motion of surface 2 from the coordinates in `surfaces` into the comparison's:
    first the alignment, then `frame`."""
    max_edges: tuple[float, float]
    """The `max_edge` used for each surface; inf for meshes and where there is no limit."""
    mean_abs_exact: NDArray[np.float64] | None = None
    """(M,) mean of |d| by the exact reading over the common part of the triangle; NaN where there
    is none; None where the exact reading was not asked for."""
    mean_signed_exact: NDArray[np.float64] | None = None
    """(M,) the same of d."""
    frame: NDArray[np.float64] = field(default_factory=lambda: np.eye(4))
    """(4, 4) the motion of both surfaces into the plane of comparison, z along the view."""
    alignment: FitRecord = field(default_factory=lambda: record_of_motion("none", np.eye(4)))
    """How surface 2 was moved onto surface 1, and how well that went."""
    reversed: tuple[bool, bool] | None = None
    """Which surfaces are looked at from their backs; None where nobody looked for their sides."""
    seconds: dict[str, float] = field(default_factory=dict)
    """Wall time of read, triangulate, spanning_trees, locate, interpolate, interface, measures,
    total."""
    warnings: tuple[str, ...] = ()
    footprints: tuple[Covered, Covered] = (Covered(0.0), Covered(0.0))
    """Where each surface has data."""
    faces: tuple[MeshFaces | None, MeshFaces | None] = (None, None)
    """Of each mesh; None of a cloud."""

    @property
    def compared(self) -> NDArray[np.bool_]:
        """(M,) bool: counted in the measures."""
        return np.asarray(self.reason == Reason.COMPARED)

    @property
    def chains(self) -> list[NDArray[np.int64]]:
        """Triangle numbers of each chain, in the order of the chain."""
        chain = self.united.chain
        inside = np.flatnonzero(chain >= 0)
        cuts = np.flatnonzero(np.diff(chain[inside])) + 1
        return np.split(inside, cuts) if inside.size else []

    @property
    def counts(self) -> dict[str, int]:
        """Nodes, triangles and chains, under the names of the .json result."""
        united = self.united
        closed = int(united.chain_closed.sum())
        return {
            "nodes_1": len(self.grids[0].nodes),
            "nodes_2": len(self.grids[1].nodes),
            "nodes_shared": int((united.label == 3).sum()),
            "triangles_1": self.triangulations[0].real,
            "triangles_2": self.triangulations[1].real,
            "triangles_united": len(united.triangles),
            "triangles_interface": int((united.chain >= 0).sum()),
            "triangles_representative": int(united.representative.sum()),
            "triangles_compared": int(self.compared.sum()),
            "chains": len(united.chain_closed),
            "chains_closed": closed,
            "chains_open": len(united.chain_closed) - closed,
        }
