"""The stages of a comparison (the paper's section 3.2), each from what the last one gave.

Coordinates are multiplied by a power of two, `scale`, where the predicates would else not be exact;
what the stages after the filling give is in the comparison's own unit.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparing.clock import Clock, at_once, both
from surfcmp_core.comparing.comparison import MeshFaces
from surfcmp_core.comparing.options import Options, Weight
from surfcmp_core.comparing.placing import Placed
from surfcmp_core.comparing.side import Side, faces_of, footprint_of
from surfcmp_core.domain import Footprint, OwnFaces, Reason, reasons
from surfcmp_core.grid import Grid, box_of, grid_of, safe_scale, shared_nodes
from surfcmp_core.localisation import locate_along_tree
from surfcmp_core.measures import (
    Covered,
    Measures,
    TriangleValues,
    hausdorff,
    measure,
    measure_exactly,
    triangle_areas,
)
from surfcmp_core.spanning_tree import spanning_tree, tree_ends
from surfcmp_core.surface.refusals import weight_at
from surfcmp_core.triangulation import Triangulation, triangulate
from surfcmp_core.united import United, unite


@dataclass(frozen=True, slots=True, eq=False)
class Triangulated:
    """Stages 1 and 2: T1 and T2 with their spanning trees.

    Attributes
    ----------
    grids : two Grid
    triangulations : two Triangulation
        Of the grids' nodes times `scale`.
    scale : float
        A power of two.
    trees : two (n - 1,) int32
        As :func:`surfcmp_core.spanning_tree.spanning_tree` gives them.
    ends : two (n - 1, 2) int32
        The nodes of their edges.
    """

    grids: tuple[Grid, Grid]
    triangulations: tuple[Triangulation, Triangulation]
    scale: float
    trees: tuple[NDArray[np.int32], NDArray[np.int32]]
    ends: tuple[NDArray[np.int32], NDArray[np.int32]]

    def in_unit(self) -> tuple[Triangulation, Triangulation]:
        """Give T1 and T2 in the comparison's unit."""
        t1, t2 = self.triangulations
        if self.scale == 1.0:
            return t1, t2
        one, two = self.grids
        return t1._replace(nodes=one.nodes), t2._replace(nodes=two.nodes)


@dataclass(frozen=True, slots=True, eq=False)
class Merged:
    """Stages 3 and 5: where the nodes of each grid lie in the other, and T.

    Attributes
    ----------
    scaled : United
        T, its nodes times `scale`.
    united : United
        T in the comparison's unit.
    areas : (M,) float64
        Of its triangles, in the plane.
    sides : two Side
    farthest : (float, float)
        Of the nodes of 1 from those of 2, and of 2 from 1: the Hausdorff distances.
    """

    scaled: United
    united: United
    areas: NDArray[np.float64]
    sides: tuple[Side, Side]
    farthest: tuple[float, float]


@dataclass(frozen=True, slots=True, eq=False)
class Filled:
    """Stage 4: both surfaces at all nodes of T, and the triangles on which both are known.

    Attributes
    ----------
    z : two (N,) float64
        F̂1 and F̂2; NaN without data.
    reason : (M,) uint8
        A `Reason` each.
    compared : (M,) bool
        Where that is `COMPARED`.
    """

    z: tuple[NDArray[np.float64], NDArray[np.float64]]
    reason: NDArray[np.uint8]
    compared: NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class Measured:
    """Stage 6: the measures.

    Attributes
    ----------
    values, exact_values : TriangleValues
        Of each triangle, by the nodal reading, and by the exact one where it was asked for.
    measures : Measures
    weight : (N,) float64 or None
        µ at the nodes of T.
    covered : two Covered
        Where each surface has data.
    faces : two MeshFaces or None
        Of each mesh.
    """

    values: TriangleValues
    exact_values: TriangleValues | None
    measures: Measures
    weight: NDArray[np.float64] | None
    covered: tuple[Covered, Covered]
    faces: tuple[MeshFaces | None, MeshFaces | None]


def triangulated(placed: Placed, options: Options, clock: Clock) -> Triangulated:
    """Make both grids, T1 and T2, and their minimum spanning trees.

    Raises
    ------
    InputError
        Nodes that contradict each other, or that cannot be triangulated.
    """
    with clock.stage("triangulate", 0.0):
        one, two = placed.surfaces
        box = box_of(one, two)
        grids = both(
            lambda surface: grid_of(surface, duplicates=options.duplicates, box=box),
            one,
            two,
            options.threads,
        )
        scale = safe_scale(grids[0].nodes, grids[1].nodes)
        triangulations = both(
            lambda grid: triangulate(
                grid.nodes if scale == 1.0 else grid.nodes * scale,
                name=grid.name,
                model=grid.faces,
            ),
            *grids,
            options.threads,
        )
    with clock.stage("spanning_trees", 0.4):
        trees = both(spanning_tree, *triangulations, options.threads)
        ends = tree_ends(triangulations[0], trees[0]), tree_ends(triangulations[1], trees[1])
    return Triangulated(grids, triangulations, scale, trees, ends)


