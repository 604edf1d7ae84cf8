"""The whole comparison: the paper's general algorithm, stage by stage (section 3.2)."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparing.cautions import cautions, nothing_common
from surfcmp_core.comparing.clock import Clock, at_once, both
from surfcmp_core.comparing.comparison import Comparison, Domain, Options, Weight
from surfcmp_core.comparing.memory_needed import check_comparison
from surfcmp_core.comparing.side import Side, faces_of, footprint_of
from surfcmp_core.comparing.verification import (
    check_cover,
    check_exchange,
    check_measures,
    check_sums,
    check_united,
    check_values,
    keeping,
)
from surfcmp_core.comparing.warming import begin_to_compile
from surfcmp_core.compiled.linear_algebra import composed
from surfcmp_core.domain import Footprint, OwnFaces, Reason, reasons
from surfcmp_core.domain.layers import share_among_layers
from surfcmp_core.errors import InputError
from surfcmp_core.grid import Duplicates, box_of, grid_of, safe_scale, shared_nodes
from surfcmp_core.interface import kernels_are_ready
from surfcmp_core.localisation import locate_along_tree
from surfcmp_core.measures import hausdorff, measure, measure_exactly, triangle_areas
from surfcmp_core.projection import moved
from surfcmp_core.spanning_tree import spanning_tree, tree_ends
from surfcmp_core.surface import Surface
from surfcmp_core.surface.refusals import motion_of, refuse_pair, refuse_surface, weight_at
from surfcmp_core.surface.together import bring_together, carried
from surfcmp_core.surface.used import used_part
from surfcmp_core.system.progress import Progress, silent
from surfcmp_core.triangulation import triangulate
from surfcmp_core.united import United, unite


def _explained(progress: Progress) -> Progress:
    """Say so where the first use of the program compiles its kernels, which takes its time."""
    if kernels_are_ready():
        return progress
    begin_to_compile()
    return lambda stage, share: progress(f"{stage} (compiling, on first use only)", share)


def _placed(surface: Surface, motion: NDArray[np.float64]) -> Surface:
    placed = moved(surface, motion)
    if placed is not surface:
        refuse_surface(placed)
    return placed


def compare(
    surface_1: Surface,
    surface_2: Surface,
    *,
    domain: Domain = "data",
    max_edge: float | None = None,
    exact: bool = False,
    tolerances: Sequence[float] = (0.5, 1.0, 2.0),
    weight: Weight | None = None,
    duplicates: Duplicates = "refuse",
    threads: int = 2,
    align: NDArray[np.float64] | None = None,
    frame: NDArray[np.float64] | None = None,
    verify: bool = False,
    progress: Progress = silent,
    read_seconds: float = 0.0,
) -> Comparison:
    """Compare two surfaces z = F(x, y).

    Parameters
    ----------
    surface_1, surface_2 : Surface
        n1 and n2 nodes; brought to one unit and the same axes by
        :func:`surfcmp_core.surface.together.bring_together`. Where a unit or axes are missing, or
        one surface is converted, the result's warnings say so.
    domain : {"data", "hull", "plane"}
        Compare where both surfaces have data, inside both convex hulls, or over all of T with
        either surface continued by the nearest value of its hull.
    max_edge : float, optional
        Longest edge over which a cloud has data, in the unit of the comparison; derived from its
        spacing where not given, inf for no limit.
    exact : bool
        Also integrate exactly: over the overlay of T1 and T2 within both hulls; where `domain` is
        "data" and a surface is a mesh, on its own faces, over the area common to both.
    tolerances : sequence of float
        Lengths, in the unit of the comparison, for which to give the share of the area within.
    weight : callable, optional
        µ(x, y) ≥ 0, sampled at the nodes of T.
    duplicates : {"refuse", "mean", "max", "min"}
        What to do with nodes of equal (x, y) and different z.
    threads : int
        How many may work at once.
    align : (4, 4) float64, optional
        Motion of surface 2 onto surface 1, before `frame`; in the unit and axes of surface 1.
    frame : (4, 4) float64, optional
        Motion of both surfaces into the plane of comparison, z along the view; in the same.
    verify : bool
        Check all that must hold of the result, not only what takes no time
        (:mod:`surfcmp_core.comparing.verification`).
    progress : callable
        Told the stage and the share done; may raise `Cancelled`.
    read_seconds : float
        Time it took to read the surfaces, for the record.

    Returns
    -------
    Comparison

    Raises
    ------
    InputError
        The surfaces cannot be compared, or the weight gives no numbers from 0 on.
    ValueError
        An option that means nothing; `align` or `frame` is not a rigid motion.
    Violation
        What must hold of every comparison does not; the input is kept, the message says where.
    Cancelled
        From `progress`.

    References
    ----------
    Stages 1 to 6 of the paper's section 3.2; formulas (1) to (3).
    """
    options = Options(domain, max_edge, exact, tuple(tolerances), duplicates, threads)
    frame = None if frame is None else motion_of(frame, "frame")
    align = None if align is None else motion_of(align, "align")
    for surface in (surface_1, surface_2):
        refuse_surface(surface)
        if len(surface.points) < 3:
            raise InputError(f"{surface.name}: {len(surface.points)} nodes; at least 3 are needed")
    check_comparison(surface_1, surface_2, exact)
    progress = _explained(progress)
    clock = Clock(progress, read_seconds)
    with clock.stage("triangulate"):
        surface_1, surface_2 = both(used_part, surface_1, surface_2, threads)
    together = bring_together(surface_1, surface_2)
    first = together.surfaces[0]
    change = first.scale / surface_1.scale, first.turned != surface_1.turned
    surface_1, surface_2 = together.surfaces
    view = np.eye(4) if frame is None else carried(frame, *change)
    motion = view if align is None else composed(view, carried(align, *change))

    with clock.stage("triangulate", 0.0):
        placed = _placed(surface_1, view), _placed(surface_2, motion)
        refuse_pair(*placed)
        box = box_of(*placed)
        grids = both(lambda s: grid_of(s, duplicates=duplicates, box=box), *placed, threads)
        scale = safe_scale(grids[0].nodes, grids[1].nodes)
        triangulations = both(
            lambda grid: triangulate(
                grid.nodes if scale == 1.0 else grid.nodes * scale,
                name=grid.name,
                model=grid.faces,
            ),
            *grids,
            threads,
        )
    with clock.stage("spanning_trees", 0.4):
        trees = both(spanning_tree, *triangulations, threads)
        ends = [tree_ends(t, tree) for t, tree in zip(triangulations, trees, strict=True)]

    def merge() -> United:
        with clock.stage("interface", 0.5):
            return unite(
                *triangulations,
                *trees,
                shared_nodes(*grids),
                lambda share: progress("interface", 0.5 + 0.2 * share),
            )

    def around(
        this: int, other: int
    ) -> tuple[NDArray[np.int32], float, Footprint, OwnFaces | None]:
        """Locate the other grid in this one; the farthest of its nodes; where this one has data."""
        with clock.stage("locate"):
            found = locate_along_tree(
                triangulations[this], triangulations[other].nodes, ends[other]
            )
        with clock.stage("measures"):
            farthest = hausdorff(
                grids[other].nodes,
                grids[other].z,
                grids[this].nodes,
                grids[this].z,
                triangulations[this],
                found,
            )
        with clock.stage("interpolate"):
            limit = None if max_edge is None else max_edge * scale
            footprint = footprint_of(grids[this], triangulations[this], ends[this], domain, limit)
            faces = faces_of(grids[this], triangulations[this])
        return found, farthest, footprint, faces

    # merging needs none of the three, nor they it (the paper, after the stages)
    scaled, (around_1, around_2) = at_once(merge, lambda: (around(0, 1), around(1, 0)), threads)
    found_1, farthest_2, footprint_1, faces_1 = around_1
    found_2, farthest_1, footprint_2, faces_2 = around_2

    with clock.stage("interpolate", 0.7):
        nodes_1, nodes_2 = triangulations[0].nodes, triangulations[1].nodes
        sides = (
            Side(grids[0], footprint_1, scaled.node_1, scaled.node_2, nodes_2, found_1, faces_1),
            Side(grids[1], footprint_2, scaled.node_2, scaled.node_1, nodes_1, found_2, faces_2),
        )
        (z1, at_1), (z2, at_2) = both(
            lambda side: side.values(len(scaled.nodes), domain), *sides, threads
        )
        state_1, state_2 = at_once(
            lambda: sides[0].states(scaled, at_1, domain),
            lambda: sides[1].states(scaled, at_2, domain),
            threads,
        )

    with clock.stage("measures", 0.85):
        among_layers = [
            share_among_layers(t, grid.z * scale) if grid.faces is None else 0.0
            for t, grid in zip(triangulations, grids, strict=True)
        ]
        united, exact_triangulations = scaled, triangulations
        if scale != 1.0:
            united = replace(scaled, nodes=scaled.nodes / scale)
            triangulations = (
                replace(triangulations[0], nodes=grids[0].nodes),
                replace(triangulations[1], nodes=grids[1].nodes),
            )
        areas = triangle_areas(united.nodes, united.triangles)
        with keeping((surface_1, surface_2), options, view, motion):
            check_cover(scaled, *exact_triangulations, areas, threads)
        reason = reasons(state_1, state_2, areas)
        compared = reason == Reason.COMPARED
        if not compared.any():
            limits = footprint_1.max_edge / scale, footprint_2.max_edge / scale
            raise InputError(nothing_common(*placed, limits, derived=max_edge is None))
        node_weight = None
        if weight is not None:
            node_weight = weight_at(weight, united.nodes)
        linear = both(lambda side: side.linear(domain), *sides, threads)
        covered = [
            side.covered(domain, one, scaled, areas, compared, threads)
            for side, one in zip(sides, linear, strict=True)
        ]
        values, measures = measure(
            united.nodes,
            united.label,
            united.triangles,
            z1,
            z2,
            compared,
            tolerances=tolerances,
            node_weight=node_weight,
            footprint_1=covered[0],
            footprint_2=covered[1],
            hausdorff=(farthest_1, farthest_2),
            threads=threads,
        )
        faces = both(Side.mesh_faces, *sides, threads)
        exact_values = None
        if exact:
            exact_values, exact_measures = measure_exactly(
                linear[0],
                linear[1],
                scaled,
                length=1.0 / scale,
                tolerances=tolerances,
                node_weight=node_weight,
                continued=domain == "plane",
                hausdorff=(farthest_1, farthest_2),
                threads=threads,
                progress=lambda share: progress("exact measures", 0.9 + 0.1 * share),
            )
            measures = replace(measures, exact=exact_measures)
    result = Comparison(
        (surface_1, surface_2),
        grids,
        triangulations,
        united,
        z1,
        z2,
        node_weight,
        reason,
        values.area,
        values.mean_abs,
        values.mean_signed,
        measures,
        options,
        motion,
        (footprint_1.max_edge / scale, footprint_2.max_edge / scale),
        None if exact_values is None else exact_values.mean_abs,
        None if exact_values is None else exact_values.mean_signed,
        view,
        clock.seconds(),
        (*together.warnings, *cautions(placed, among_layers, faces)),
        (covered[0], covered[1]),
        (faces[0], faces[1]),
    )
    with keeping((surface_1, surface_2), options, view, motion):
        for found in filter(None, (measures, measures.exact)):
            check_measures(found)
        if verify:
            progress("verify", 0.9)
            check_united(scaled, *exact_triangulations)
            check_values(result)
            check_sums(result)
            other = compare(
                placed[1],
                placed[0],
                domain=domain,
                max_edge=max_edge,
                exact=exact,
                tolerances=tolerances,
                weight=weight,
                duplicates=duplicates,
                threads=threads,
            )
            check_exchange(measures, other.measures)
    progress("done", 1.0)
    return result
