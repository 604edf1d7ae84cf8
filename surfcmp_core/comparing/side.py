"""One surface while it is compared: among the nodes and triangles of T."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.cells.gaps import NO_GAPS, gaps_of
from surfcmp_core.comparing.comparison import Comparison, MeshFaces
from surfcmp_core.comparing.options import Domain
from surfcmp_core.domain import (
    Footprint,
    OwnFaces,
    footprint_of_cloud,
    footprint_of_mesh,
    own_faces,
)
from surfcmp_core.domain.footprint import DATA, OUTSIDE, states_at, states_of_triangles
from surfcmp_core.grid import Grid
from surfcmp_core.interpolation import interpolate
from surfcmp_core.localisation import relocate
from surfcmp_core.measures import (
    Covered,
    LinearSurface,
    area_within,
    disagreement,
    shares_within,
)
from surfcmp_core.triangulation import Triangulation
from surfcmp_core.triangulation.half_edges import leaving_edges
from surfcmp_core.united import United


def faces_of(grid: Grid, triangulation: Triangulation) -> OwnFaces | None:
    """Find a mesh's own faces among the triangles of T1, or turn edges until they are there."""
    return None if grid.faces is None else own_faces(triangulation, grid.faces)


def footprint_of(
    grid: Grid,
    triangulation: Triangulation,
    tree: NDArray[np.int32],
    domain: Domain,
    max_edge: float | None,
) -> Footprint:
    """Find where a surface has data: a mesh under its faces, a cloud over its short edges.

    Parameters
    ----------
    grid : Grid
    triangulation : Triangulation
        Of the grid's nodes; its coordinates are those of the result.
    tree : (n - 1, 2) int32
        Its spanning tree.
    domain : Domain
        Other than "data": all of the hull, nobody asks where it has gaps.
    max_edge : float or None
        Of a cloud, see :func:`surfcmp_core.domain.footprint_of_cloud`.

    Returns
    -------
    Footprint
    """
    if domain != "data":
        return footprint_of_cloud(triangulation, tree, np.inf)
    if grid.faces is not None:
        return footprint_of_mesh(triangulation, grid.faces)
    return footprint_of_cloud(triangulation, tree, max_edge)


def triangles_with_data(comparison: Comparison, which: int) -> NDArray[np.bool_]:
    """Tell which triangles of T1 or T2 a surface has data in, as far as its own triangles tell.

    Parameters
    ----------
    comparison : Comparison
        Under any domain.
    which : int
        0 for surface 1, 1 for surface 2.

    Returns
    -------
    (m,) bool
        Of a mesh, those with a face at their centroid; of a cloud, those without an edge too long.
    """
    united = comparison.united
    number = np.empty(len(united.nodes), np.int32)
    own, tree = ((united.node_1, united.tree1), (united.node_2, united.tree2))[which]
    number[own] = np.arange(len(own), dtype=np.int32)
    found = footprint_of(
        comparison.grids[which],
        comparison.triangulations[which],
        number[tree],
        "data",
        comparison.options.max_edge,
    )
    return found.covered


@dataclass(frozen=True, slots=True, eq=False)
class Side:
    """One of the two surfaces, seen from T.

    Attributes
    ----------
    domain : Domain
        Of the comparison.
    grid : Grid
    footprint : Footprint
        With the surface's triangulation.
    own, other : (n,), (n') int32
        Numbers in T of its nodes and of the other grid's.
    queries : (n', 2) float64
        The other grid's nodes.
    found : (n',) int32
        Where those lie in the surface's triangulation.
    faces : OwnFaces or None
        A mesh's own faces; None of a cloud.
    """

    domain: Domain
    grid: Grid
    footprint: Footprint
    own: NDArray[np.int32]
    other: NDArray[np.int32]
    queries: NDArray[np.float64]
    found: NDArray[np.int32]
    faces: OwnFaces | None

    def values(self, count: int) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
        """Give F̂ at all N = `count` nodes of T, NaN without data, and the state there."""
        triangulation = self.footprint.triangulation
        z = np.empty(count)
        z[self.other] = interpolate(
            triangulation, self.grid.z, self.queries, self.found, continued=self.domain == "plane"
        )
        z[self.own] = self.grid.z
        state = np.full(count, DATA)
        if self.domain == "hull":
            state[self.other[self.found >= triangulation.real]] = OUTSIDE
            state[self.own] = DATA
        elif self.domain == "data":
            state[self.other] = states_at(self.footprint, self.queries, self.found)
            state[self.own] = self.footprint.at_node
            without = state != DATA
            without[self.own] = False
            z[without] = np.nan
        return z, state

    def states(self, united: United, node_states: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """Give the state of each triangle of T: DATA, OUTSIDE or HOLE."""
        triangulation = self.footprint.triangulation
        hints = np.empty(len(united.nodes), np.int32)
        hints[self.other] = self.found
        hints[self.own] = leaving_edges(triangulation.start, len(triangulation.nodes)) // 3
        return states_of_triangles(
            self.footprint,
            united.nodes,
            united.triangles,
            node_states,
            hints,
            ask_centroids=self.domain == "data",
        )

    def linear(self) -> LinearSurface:
        """Give what the exact reading integrates: F on a mesh's own faces, else F̂ on T1.

        Under "hull" and "plane" no face says where there is data, nor where F is linear: it is F̂,
        as the paper has it. Outside its hull nothing is known of it.
        """
        t = self.footprint.triangulation
        planes, valid, found = t.triangles, self.footprint.covered, self.found
        if self.domain != "data":
            valid = np.ones(t.real, np.bool_)
        elif self.faces is not None:
            before, t = t, self.faces.triangulation
            planes, valid = self.faces.planes, self.faces.valid
            if t is not before:
                found = relocate(t, before, self.queries, found)
        return LinearSurface(t, self.grid.z, planes, valid, found)

    def covered(
        self,
        linear: LinearSurface,
        scaled: United,
        areas: NDArray[np.float64],
        compared: NDArray[np.bool_],
        threads: int,
    ) -> Covered:
        """Tell how much of T lies where the surface is known: its data, its hull, or all of T.

        `scaled` has the coordinates of the surface's triangulation, `areas` (M,) those of the
        result.
        """
        shares = np.ones(len(areas))
        if self.domain != "plane":
            t, without = linear.triangulation, ~linear.valid
            gaps = gaps_of(t.nodes, t.triangles[without]) if without.any() else NO_GAPS
            shares = shares_within(linear, scaled, self.own, self.other, gaps, threads)
        all_inside = bool((shares[compared] == 1.0).all())
        return Covered(area_within(areas, shares), None if all_inside else shares)

    def mesh_faces(self) -> MeshFaces | None:
        """Tell how a mesh's own faces differ from the triangles of T1; None of a cloud."""
        if self.faces is None:
            return None
        before, own = self.footprint.triangulation, self.faces.triangulation
        mean = largest = 0.0
        if own is not before:
            z, nowhere = self.grid.z, np.empty(0, np.int32)
            everywhere = np.ones(before.real, np.bool_)
            mean, largest = disagreement(
                LinearSurface(before, z, before.triangles, everywhere, nowhere),
                LinearSurface(own, z, self.faces.planes, self.faces.valid, nowhere),
            )
        return MeshFaces(self.faces.replaced, self.faces.overlapping, mean, largest)