def merged(made: Triangulated, options: Options, clock: Clock) -> Merged:
    """Merge T1 and T2, and beside it locate the nodes of each grid in the other triangulation."""

    def merge() -> United:
        with clock.stage("interface", 0.5):
            return unite(
                *made.triangulations,
                *made.trees,
                shared_nodes(*made.grids),
                lambda share: clock.tell("interface", 0.5 + 0.2 * share),
            )

    def around(
        this: int, other: int
    ) -> tuple[NDArray[np.int32], float, Footprint, OwnFaces | None]:
        """Locate the other grid in this one; the farthest of its nodes; where this one has data."""
        own, grid, opposite = made.triangulations[this], made.grids[this], made.grids[other]
        with clock.stage("locate"):
            found = locate_along_tree(own, made.triangulations[other].nodes, made.ends[other])
        with clock.stage("measures"):
            farthest = hausdorff(opposite.nodes, opposite.z, grid.nodes, grid.z, own, found)
        with clock.stage("interpolate"):
            limit = None if options.max_edge is None else options.max_edge * made.scale
            footprint = footprint_of(grid, own, made.ends[this], options.domain, limit)
            return found, farthest, footprint, faces_of(grid, own)

    # merging needs none of these, nor they it (the paper, after the stages)
    scaled, (around_1, around_2) = at_once(
        merge, lambda: (around(0, 1), around(1, 0)), options.threads
    )
    found_1, farthest_2, footprint_1, faces_1 = around_1
    found_2, farthest_1, footprint_2, faces_2 = around_2
    own_1, own_2 = scaled.node_1, scaled.node_2
    (grid_1, grid_2), (t1, t2) = made.grids, made.triangulations
    sides = (
        Side(options.domain, grid_1, footprint_1, own_1, own_2, t2.nodes, found_1, faces_1),
        Side(options.domain, grid_2, footprint_2, own_2, own_1, t1.nodes, found_2, faces_2),
    )
    united = scaled
    if made.scale != 1.0:
        united = replace(scaled, nodes=scaled.nodes / made.scale)
    areas = triangle_areas(united.nodes, united.triangles)
    return Merged(scaled, united, areas, sides, (farthest_1, farthest_2))


def filled(made: Triangulated, merged: Merged, options: Options, clock: Clock) -> Filled:
    """Interpolate each surface at the nodes of the other, and tell which triangles both know."""
    united, sides = merged.scaled, merged.sides
    with clock.stage("interpolate", 0.7):
        (z1, at_1), (z2, at_2) = both(
            lambda side: side.values(len(united.nodes)), *sides, options.threads
        )
        state_1, state_2 = at_once(
            lambda: sides[0].states(united, at_1),
            lambda: sides[1].states(united, at_2),
            options.threads,
        )
        reason = reasons(state_1, state_2, merged.areas)
    return Filled((z1, z2), reason, np.asarray(reason == Reason.COMPARED))


def max_edges(made: Triangulated, merged: Merged) -> tuple[float, float]:
    """Give the longest edge over which either surface has data, in the comparison's unit."""
    one, two = merged.sides
    return one.footprint.max_edge / made.scale, two.footprint.max_edge / made.scale


def measured(
    made: Triangulated,
    merged: Merged,
    filled: Filled,
    weight: Weight | None,
    options: Options,
    clock: Clock,
) -> Measured:
    """Measure the difference of the surfaces, triangle by triangle and over all.

    Raises
    ------
    InputError
        The weight gives no numbers from 0 on.
    """
    united, sides, threads = merged.united, merged.sides, options.threads
    with clock.stage("measures", 0.85):
        node_weight = None if weight is None else weight_at(weight, united.nodes)
        linear = both(Side.linear, *sides, threads)
        covered_1, covered_2 = (
            side.covered(one, merged.scaled, merged.areas, filled.compared, threads)
            for side, one in zip(sides, linear, strict=True)
        )
        values, measures = measure(
            united.nodes,
            united.label,
            united.triangles,
            *filled.z,
            filled.compared,
            tolerances=options.tolerances,
            node_weight=node_weight,
            footprint_1=covered_1,
            footprint_2=covered_2,
            hausdorff=merged.farthest,
            threads=threads,
        )
        faces = both(Side.mesh_faces, *sides, threads)
        exact_values = None
        if options.exact:
            exact_values, exact_measures = measure_exactly(
                *linear,
                merged.scaled,
                length=1.0 / made.scale,
                tolerances=options.tolerances,
                node_weight=node_weight,
                continued=options.domain == "plane",
                hausdorff=merged.farthest,
                threads=threads,
                progress=lambda share: clock.tell("exact measures", 0.9 + 0.1 * share),
            )
            measures = replace(measures, exact=exact_measures)
    return Measured(values, exact_values, measures, node_weight, (covered_1, covered_2), faces)
