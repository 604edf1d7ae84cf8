"""One surface while it is compared: among the nodes and triangles of T."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparison import Comparison, Domain
from surfcmp_core.domain import Footprint, footprint_of_cloud, footprint_of_mesh
from surfcmp_core.domain.footprint import DATA, OUTSIDE, states_at, states_of_triangles
from surfcmp_core.domain.layers import share_among_layers
from surfcmp_core.domain.spacing import limits_of_edges
from surfcmp_core.grid import Grid, grid_of, safe_scale
from surfcmp_core.interpolation import interpolate
from surfcmp_core.measures import LinearSurface, triangle_areas
from surfcmp_core.spanning_tree import spanning_tree, tree_ends
from surfcmp_core.surface import Surface
from surfcmp_core.triangulation import Triangulation, triangulate
from surfcmp_core.triangulation.half_edges import leaving_edges
from surfcmp_core.united import United


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


@dataclass(frozen=True, slots=True, eq=False)
class CloudData:
    """Where a cloud has data, in short.

    Attributes
    ----------
    max_edge : float
        Longest edge over which it may have data, where its nodes lie farthest apart.
    usual_edge : float
        The same at half of its nodes or more.
    area, hull_area : float
        With data, and of the convex hull, in the plane.
    among_layers : float
        Share of its nodes that lie among nodes of another layer.
    """

    max_edge: float
    usual_edge: float
    area: float
    hull_area: float
    among_layers: float


def data_of_cloud(cloud: Surface) -> CloudData:
    """Tell how much of its convex hull a cloud has data in, seen along z, where nothing is said.

    Parameters
    ----------
    cloud : Surface
        Of nodes at one place the highest counts.

    Returns
    -------
    CloudData

    Raises
    ------
    InputError
        Nodes that cannot be triangulated.
    """
    grid = grid_of(cloud, duplicates="max")
    scale = safe_scale(grid.nodes)
    t = triangulate(grid.nodes * scale, name=cloud.name)
    tree = tree_ends(t, spanning_tree(t))
    usual = float(np.median(limits_of_edges(t, tree)))
    found = footprint_of_cloud(t, tree, None)
    hull = float(triangle_areas(t.nodes, t.triangles).sum())
    return CloudData(
        found.max_edge / scale,
        usual / scale,
        found.area / scale / scale,
        hull / scale / scale,
        share_among_layers(t, grid.z * scale),
    )


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
    grid : Grid
    footprint : Footprint
        With the surface's triangulation.
    own, other : (n,), (n') int32
        Numbers in T of its nodes and of the other grid's.
    queries : (n', 2) float64
        The other grid's nodes.
    found : (n',) int32
        Where those lie in the surface's triangulation.
    """

    grid: Grid
    footprint: Footprint
    own: NDArray[np.int32]
    other: NDArray[np.int32]
    queries: NDArray[np.float64]
    found: NDArray[np.int32]

    def values(self, count: int, domain: Domain) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
        """Give F̂ at all N = `count` nodes of T, NaN without data, and the state there."""
        triangulation = self.footprint.triangulation
        z = np.empty(count)
        z[self.other] = interpolate(
            triangulation, self.grid.z, self.queries, self.found, continued=domain == "plane"
        )
        z[self.own] = self.grid.z
        state = np.full(count, DATA)
        if domain == "hull":
            state[self.other[self.found >= triangulation.real]] = OUTSIDE
            state[self.own] = DATA
        elif domain == "data":
            state[self.other] = states_at(self.footprint, self.queries, self.found)
            state[self.own] = self.footprint.at_node
            without = state != DATA
            without[self.own] = False
            z[without] = np.nan
        return z, state

    def states(
        self, united: United, node_states: NDArray[np.uint8], domain: Domain
    ) -> NDArray[np.uint8]:
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
            ask_centroids=domain == "data",
        )

    def area(self, domain: Domain, united: United) -> float:
        """Area over which the surface is known: its data, its hull, or all of T."""
        if domain == "data":
            return self.footprint.area
        t = self.footprint.triangulation if domain == "hull" else united
        return float(np.sort(triangle_areas(t.nodes, t.triangles)).sum())

    def exact_area(self, domain: Domain, united: United) -> float:
        """Area as `area` has it, but of whole triangles of `linear` where those are not faces."""
        if domain != "data":
            return self.area(domain, united)
        t = self.footprint.triangulation
        areas = triangle_areas(t.nodes, t.triangles[self.footprint.covered])
        return float(np.sort(areas).sum())

    def linear(self, domain: Domain) -> LinearSurface:
        """Give F̂ on the surface's own triangles; outside its hull nothing is integrated exactly."""
        triangulation = self.footprint.triangulation
        valid = self.footprint.covered if domain == "data" else np.ones(triangulation.real, bool)
        return LinearSurface(triangulation, self.grid.z, valid, self.found)
